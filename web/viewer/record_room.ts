// SPDX-License-Identifier: MIT
//
// How much room there is in the buffers of `RecordBuffer`: apart from it, for workers need no three.js.

/** How much larger than needed a buffer of records is made. */
const slack = 1.25;

/** For how many records there is room in a buffer that is made for so many. */
export function roomFor(count: number): number {
  return Math.ceil(slack * count);
}
