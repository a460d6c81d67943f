// SPDX-License-Identifier: MIT
import { DensityPaint } from './density_paint.js';
import { DrawingBuilder } from './drawing_builder.js';
import type { OpenedMesh } from './mesh_opening.js';
import { ModelDrawing } from './model_drawing.js';
import type { NamedFiles } from './model_files.js';
import { Picker } from './picking.js';
import { SceneMesh } from './scene_mesh.js';
import type { Theme } from './theme.js';

/** What the viewer has of every model that it opens: its drawing and what the tools need. */
export class OpenModel {
  readonly drawing: ModelDrawing;
  readonly picker: Picker;
  readonly paint: DensityPaint;
  readonly builder: DrawingBuilder;

  readonly files: NamedFiles;

  constructor({ mesh: model, files }: Pick<OpenedMesh, 'mesh' | 'files'>, theme: Theme) {
    this.files = files;
    const mesh = new SceneMesh(model);
    this.drawing = new ModelDrawing(mesh);
    this.drawing.theme = theme;
    this.picker = new Picker(mesh);
    this.paint = new DensityPaint(mesh);
    this.builder = new DrawingBuilder(model);
  }

  dispose(): void {
    this.drawing.dispose();
    this.builder.dispose();
  }
}
