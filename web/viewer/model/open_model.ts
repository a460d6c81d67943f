// SPDX-License-Identifier: MIT
//
// The model that is open, with all that the viewer has of it.

import type { DiagramData, Mesh } from 'geodesic-voronoi';
import { type Camera, Vector3 } from 'three';
import { DensityPaint } from './density_paint.js';
import type { PreparedDiagram } from '../buffers/diagram_geometry.js';
import { DiagramSummary } from '../buffers/diagram_summary.js';
import type { DrawingBuilder } from '../buffers/drawing_builder.js';
import { rootDensityIntegral } from '../session/hexagon_energy.js';
import type { OpenedMesh } from '../session/mesh_opening.js';
import { ModelDrawing } from '../drawing/model_drawing.js';
import type { NamedFiles } from '../session/model_files.js';
import { Picker } from './picking.js';
import type { Sites } from '../session/site_history.js';
import type { Stage } from '../stage/stage.js';
import type { Theme } from '../drawing/theme.js';

/** The viewer's data of an open model: its drawing and everything that the tools need. */
export class OpenModel {
  readonly drawing: ModelDrawing;
  readonly picker: Picker;
  readonly paint: DensityPaint;
  readonly builder: DrawingBuilder;
  readonly files: NamedFiles;
  readonly #mesh: Mesh;
  #density: { perVertex: Float64Array; rootIntegral: number } | undefined;

  constructor({ mesh, scene, builder, files }: OpenedMesh, theme: Theme) {
    this.#mesh = mesh;
    this.files = files;
    this.builder = builder;
    this.drawing = new ModelDrawing(scene);
    this.drawing.theme = theme;
    const { boundaryLoops, components, repairs } = mesh.info;
    // Only of a closed surface in one piece, with no triangle turned over, is the inside certainly never seen.
    if (boundaryLoops === 0 && components === 1 && repairs.flippedTriangles === 0)
      this.drawing.front = Math.sign(scene.sixfoldVolume);
    this.picker = new Picker(scene, builder.ask('tree'));
    this.paint = new DensityPaint(scene);
  }

  /** The density ρ per input vertex when painting last came to rest, and ∫ √ρ; undefined if ρ is 1 everywhere. */
  get density(): { perVertex: Float64Array; rootIntegral: number } | undefined {
    return this.#density;
  }

  /** Makes what is painted the density, and draws it. */
  adoptPaint(): void {
    const perVertex = this.paint.density;
    this.#density = perVertex && {
      perVertex,
      rootIntegral: rootDensityIntegral(this.#mesh, perVertex),
    };
    this.drawing.setTints(this.paint.tints);
  }

  /** Prepares a diagram for drawing: part of it in the worker, the rest here at the same time. */
  async prepare(data: DiagramData, sites: Sites): Promise<PreparedDiagram> {
    const { cells, points, segments } = data;
    // Only the arrays that are needed are copied to the worker.
    const geometry = this.builder.ask('diagram', {
      cells,
      points: { position: points.position },
      segments: { face: segments.face, points: segments.points },
    });
    const summary = DiagramSummary.of(data);
    const tones = this.drawing.assignTones(summary, sites);
    return { summary, tones, geometry: await geometry };
  }

  /** Whether a site is behind the surface, or on the far side of a wall however thin. */
  hidesSite(index: number, camera: Camera): boolean {
    const { drawing, picker } = this;
    return (
      drawing.sites.isTurnedAway(index, camera) || picker.hides(drawing.sites.place(index), camera)
    );
  }

  /** See `GeodesicVoronoiElement.project`. */
  project(positions: ArrayLike<number>, stage: Stage): ({ x: number; y: number } | undefined)[] {
    const places = this.drawing.mesh.frame.toScene(positions);
    const toView = stage.projection(stage.toView);
    return Array.from({ length: places.length / 3 }, (_, i) => {
      const place = new Vector3().fromArray(places, 3 * i);
      const seen = toView(place);
      return seen && !this.picker.hides(place, stage.camera.object) ? seen : undefined;
    });
  }

  dispose(): void {
    this.drawing.dispose();
    this.builder.dispose();
  }
}
