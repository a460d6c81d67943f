// SPDX-License-Identifier: MIT
//
// The Voronoi points of a diagram that changes, drawn as markers.

import type { DiagramData } from 'geodesic-voronoi';
import { labelsAround } from '../buffers/diagram_summary.js';
import { Markers } from './markers.js';
import type { SceneMesh } from '../buffers/scene_mesh.js';

type Points = Pick<DiagramData, 'points' | 'voronoiPoints'>;

/** Numbers per marker: its place and its outward direction. */
const width = 6;

export class VoronoiPointMarkers {
  readonly markers = new Markers({ least: 1.5, most: 4.5 });
  readonly #mesh: SceneMesh;
  /** The points of a whole diagram, until they are first needed. */
  #pending: Points | undefined;
  #records: Float32Array = new Float32Array();
  /** The labels around each. */
  #labels: readonly Int32Array[] = [];
  #size = 0;
  #isDrawn = true;

  constructor(mesh: SceneMesh) {
    this.#mesh = mesh;
  }

  set visible(visible: boolean) {
    this.markers.object.visible = visible;
    if (visible) this.#draw();
  }

  /** Sets the points of a diagram, and the radius of their markers in the scene. */
  set(part: Points | undefined, size: number): void {
    this.#pending = part;
    this.#records = new Float32Array();
    this.#labels = [];
    this.#adopt(size);
  }

  /** Replaces the points of the marked labels, which are few. */
  replace(isChanged: Uint8Array, part: Points, size: number): void {
    this.#read();
    const kept: number[] = [];
    this.#labels.forEach((around, i) => {
      if (!around.some((label) => isChanged[label] > 0)) kept.push(i);
    });
    const added = this.#recordsOf(part);
    const all = new Float32Array(width * kept.length + added.length);
    kept.forEach((from, to) => all.set(record(this.#records, from), width * to));
    all.set(added, width * kept.length);
    this.#records = all;
    this.#labels = [...kept.map((i) => this.#labels[i]), ...labelsAround(part)];
    this.#adopt(size);
  }

  #read(): void {
    if (!this.#pending) return;
    this.#records = this.#recordsOf(this.#pending);
    this.#labels = labelsAround(this.#pending);
    this.#pending = undefined;
  }

  #recordsOf({ points, voronoiPoints }: Points): Float32Array {
    const { point } = voronoiPoints;
    const records = new Float32Array(width * point.length);
    const places = this.#mesh.frame.namedToScene(points.position, point);
    const bary = [0, 0, 0];
    point.forEach((p, i) => {
      for (let k = 0; k < 3; ++k) {
        records[width * i + k] = places[3 * i + k];
        bary[k] = points.bary[3 * p + k];
      }
      this.#mesh.writeNormal(points.face[p], bary, records, width * i + 3);
    });
    return records;
  }

  #adopt(size: number): void {
    this.#size = size;
    this.#isDrawn = false;
    if (this.markers.object.visible) this.#draw();
  }

  /**
   * Draws points ordered by coordinates, so that the same one of an overlap always stays on top.
   */
  #draw(): void {
    if (this.#isDrawn) return;
    this.#isDrawn = true;
    this.#read();
    const records = this.#records;
    const order = Array.from({ length: records.length / width }, (_, i) => i);
    const difference = (i: number, j: number, axis: number) =>
      records[width * i + axis] - records[width * j + axis];
    order.sort((i, j) => difference(i, j, 0) || difference(i, j, 1) || difference(i, j, 2));
    const places = new Float32Array(3 * order.length);
    const outward = new Float32Array(3 * order.length);
    order.forEach((from, to) => {
      const numbers = record(records, from);
      places.set(numbers.subarray(0, 3), 3 * to);
      outward.set(numbers.subarray(3), 3 * to);
    });
    this.markers.usual = this.#size;
    this.markers.set(places, outward, this.#size);
  }
}

function record(records: Float32Array, i: number): Float32Array {
  return records.subarray(width * i, width * i + width);
}
