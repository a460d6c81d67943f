// SPDX-License-Identifier: MIT
//
// What is computed from a diagram that may be replaced meanwhile.

import type { Diagram } from 'geodesic-voronoi';
import type { ShownDiagram } from './shown_diagram.js';

/** Something that is computed from the diagram that is shown, as long as it is wanted. */
export class Derived<Result> {
  readonly #compute: (diagram: Diagram) => Promise<Result | undefined>;
  readonly #adopt: (result: Result | undefined) => void;
  #shown: ShownDiagram | undefined;

  /** `adopt` gets what the latest diagram gives; undefined when there is none, or it fails. */
  constructor(
    compute: (diagram: Diagram) => Promise<Result | undefined>,
    adopt: (result: Result | undefined) => void,
  ) {
    this.#compute = compute;
    this.#adopt = adopt;
  }

  /** What is shown now, and again whenever that has changed; undefined also if nothing is wanted. */
  async update(shown: ShownDiagram | undefined): Promise<void> {
    if (shown === this.#shown) return;
    this.#shown = shown;
    // A diagram may be replaced while it is asked; then the answer for the next one follows.
    const result = shown?.diagram && (await this.#compute(shown.diagram).catch(() => undefined));
    if (shown === this.#shown) this.#adopt(result);
  }
}
