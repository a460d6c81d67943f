// SPDX-License-Identifier: MIT
//
// Long work on the calling thread, in slices: between them the thread serves others, progress is
// reported, and the caller may abort.

import { outOfMemory } from '../api/errors.js';
import type { TaskOptions } from '../api/options.js';

/** How long a slice of work may keep its thread from anything else: less than one of 60 frames per second. */
const sliceMilliseconds = 12;

/** Work that can be interrupted: it yields the share done, 0 … 1, wherever it may pause. */
export type SlicedWork<Result> = Generator<number, Result>;

/** The options of a part of a task, which reports its progress as the task's between two shares. */
export function partOf({ signal, onProgress }: TaskOptions, from: number, to: number): TaskOptions {
  return { signal, onProgress: onProgress && ((share) => onProgress(from + (to - from) * share)) };
}

export async function inSlices<Result>(
  work: SlicedWork<Result>,
  { signal, onProgress }: TaskOptions,
): Promise<Result> {
  signal?.throwIfAborted();
  for (;;) {
    const end = performance.now() + sliceMilliseconds;
    let next = stepOf(work);
    while (!next.done && performance.now() < end) next = stepOf(work);
    if (next.done) return next.value;
    onProgress?.(next.value);
    await nextTask();
    signal?.throwIfAborted();
  }
}

/** A step of work. An array that is too long for the memory there is throws a `RangeError`. */
function stepOf<Result>(work: SlicedWork<Result>): IteratorResult<number, Result> {
  try {
    return work.next();
  } catch (cause) {
    throw cause instanceof RangeError ? outOfMemory(cause) : cause;
  }
}

/** Lets other tasks of this thread run. Not by a timer: browsers slow timers down. */
function nextTask(): Promise<void> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(undefined);
  });
}
