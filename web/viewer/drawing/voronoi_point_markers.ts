// SPDX-License-Identifier: MIT
//
// The Voronoi points of a diagram that changes, drawn as markers.

import type { DiagramData } from 'geodesic-voronoi';
import { labelsAround } from '../buffers/diagram_summary.js';
import { Markers } from './markers.js';
import type { SceneMesh } from '../buffers/scene_mesh.js';

type Points = Pick<DiagramData, 'points' | 'voronoiPoints'>;

/** A Voronoi point in the scene. */
interface ScenePoint {
  place: Float32Array;
  outward: Float32Array;
  /** The labels around it. */
  labels: Int32Array;
}

export class VoronoiPointMarkers {
  readonly markers = new Markers({ least: 1.5, most: 4.5 });
  readonly #mesh: SceneMesh;
  /** The points of a whole diagram, until they are first needed. */
  #pending: Points | undefined;
  #points: readonly ScenePoint[] = [];
  #size = 0;

  constructor(mesh: SceneMesh) {
    this.#mesh = mesh;
  }

  set visible(visible: boolean) {
    const wasVisible = this.markers.object.visible;
    this.markers.object.visible = visible;
    if (!wasVisible) this.#draw();
  }

  /** Sets the points of a diagram, and the radius of their markers in the scene. */
  set(part: Points | undefined, size: number): void {
    this.#pending = part;
    this.#points = [];
    this.#size = size;
    this.#draw();
  }

  /** Replaces the points of the marked labels, which are few. */
  replace(isChanged: Uint8Array, part: Points, size: number): void {
    const kept = this.#read().filter(({ labels }) => !labels.some((label) => isChanged[label] > 0));
    this.#points = [...kept, ...this.#pointsOf(part)];
    this.#size = size;
    this.#draw();
  }

  #read(): readonly ScenePoint[] {
    if (this.#pending) this.#points = this.#pointsOf(this.#pending);
    this.#pending = undefined;
    return this.#points;
  }

  #pointsOf(part: Points): ScenePoint[] {
    const { face, bary, position } = part.points;
    const { point } = part.voronoiPoints;
    const places = this.#mesh.frame.toScene(position, point);
    const outwards = new Float32Array(places.length);
    return labelsAround(part).map((labels, i) => {
      const at = 3 * point[i];
      this.#mesh.writeNormal(face[point[i]], bary.subarray(at, at + 3), outwards, 3 * i);
      const triple = (values: Float32Array) => values.subarray(3 * i, 3 * i + 3);
      return { place: triple(places), outward: triple(outwards), labels };
    });
  }

  /**
   * Draws points ordered by coordinates, so that the same one of an overlap always stays on top;
   * nothing while they are hidden.
   */
  #draw(): void {
    if (!this.markers.object.visible) return;
    const points = [...this.#read()].sort(
      ({ place: a }, { place: b }) => a[0] - b[0] || a[1] - b[1] || a[2] - b[2],
    );
    const places = new Float32Array(3 * points.length);
    const outwards = new Float32Array(3 * points.length);
    points.forEach(({ place, outward }, i) => {
      places.set(place, 3 * i);
      outwards.set(outward, 3 * i);
    });
    this.markers.usual = this.#size;
    this.markers.set(places, outwards, this.#size);
  }
}
