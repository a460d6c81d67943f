// SPDX-License-Identifier: MIT
//
// A typed array that grows at its end: numbers whose count is known only when all are there. It grows
// chunk by chunk: one that is copied as it grows would take the thread, and twice its memory.

import type { SlicedWork } from '../slices.js';

type Numbers = Float64Array | Int32Array;

const chunkLength = 2 ** 16;

export class GrowingArray<Array extends Numbers> {
  readonly #type: new (
    length: number,
  ) => Array;
  #chunks: Array[] = [];
  #last: Array;
  #length = 0;

  constructor(type: new (length: number) => Array) {
    this.#type = type;
    this.#last = new type(0);
  }

  get length(): number {
    return this.#length;
  }

  push(number: number): void {
    const at = this.#length % chunkLength;
    if (at === 0) this.#chunks.push((this.#last = new this.#type(chunkLength)));
    this.#last[at] = number;
    ++this.#length;
  }

  /** Gives up what there is, as one array. */
  toArray(): Array {
    const work = this.take();
    let next = work.next();
    while (!next.done) next = work.next();
    return next.value;
  }

  /** The same, in steps: yields between chunks. */
  *take(): SlicedWork<Array> {
    const all = new this.#type(this.#length);
    for (const [i, chunk] of this.#chunks.entries()) {
      const start = i * chunkLength;
      all.set(chunk.subarray(0, this.#length - start), start);
      this.#chunks[i] = this.#last;
      yield 1;
    }
    this.#chunks = [];
    this.#length = 0;
    return all;
  }
}
