// SPDX-License-Identifier: MIT
//
// Texts of files, which may be longer than JavaScript can hold.

import { GeodesicVoronoiError } from '../api/errors.js';

/** The text that is made; one longer than a string may be, as half a gigabyte, is refused. */
export function textOf(make: () => string): string {
  try {
    return make();
  } catch (cause) {
    if (!(cause instanceof RangeError)) throw cause;
    throw new GeodesicVoronoiError(
      'out-of-memory',
      'the text would be longer than a string may be: binary formats have no such limit',
      { cause },
    );
  }
}
