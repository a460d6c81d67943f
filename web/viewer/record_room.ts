// SPDX-License-Identifier: MIT

/** How much larger than needed a buffer of records is made. */
const slack = 1.25;

/** For how many records there is room in a buffer that is made for so many. */
export function roomFor(count: number): number {
  return Math.ceil(slack * count);
}
