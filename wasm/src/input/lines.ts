// SPDX-License-Identifier: MIT
//
// Words of a text file, line by line, and what goes wrong in one.

import { GeodesicVoronoiError } from '../errors.js';

export interface Line {
  /** From 1, as editors count. */
  number: number;
  words: string[];
}

/** The lines with words; one that ends with a backslash goes on in the next. */
export function* linesOf(bytes: Uint8Array): Generator<Line> {
  let begun = '';
  let begunAt = 1;
  for (const { number, text } of textLines(bytes)) {
    if (begun === '') begunAt = number;
    if (text.endsWith('\\')) {
      begun += `${text.slice(0, -1)} `;
      continue;
    }
    const words = (begun + text).trim().split(/\s+/);
    begun = '';
    if (words[0] !== '') yield { number: begunAt, words };
  }
}

/** Decoded one by one: a text of all might be longer than texts can be. */
function* textLines(bytes: Uint8Array): Generator<{ number: number; text: string }> {
  const lineFeed = 0x0a;
  const decoder = new TextDecoder();
  let number = 0;
  for (let at = 0; at < bytes.length; ) {
    const found = bytes.indexOf(lineFeed, at);
    const end = found < 0 ? bytes.length : found;
    const text = decoder.decode(bytes.subarray(at, end)).replace(/\r$/, '');
    // In some old files, a carriage return alone ends a line.
    for (const part of text.split('\r')) yield { number: ++number, text: part };
    at = end + 1;
  }
}

export function lineFault({ number }: Pick<Line, 'number'>, message: string): GeodesicVoronoiError {
  return new GeodesicVoronoiError('invalid-file', `line ${number}: ${message}`);
}

/** A number as C prints it, also one that is none: the mesh builder drops what touches those. */
export function numberOf(word: string | undefined, line: Line): number {
  if (word === undefined) throw lineFault(line, `a number is missing after '${excerpt(line)}'`);
  const number = Number(word);
  if (!Number.isNaN(number)) return number;
  if (/^[-+]?(nan|inf)/i.test(word)) return NaN;
  throw lineFault(line, `'${shortened(word)}' is no number`);
}

export function excerpt({ words }: Line): string {
  return shortened(words.join(' '));
}

function shortened(text: string): string {
  return text.length > 40 ? `${text.slice(0, 40)}…` : text;
}
