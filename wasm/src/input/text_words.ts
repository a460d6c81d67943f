// SPDX-License-Identifier: MIT
//
// The words of a text file, line by line, and what goes wrong in one. However long the file is, or
// a line of it, only a small part of it is a string at a time.

import { type GeodesicVoronoiError, invalidFile } from '../api/errors.js';

/** Lines that are read between two places where the work can be interrupted. */
export const linesPerStep = 64;
const blockBytes = 2 ** 16;
/** No number or keyword is as long. */
const maxWord = 2 ** 12;

const [lineFeed, carriageReturn, space, hash, zero, backslash] = [
  0x0a, 0x0d, 0x20, 0x23, 0x30, 0x5c,
];

interface TextOptions {
  /** The lines of the file before these bytes, if they are only its end. */
  linesBefore?: number;
  /** Whether a # begins a comment, up to the line's end. */
  hasComments?: boolean;
}

export class TextWords {
  readonly #bytes: Uint8Array;
  readonly #comment: number | undefined;
  readonly #decoder = new TextDecoder();
  /** Bytes that have been decoded. */
  #read = 0;
  /** Decoded text still needed: from the start of the line, or of the last word in a long line. */
  #text = '';
  /** Where in that text the next letter is, and where the line began, or what is kept of it. */
  #at = 0;
  #lineStart = 0;
  /** How a long line began, when that is not kept any more. */
  #lineHead = '';
  /** Lines that have ended. */
  #ended: number;
  /** The number of the line that is read; 0 before the first one. */
  #line = 0;

  constructor(bytes: Uint8Array, { linesBefore = 0, hasComments = false }: TextOptions = {}) {
    this.#bytes = bytes;
    this.#ended = linesBefore;
    this.#comment = hasComments ? hash : undefined;
  }

  /** The line's number, from 1 as editors count; before the first one, how many there were. */
  get line(): number {
    return this.#line || this.#ended;
  }

  /** The share of the text read so far, 0 … 1. */
  get share(): number {
    return this.#read / Math.max(1, this.#bytes.length);
  }

  /**
   * Goes to the next line that has words; whether there is one. A line that ends with a backslash
   * goes on in the next.
   */
  nextLine(): boolean {
    if (this.#line > 0) while (!this.#isLineEnd(this.#peek())) ++this.#at;
    for (; ; ++this.#at) {
      const code = this.#peek();
      if (code < 0) return false;
      if (code > space) break;
      // In some old files, a carriage return alone ends a line.
      const isEnd = code === lineFeed || (code === carriageReturn && this.#after() !== lineFeed);
      if (isEnd) ++this.#ended;
    }
    this.#line = this.#ended + 1;
    this.#lineStart = this.#at;
    this.#lineHead = '';
    return true;
  }

  /** The next word of the line, if there is one: in a line of comment, there is none. */
  next(): string | undefined {
    let code = this.#peek();
    while (code <= space && !this.#isLineEnd(code)) {
      ++this.#at;
      code = this.#peek();
    }
    if (this.#isLineEnd(code) || code === this.#comment) return undefined;
    let length = 0;
    while (this.#isWithinWord()) {
      ++this.#at;
      if (++length > maxWord) throw this.fault(`it has a word of more than ${maxWord} letters`);
    }
    return this.#text.slice(this.#at - length, this.#at);
  }

  /** A number as C prints it, even NaN or infinity: the mesh builder drops triangles with those. */
  nextNumber(): number {
    const word = this.next();
    if (word === undefined) throw this.fault(`a number is missing after '${this.excerpt()}'`);
    return this.numberOf(word);
  }

  numberOf(word: string): number {
    const number = decimal(word);
    if (!Number.isNaN(number)) return number;
    if (/^[-+]?(nan|inf)/i.test(word)) return NaN;
    throw this.fault(`'${shortened(word)}' is no number`);
  }

  /** How the line begins. */
  excerpt(): string {
    const text = this.#lineHead || this.#text.slice(this.#lineStart, this.#lineStart + maxWord);
    return shortened(
      text
        .split(/[\r\n]/)[0]
        .trim()
        .replaceAll(/\s+/g, ' '),
    );
  }

  fault(message: string): GeodesicVoronoiError {
    return lineFault(this.line, message);
  }

  #isWithinWord(): boolean {
    if (this.#at >= this.#text.length && !this.#decodeMore()) return false;
    const code = this.#text.charCodeAt(this.#at);
    if (code === this.#comment) return false;
    return code > space && (code !== backslash || !this.#isLineEnd(this.#after()));
  }

  #isLineEnd(code: number): boolean {
    return code < 0 || code === lineFeed || code === carriageReturn;
  }

  /**
   * The letter's code; -1 at the end of the text. A backslash and the line's end after it are a
   * space.
   */
  #peek(): number {
    if (this.#at >= this.#text.length && !this.#decodeMore()) return -1;
    const code = this.#text.charCodeAt(this.#at);
    if (code !== backslash || !this.#isLineEnd(this.#after())) return code;
    if (this.#after() < 0) return space;
    ++this.#at;
    ++this.#ended;
    if (this.#text.charCodeAt(this.#at) === carriageReturn && this.#after() === lineFeed)
      ++this.#at;
    return space;
  }

  /** The code of the letter after that. */
  #after(): number {
    if (this.#at + 1 >= this.#text.length && !this.#decodeMore()) return -1;
    return this.#text.charCodeAt(this.#at + 1);
  }

  #decodeMore(): boolean {
    const { length } = this.#bytes;
    if (this.#read >= length) return false;
    const end = Math.min(this.#read + blockBytes, length);
    const block = this.#bytes.subarray(this.#read, end);
    if (this.#at - this.#lineStart > 2 * maxWord) {
      this.#lineHead ||= this.#text.slice(this.#lineStart, this.#lineStart + maxWord);
      this.#lineStart = this.#at - maxWord - 1; // the start of a word that is being read
    }
    this.#text =
      this.#text.slice(this.#lineStart) + this.#decoder.decode(block, { stream: end < length });
    this.#at -= this.#lineStart;
    this.#lineStart = 0;
    this.#read = end;
    return true;
  }
}

export function lineFault(line: number, message: string): GeodesicVoronoiError {
  return invalidFile(`line ${line}: ${message}`);
}

/** The number that a word is in decimal notation, else NaN: `Number` reads 0x10, 0b1, 0o7, too. */
export function decimal(word: string): number {
  return word.charCodeAt(0) === zero && /^0[box]/i.test(word) ? NaN : Number(word);
}

function shortened(text: string): string {
  return text.length > 40 ? `${text.slice(0, 40)}…` : text;
}
