// SPDX-License-Identifier: MIT
//
// The room in the buffers of a `RecordBuffer`. In a file of its own, because workers need no
// three.js.

/** How much larger than needed a buffer of records is made. */
const slack = 1.25;

/** The number of records that a buffer made for `count` records has room for. */
export function roomFor(count: number): number {
  return Math.ceil(slack * count);
}
