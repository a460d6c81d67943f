// SPDX-License-Identifier: MIT
//
// A result computed from a diagram, which may be replaced in the meantime.

import type { Diagram } from 'geodesic-voronoi';
import type { ShownDiagram } from './shown_diagram.js';

/** A result computed from the diagram that is shown, as long as it is wanted. */
export class Derived<Result> {
  readonly #compute: (diagram: Diagram) => Promise<Result | undefined>;
  readonly #adopt: (result: Result | undefined) => void;
  #shown: ShownDiagram | undefined;

  /** `adopt` gets the latest diagram's result; undefined without a diagram or after a failure. */
  constructor(
    compute: (diagram: Diagram) => Promise<Result | undefined>,
    adopt: (result: Result | undefined) => void,
  ) {
    this.#compute = compute;
    this.#adopt = adopt;
  }

  /** To be called with each new shown diagram; with undefined if no result is wanted. */
  async update(shown: ShownDiagram | undefined): Promise<void> {
    if (shown === this.#shown) return;
    this.#shown = shown;
    // A diagram may be replaced during the computation; the result of the next one follows then.
    const result = shown?.diagram && (await this.#compute(shown.diagram).catch(() => undefined));
    if (shown === this.#shown) this.#adopt(result);
  }
}
