// SPDX-License-Identifier: MIT
//
// The edges of the model's triangles, found while the layer is shown.

import type { DrawingPlace } from './derived_drawings.js';
import { meshEdges } from '../buffers/mesh_edges.js';
import type { OpenModel } from '../model/open_model.js';

export class WireframeLayer {
  readonly #place: DrawingPlace;
  /** The model whose edges have been asked for, if it is the present one. */
  #model: OpenModel | undefined;

  constructor(place: DrawingPlace) {
    this.#place = place;
  }

  /** Finds the edges if the attributes ask for them. */
  async update(): Promise<void> {
    const { attributes, model, stage } = this.#place;
    if (model === this.#model) return;
    this.#model = attributes.layers.includes('wireframe') ? model : undefined;
    if (!model || !this.#model) return;
    const edges = await model.builder.edges();
    if (model !== this.#place.model) return;
    model.drawing.setEdges(edges ?? meshEdges(model.drawing.mesh.indices));
    stage.invalidate();
  }
}
