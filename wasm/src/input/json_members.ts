// SPDX-License-Identifier: MIT
//
// JSON of unknown origin. A few bytes of JSON can become a hundred bytes of memory: limits prevent
// that, and no real file comes near them.

import { integer } from '../base/sentences.js';

/** The most lists and objects, which take more memory than other values. */
const maxLists = 2 ** 22;
const maxValues = 2 ** 24;
const maxDepth = 128;

const [quote, backslash, colon, comma] = [0x22, 0x5c, 0x3a, 0x2c];
const [openBrace, closeBrace, openBracket, closeBracket] = [0x7b, 0x7d, 0x5b, 0x5d];

/** Throws a `SyntaxError`, or a `RangeError` if there is too much of it. */
export function parseJson(text: Uint8Array): unknown {
  let [depth, lists, values] = [0, 0, 0];
  for (let at = 0; at < text.length; ++at) {
    const byte = text[at];
    if (byte === quote) at = endOfString(text, at);
    else if (byte === closeBrace || byte === closeBracket) --depth;
    else if (byte === openBrace || byte === openBracket) {
      if (++depth > maxDepth)
        throw new RangeError(`it is nested more than ${maxDepth} levels deep`);
      if (++lists > maxLists)
        throw new RangeError(`it has more than ${integer(maxLists)} lists and objects`);
    } else if (byte === comma && ++values > maxValues) {
      throw new RangeError(`it has more than ${integer(maxValues)} values`);
    }
  }
  return JSON.parse(new TextDecoder().decode(text));
}

/**
 * Parses the wanted members of an object and skips the rest, however large. Throws as `parseJson`
 * does if a wanted member is no JSON; returns `{}` if the text is no object.
 */
export function parseJsonMembers(
  text: Uint8Array,
  wanted: readonly string[],
): Record<string, unknown> {
  const members: Record<string, unknown> = {};
  for (const [name, value] of membersOf(text)) {
    const key = name.length < 64 ? JSON.parse(new TextDecoder().decode(name)) : '';
    if (wanted.includes(key)) members[key] = parseJson(value);
  }
  return members;
}

/** The members of the object that a text is: where their names (with quotes) and values are. */
function* membersOf(text: Uint8Array): Generator<[name: Uint8Array, value: Uint8Array]> {
  let depth = 0;
  let name = text.subarray(0, 0);
  let start = 0; // of the value
  for (let at = 0; at < text.length; ++at) {
    const byte = text[at];
    if (byte === quote) {
      const end = endOfString(text, at);
      if (depth === 1 && start === 0) name = text.subarray(at, end + 1);
      at = end;
    } else if (byte === openBrace || byte === openBracket) {
      ++depth;
    } else if (byte === closeBrace || byte === closeBracket) {
      if (depth === 1 && start > 0) yield [name, text.subarray(start, at)];
      if (--depth === 0) return;
    } else if (depth === 1 && byte === colon) {
      start = at + 1;
    } else if (depth === 1 && byte === comma) {
      if (start > 0) yield [name, text.subarray(start, at)];
      start = 0;
    } else if (depth === 0 && isLetter(byte)) {
      return; // another format, of which the rest need not be looked through
    }
  }
}

/** Whether a byte is neither blank nor part of the mark of UTF-8. */
function isLetter(byte: number): boolean {
  return byte > 0x20 && byte < 0x80;
}

/** Where the quote is that ends a string. */
function endOfString(text: Uint8Array, start: number): number {
  for (let at = start + 1; ; ++at) {
    at = text.indexOf(quote, at);
    if (at < 0) return text.length;
    let slashes = 0;
    while (text[at - 1 - slashes] === backslash) ++slashes;
    if (slashes % 2 === 0) return at;
  }
}
