// SPDX-License-Identifier: MIT
//
// Lists that the command reads: points and numbers.
import { parseJson } from '../input/json_members.js';
import { toSizeLimits } from '../input/limits.js';
import { readPlyPlaces } from '../input/ply_reader.js';
import { type PointsFile, pointsFile } from '../points_file.js';
import { inSlices } from '../slices.js';
import { readCsvPlaces } from '../input/csv_places.js';
import { exists, FileError, readBytes } from './files.js';
import { standard } from './options.js';

/** The bytes of a file, or of JSON itself: no file is called `{…` or `[…`. */
async function bytesOf(given: string): Promise<Uint8Array> {
  return isJson(given) ? new TextEncoder().encode(given) : readBytes(given);
}

function jsonOf(bytes: Uint8Array, name: string): unknown {
  try {
    return parseJson(bytes);
  } catch (error) {
    const what = error instanceof SyntaxError ? 'is not JSON' : 'cannot be read';
    throw new FileError(`${name} ${what}: ${(error as Error).message}`);
  }
}

/** Reads a list of numbers. */
export async function readNumbers(given: string): Promise<number[]> {
  const json = jsonOf(await bytesOf(given), nameOf(given));
  if (Array.isArray(json) && json.every((item) => typeof item === 'number')) return json;
  throw new FileError(`${nameOf(given)} holds no list of numbers`);
}

/** Points as they were given, with the name that messages call them. */
export type GivenPoints = PointsFile & { name: string };

/**
 * Reads a list of sites or points: of JSON, also of a result; or places, of a PLY or a table. The
 * content tells which: pipes have no names that could.
 */
export async function readPoints(given: string): Promise<GivenPoints> {
  if (/^\d+$/.test(given) && !(await exists(given)))
    throw new FileError(`there is no file ${given}; a vertex is given as '{"vertex": ${given}}'`);
  const name = nameOf(given);
  try {
    const bytes = await bytesOf(given);
    const head = new TextDecoder().decode(bytes.subarray(0, headBytes));
    if (head.trim() === '') throw new Error('the file is empty');
    if (isJson(head)) return { name, ...pointsFile(jsonOf(bytes, name)) };
    const places = /^ply\s/.test(head)
      ? await inSlices(readPlyPlaces(bytes, toSizeLimits({})), {})
      : readCsvPlaces(bytes);
    return { name, points: { position: places } };
  } catch (error) {
    if (error instanceof FileError) throw error;
    throw new FileError(`${name}: ${(error as Error).message}`, { cause: error });
  }
}

/** Enough to find the first letter. */
const headBytes = 2 ** 10;

function isJson(given: string): boolean {
  return /^\s*[[{]/.test(given);
}

function nameOf(given: string): string {
  if (given === standard) return 'standard input';
  return isJson(given) && given.length > 40 ? `${given.slice(0, 40)}…` : given;
}
