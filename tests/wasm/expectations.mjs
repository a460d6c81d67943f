// SPDX-License-Identifier: MIT
//
// What tests expect of errors and numbers.

import assert from 'node:assert/strict';

/** An error of the library, as `assert.throws` and `assert.rejects` compare with. */
export const fails = (code, message = /./) => ({ name: 'GeodesicVoronoiError', code, message });

/** Two numbers differ by no more than the tolerance. */
export function near(actual, expected, tolerance = 1e-9, what = '') {
  assert.ok(Math.abs(actual - expected) <= tolerance, `${what} ${actual} is not ${expected}`);
}
