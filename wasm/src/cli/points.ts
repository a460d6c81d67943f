// SPDX-License-Identifier: MIT
//
// Lists that the command reads: points and numbers.

import { show } from '../base/checks.js';
import type { Rule } from '../base/rules.js';
import { isJson, readJson, readPointsFile } from '../input/points_reader.js';
import { type PointsFile, pointsFile } from '../input/points_file.js';
import { requireNoUtf16 } from '../input/text_encoding.js';
import { exists, FileError, readBytes } from './files.js';
import { standard } from './options.js';

/** Reads a list of numbers, each of which the rule allows. */
export async function readNumbers(given: string, rule: Rule): Promise<number[]> {
  if (/^\d+(,\d+)*$/.test(given) && !(await exists(given)))
    throw new FileError(`there is no file ${given}; a list of numbers is given as '[${given}]'`);
  const list = await readAs(given, async (bytes) => listIn(bytes));
  if (!Array.isArray(list)) throw new FileError(`${nameOf(given)} holds no list of numbers`);
  const wrong = list.findIndex((item) => !rule.allows(item));
  if (wrong < 0) return list;
  throw new FileError(
    `${nameOf(given)}: number ${wrong} is ${show(list[wrong])}, not ${rule.words}`,
  );
}

/** JSON, or the numbers of a text with blanks or line ends between them; other words as they are. */
function listIn(bytes: Uint8Array): unknown {
  requireNoUtf16(bytes);
  const text = new TextDecoder().decode(bytes);
  if (isJson(text)) return readJson(bytes);
  if (text.trim() === '') throw new Error('the file is empty');
  if (text.includes('\0')) throw new Error('it is not text');
  const words = text.trim().split(/\s+/);
  return words.map((word) => (Number.isNaN(Number(word)) ? word : Number(word)));
}

/** Points as they were given, with the name that messages call them. */
export type NamedPoints = PointsFile & { name: string };

/** Reads a list of sites or points. */
export async function readPoints(given: string): Promise<NamedPoints> {
  const vertex = /^\d+$/.test(given) && `a vertex is given as '{"vertex": ${given}}'`;
  const place = /^[-\d.]+(,[-\d.]+){2}$/.test(given) && `a place is given as '[[${given}]]'`;
  if ((vertex || place) && !(await exists(given)))
    throw new FileError(`there is no file ${given}; ${vertex || place}`);
  const file = await readAs(given, async (bytes) => pointsFile(await readPointsFile(bytes)));
  return { name: nameOf(given), ...file };
}

/** Reads a file, or JSON itself: no file is called `{…` or `[…`. Errors name what was read. */
async function readAs<Content>(
  given: string,
  read: (bytes: Uint8Array) => Promise<Content>,
): Promise<Content> {
  const bytes = isJson(given) ? new TextEncoder().encode(given) : await readBytes(given);
  return read(bytes).catch((cause: Error) => {
    throw new FileError(`${nameOf(given)}: ${cause.message}`, { cause });
  });
}

/** What messages call a file, or the JSON that is given instead. */
export function nameOf(given: string): string {
  if (given === standard) return 'standard input';
  return isJson(given) && given.length > 40 ? `${given.slice(0, 40)}…` : given;
}
