// SPDX-License-Identifier: MIT
//
// The room in the buffers of a `RecordBuffer`. In a file of its own, because workers need no
// three.js.

/** The factor by which a buffer of records is larger than needed. */
const slack = 1.25;

/** The number of records that a buffer made for `count` records has room for. */
export function roomFor(count: number): number {
  return Math.ceil(slack * count);
}
