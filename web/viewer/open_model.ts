// SPDX-License-Identifier: MIT
import type { Mesh } from 'geodesic-voronoi';
import { CellBuilder } from './cell_builder.js';
import { DensityPaint } from './density_paint.js';
import { ModelDrawing } from './model_drawing.js';
import { Picker } from './picking.js';
import { SceneMesh } from './scene_mesh.js';

/** What the viewer has of every model that it opens: its drawing and what the tools need. */
export class OpenModel {
  readonly drawing: ModelDrawing;
  readonly picker: Picker;
  readonly paint: DensityPaint;
  readonly cells: CellBuilder;

  constructor(model: Mesh) {
    const mesh = new SceneMesh(model);
    this.drawing = new ModelDrawing(mesh);
    this.picker = new Picker(mesh);
    this.paint = new DensityPaint(mesh);
    this.cells = new CellBuilder(model);
  }

  dispose(): void {
    this.drawing.dispose();
    this.cells.dispose();
  }
}
