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

/** During a test, has lines together be longer than a string may be. */
export function haveLinesTooLong(t) {
  const { join } = Array.prototype;
  t.after(() => {
    Array.prototype.join = join;
  });
  Array.prototype.join = function (separator) {
    if (separator === '\n') throw new RangeError('Invalid string length');
    return join.call(this, separator);
  };
}
