// SPDX-License-Identifier: MIT
//
// A result computed from a diagram, which may be replaced in the meantime.

import type { Diagram } from 'geodesic-voronoi';
import { isAbandoned } from '../session/failure.js';
import type { ShownDiagram } from '../session/shown_diagram.js';

/** What to do with a result, and with a failure. */
interface DerivedUse<Result> {
  compute(diagram: Diagram, signal: AbortSignal): Promise<Result | undefined>;
  /** Gets the latest diagram's result; undefined without a diagram or after a failure. */
  adopt(result: Result | undefined): void;
  failed(error: unknown): void;
}

/** A result computed from the diagram that is shown, as long as it is wanted. */
export class Derived<Result> {
  readonly #use: DerivedUse<Result>;
  #shown: ShownDiagram | undefined;
  /** Of the last update; aborted if its result is to be computed again. */
  #latest = new AbortController();

  constructor(use: DerivedUse<Result>) {
    this.#use = use;
  }

  /** To be called with the shown diagram; with undefined if no result is wanted. */
  async update(shown: ShownDiagram | undefined): Promise<void> {
    if (shown === this.#shown && !(shown && this.#latest.signal.aborted)) return;
    this.stop();
    this.#shown = shown;
    this.#latest = new AbortController();
    const { signal } = this.#latest;
    let result: Result | undefined;
    try {
      result = shown?.diagram && (await this.#use.compute(shown.diagram, signal));
    } catch (error) {
      if (!isAbandoned(error, signal)) this.#use.failed(error);
    }
    if (!signal.aborted) this.#use.adopt(result);
  }

  /** Gives up a result that is under way. One that has been adopted stays until the next update. */
  stop(): void {
    this.#latest.abort();
  }
}
