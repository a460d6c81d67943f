// SPDX-License-Identifier: MIT
//
// A typed array that grows at its end: numbers of a file whose count is known only when it is read.

export class GrowingArray<Numbers extends Float64Array | Int32Array> {
  #numbers: Numbers;
  #length = 0;

  /** It grows beyond the capacity, too, at the price of a copy. */
  constructor(type: new (length: number) => Numbers, capacity = 1024) {
    this.#numbers = new type(Math.max(1, capacity));
  }

  get length(): number {
    return this.#length;
  }

  push(number: number): void {
    if (this.#length === this.#numbers.length) {
      const Type = this.#numbers.constructor as new (length: number) => Numbers;
      const larger = new Type(2 * this.#length);
      larger.set(this.#numbers);
      this.#numbers = larger;
    }
    this.#numbers[this.#length++] = number;
  }

  /** A copy of what there is. */
  toArray(): Numbers {
    return this.#numbers.slice(0, this.#length) as Numbers;
  }
}
