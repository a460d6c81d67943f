// SPDX-License-Identifier: MIT
//
// The model that is open, with all that the viewer has of it.

import { DensityPaint } from './density_paint.js';
import type { DrawingBuilder } from './drawing_builder.js';
import type { OpenedMesh } from './mesh_opening.js';
import { ModelDrawing } from './model_drawing.js';
import type { NamedFiles } from './model_files.js';
import { Picker } from './picking.js';
import type { Theme } from './theme.js';

/** What the viewer has of every model that it opens: its drawing and what the tools need. */
export class OpenModel {
  readonly drawing: ModelDrawing;
  readonly picker: Picker;
  readonly paint: DensityPaint;
  readonly builder: DrawingBuilder;

  readonly files: NamedFiles;

  constructor({ scene, builder, files }: OpenedMesh, theme: Theme) {
    this.files = files;
    this.builder = builder;
    this.drawing = new ModelDrawing(scene);
    this.drawing.theme = theme;
    this.picker = new Picker(scene, builder.tree());
    this.paint = new DensityPaint(scene);
  }

  dispose(): void {
    this.drawing.dispose();
    this.builder.dispose();
  }
}
