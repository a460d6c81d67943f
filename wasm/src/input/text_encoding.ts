// SPDX-License-Identifier: MIT
//
// Text files are read as UTF-8. Windows PowerShell writes what a command prints as UTF-16, with a
// mark at its beginning; read as UTF-8, the digits of a number would be numbers of their own.

import { invalidFile } from '../api/errors.js';

/** Throws if a file begins with the mark of UTF-16, of either byte order. */
export function requireNoUtf16(bytes: Uint8Array): void {
  const [first, second] = bytes;
  const isMarked = (first === 0xff && second === 0xfe) || (first === 0xfe && second === 0xff);
  if (isMarked) throw invalidFile('the file is UTF-16 text: save it as UTF-8');
}
