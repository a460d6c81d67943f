// SPDX-License-Identifier: MIT
//
// Tables of numbers.

import { textOf } from './text.js';

/** A line of names, then one of numbers for each row; nothing for what is not finite. */
export function csv(columns: { [name: string]: ArrayLike<number> }): string {
  const lists = Object.values(columns);
  const cell = (x: number) => (Number.isFinite(x) ? String(x) : '');
  const rows = Array.from(lists[0], (_, i) => lists.map((list) => cell(list[i])).join(','));
  return textOf(() => `${[Object.keys(columns).join(','), ...rows].join('\n')}\n`);
}

/** The numbers at one place in each group of `size`. */
export function column(values: Float64Array, size: number, at: number): Float64Array {
  return Float64Array.from({ length: values.length / size }, (_, i) => values[size * i + at]);
}
