// SPDX-License-Identifier: MIT
//
// Animates places on their way to new ones.

/**
 * Places (x, y, z triples) that glide from their old to their new position, because the eye loses
 * things that jump.
 */
export class Glide {
  #from: Float32Array = new Float32Array();
  #to: Float32Array = new Float32Array();
  #start = 0;
  #milliseconds = 0;

  /** Starts from where places are seen now; without delay if their number has changed. */
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

  /** The places as they are seen at a time. */
  at(now: number): Float32Array {
    if (this.isOver(now)) return this.#to;
    const share = Math.max(0, (now - this.#start) / this.#milliseconds);
    // Slow at both ends.
    const eased = share * share * (3 - 2 * share);
    return this.#to.map((to, i) => this.#from[i] + eased * (to - this.#from[i]));
  }
}
