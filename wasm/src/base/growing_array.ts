// SPDX-License-Identifier: MIT
//
// A typed array that grows at its end, for numbers whose count is unknown, or known only from a
// file's promise. It grows chunk by chunk, because copying it would block the thread and take twice
// its memory.

import type { SlicedWork } from './slices.js';

type Numbers = Float64Array | Int32Array;

const chunkLength = 2 ** 16;

export class GrowingArray<Array extends Numbers> {
  readonly #type: new (
    length: number,
  ) => Array;
  #chunks: Array[];
  #last: Array;
  /** How many numbers are in the last chunk, and in those before it. */
  #inLast = 0;
  #inOthers = 0;

  /** If it comes to just as many as expected, they are never copied. */
  constructor(type: new (length: number) => Array, expected = 0) {
    this.#type = type;
    this.#chunks = [(this.#last = new type(expected))];
  }

  get length(): number {
    return this.#inOthers + this.#inLast;
  }

  push(number: number): void {
    if (this.#inLast === this.#last.length) {
      this.#chunks.push((this.#last = new this.#type(chunkLength)));
      this.#inOthers += this.#inLast;
      this.#inLast = 0;
    }
    this.#last[this.#inLast++] = number;
  }

  /** Gives up what there is, as one array. */
  toArray(): Array {
    const work = this.take();
    let next = work.next();
    while (!next.done) next = work.next();
    return next.value;
  }

  /** Like `toArray`, but in steps: yields between chunks. */
  *take(): SlicedWork<Array> {
    const chunks = this.#chunks;
    const { length } = this;
    this.#chunks = [(this.#last = new this.#type(0))];
    this.#inLast = this.#inOthers = 0;
    if (chunks[0].length === length) return chunks[0];
    const all = new this.#type(length);
    for (let at = 0; at < length; ) {
      const chunk = chunks.shift()!; // none is kept once it is copied
      yield* copyTo<Numbers>(all, at, chunk.subarray(0, length - at));
      at += chunk.length;
    }
    return all;
  }
}

/** Numbers that are copied between two looks at the clock. */
const numbersPerStep = 2 ** 16;

/** Copies numbers to a place of another array, in steps. */
export function* copyTo<Array extends Numbers | Uint8Array>(
  target: Array,
  at: number,
  source: Array,
): SlicedWork<void> {
  for (let from = 0; from < source.length; from += numbersPerStep) {
    target.set(source.subarray(from, from + numbersPerStep), at + from);
    yield from / source.length;
  }
}
