// SPDX-License-Identifier: MIT
//
// Places that move to others within a time.

/**
 * Places (x, y, z triples) that are seen on their way from where they were to where they are: what jumps
 * is lost to the eye.
 */
export class Glide {
  #from: Float32Array = new Float32Array();
  #to: Float32Array = new Float32Array();
  #start = 0;
  #milliseconds = 0;

  /** They go there from where they are seen now; at once in no time, and if there are others than before. */
  to(places: Float32Array, milliseconds: number, now: number): void {
    const isSame = places.length === this.#to.length;
    this.#from = isSame ? this.at(now) : places;
    this.#to = places;
    this.#start = now;
    this.#milliseconds = isSame ? milliseconds : 0;
  }

  isOver(now: number): boolean {
    return now >= this.#start + this.#milliseconds;
  }

  /** Where they are seen. */
  at(now: number): Float32Array {
    if (this.isOver(now)) return this.#to;
    const share = Math.max(0, (now - this.#start) / this.#milliseconds);
    // Slow at both ends.
    const eased = share * share * (3 - 2 * share);
    return this.#to.map((to, i) => this.#from[i] + eased * (to - this.#from[i]));
  }
}
