// SPDX-License-Identifier: MIT
//
// Files of points: JSON, also of a result; or places, in a PLY or a table.

import { inSlices } from '../base/slices.js';
import { readCsvPlaces } from './csv_places.js';
import { parseJson } from './json_members.js';
import { toSizeLimits } from './limits.js';
import { readPlyPlaces } from './ply_reader.js';
import { requireNoUtf16 } from './text_encoding.js';

/** Enough to find the first letter. */
const headBytes = 2 ** 10;

/**
 * The content of a file of points as `pointsFile` takes it: JSON, parsed, or the places in another
 * file. The content tells which it is: pipes have no names that could.
 */
export async function readPointsFile(bytes: Uint8Array): Promise<unknown> {
  requireNoUtf16(bytes);
  const head = new TextDecoder().decode(bytes.subarray(0, headBytes));
  if (head.trim() === '') throw new Error('the file is empty');
  if (isJson(head)) return readJson(bytes);
  const isPly = /^ply\s/.test(head);
  if (!isPly && head.includes('\0'))
    throw new Error('it is not text, and of binary files only a PLY can have points');
  const places = isPly ? readPlyPlaces(bytes, toSizeLimits({})) : readCsvPlaces(bytes);
  const position = await inSlices<ArrayLike<number>>(places, {});
  if (position.length === 0) throw new Error('it has no points');
  return { position };
}

/** Whether a text begins as a list or an object of JSON. */
export function isJson(text: string): boolean {
  return /^\s*[[{]/.test(text);
}

export function readJson(bytes: Uint8Array): unknown {
  try {
    return parseJson(bytes);
  } catch (cause) {
    if (!(cause instanceof SyntaxError)) throw cause;
    throw new Error(`it is no JSON that can be read: ${cause.message}`, { cause });
  }
}
