// SPDX-License-Identifier: MIT
//
// A result computed from what is shown, which may be replaced in the meantime.

import { isAbandoned } from '../session/failure.js';

/** What to do for a result, and with it. */
interface DerivedUse<Source, Result> {
  compute(source: Source, signal: AbortSignal): Promise<Result | undefined>;
  /** Gets the latest source's result; undefined without one, or with an error after a failure. */
  adopt(result: Result | undefined, error?: unknown): void;
  /** Frees a result that nobody wants any more when it is there. */
  discard?(result: Result): void;
}

/** A result computed from a source that is shown (a diagram, a model), as long as it is wanted. */
export class Derived<Source extends object, Result> {
  readonly #use: DerivedUse<Source, Result>;
  #source: Source | undefined;
  /** Of the last update; aborted if its result is to be computed again. */
  #latest = new AbortController();

  constructor(use: DerivedUse<Source, Result>) {
    this.#use = use;
  }

  /** To be called with the source that is shown; with undefined if no result is wanted. */
  async update(source: Source | undefined): Promise<void> {
    if (source === this.#source && !(source && this.#latest.signal.aborted)) return;
    this.stop();
    this.#source = source;
    this.#latest = new AbortController();
    const { signal } = this.#latest;
    let result: Result | undefined;
    let failure: unknown;
    try {
      result = source && (await this.#use.compute(source, signal));
    } catch (error) {
      if (!isAbandoned(error, signal)) failure = error;
    }
    if (!signal.aborted) this.#use.adopt(result, failure);
    else if (result) this.#use.discard?.(result);
  }

  /** Gives up a result that is under way. One that has been adopted stays until the next update. */
  stop(): void {
    this.#latest.abort();
  }
}
