// SPDX-License-Identifier: MIT
//
// Lists that the command reads: points and numbers.
import { extname } from 'node:path';
import { parseJson } from '../input/json_members.js';
import { toSizeLimits } from '../input/limits.js';
import { readPlyPlaces } from '../input/ply_reader.js';
import { type PointsFile, pointsFile } from '../points_file.js';
import { inSlices } from '../slices.js';
import { readCsvPlaces } from './csv_places.js';
import { exists, FileError, readBytes } from './files.js';
import { standard } from './options.js';

/** A JSON file, or JSON itself: no file is called `{…` or `[…`. */
async function readJson(given: string): Promise<unknown> {
  const bytes = isJson(given) ? new TextEncoder().encode(given) : await readBytes(given);
  try {
    return parseJson(bytes);
  } catch (error) {
    const what = error instanceof SyntaxError ? 'is not JSON' : 'cannot be read';
    throw new FileError(`${nameOf(given)} ${what}: ${(error as Error).message}`);
  }
}

/** Reads a list of numbers. */
export async function readNumbers(given: string): Promise<number[]> {
  const json = await readJson(given);
  if (Array.isArray(json) && json.every((item) => typeof item === 'number')) return json;
  throw new FileError(`${nameOf(given)} holds no list of numbers`);
}

/** Points as they were given, with the name that messages call them. */
export type GivenPoints = PointsFile & { name: string };

/** Reads a list of sites or points: of JSON, also of a result; or places, of a PLY or a CSV. */
export async function readPoints(given: string): Promise<GivenPoints> {
  if (/^\d+$/.test(given) && !(await exists(given)))
    throw new FileError(`there is no file ${given}; a vertex is given as '{"vertex": ${given}}'`);
  const name = nameOf(given);
  const read = isJson(given) ? undefined : tables[extname(given).toLowerCase()];
  try {
    if (read) return { name, points: { position: await read(await readBytes(given)) } };
    return { name, ...pointsFile(await readJson(given)) };
  } catch (error) {
    if (error instanceof FileError) throw error;
    throw new FileError(`${name}: ${(error as Error).message}`, { cause: error });
  }
}

/** What reads places from files other than JSON, by their endings. */
const tables: Record<string, (bytes: Uint8Array) => Promise<ArrayLike<number>>> = {
  '.ply': (bytes) => inSlices(readPlyPlaces(bytes, toSizeLimits({})), {}),
  '.csv': async (bytes) => readCsvPlaces(bytes),
  '.xyz': async (bytes) => readCsvPlaces(bytes),
};

function isJson(given: string): boolean {
  return /^\s*[[{]/.test(given);
}

function nameOf(given: string): string {
  if (given === standard) return 'standard input';
  return isJson(given) && given.length > 40 ? `${given.slice(0, 40)}…` : given;
}
