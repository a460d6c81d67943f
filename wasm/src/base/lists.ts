// SPDX-License-Identifier: MIT

import type { PointLists } from '../api/results.js';

/** One of the lists of a list of lists. */
export function listAt({ offset, points }: PointLists, i: number): Int32Array<ArrayBuffer> {
  return points.subarray(offset[i], offset[i + 1]);
}
