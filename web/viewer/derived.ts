// SPDX-License-Identifier: MIT
import type { Diagram } from 'geodesic-voronoi';

/** Something that is computed from the diagram that is shown, as long as it is wanted. */
export class Derived<Result> {
  readonly #compute: (diagram: Diagram) => Promise<Result>;
  readonly #adopt: (result: Result | undefined) => void;
  #diagram: Diagram | undefined;

  /** `adopt` gets what the latest diagram gives; undefined when there is none, or it fails. */
  constructor(
    compute: (diagram: Diagram) => Promise<Result>,
    adopt: (result: Result | undefined) => void,
  ) {
    this.#compute = compute;
    this.#adopt = adopt;
  }

  /** The diagram there is now; undefined also if nothing is wanted. */
  async update(diagram: Diagram | undefined): Promise<void> {
    if (diagram === this.#diagram) return;
    this.#diagram = diagram;
    // A diagram may be replaced while it is asked; then the answer for the next one follows.
    const result = diagram && (await this.#compute(diagram).catch(() => undefined));
    if (diagram === this.#diagram) this.#adopt(result);
  }
}
