// SPDX-License-Identifier: MIT
//
// Long work on the thread that calls: in slices, between which the thread serves others, the caller hears of
// it and may give up.

import type { TaskOptions } from './types.js';

/** How long a slice of work may keep its thread from anything else. */
export const sliceMilliseconds = 12;

/** Work that can be left for a while: it yields the share that is done, 0 … 1, as often as it can be left. */
export type SlicedWork<Result> = Generator<number, Result>;

export async function inSlices<Result>(
  work: SlicedWork<Result>,
  { signal, onProgress }: TaskOptions,
): Promise<Result> {
  for (;;) {
    const end = performance.now() + sliceMilliseconds;
    let next = work.next();
    while (!next.done && performance.now() < end) next = work.next();
    if (next.done) return next.value;
    onProgress?.(next.value);
    await nextTask();
    signal?.throwIfAborted();
  }
}

/** Lets everything else that waits for this thread have its turn. Not a timer: those are slowed. */
export function nextTask(): Promise<void> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(undefined);
  });
}
