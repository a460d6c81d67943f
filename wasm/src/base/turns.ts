// SPDX-License-Identifier: MIT
//
// Calls about one object, which are carried out one after the other.

import type { TaskOptions } from '../api/options.js';

export class Turns {
  #last: Promise<unknown> = Promise.resolve();

  /** Does work when all that was asked for before is done. Until then, aborting ends the wait at once. */
  async take<Result>({ signal }: TaskOptions, work: () => Promise<Result>): Promise<Result> {
    signal?.throwIfAborted();
    const before = this.#last;
    const result = (signal ? unlessAborted(before, signal) : before).then(work);
    // Not the result itself, which would stay in memory.
    const settled = result.then(
      () => {},
      () => {},
    );
    this.#last = before.then(() => settled);
    return result;
  }
}

function unlessAborted(wait: Promise<unknown>, signal: AbortSignal): Promise<void> {
  return new Promise((resolve, reject) => {
    const abort = () => reject(signal.reason);
    signal.addEventListener('abort', abort);
    void wait.then(() => {
      signal.removeEventListener('abort', abort);
      resolve();
    });
  });
}
