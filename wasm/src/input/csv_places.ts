// SPDX-License-Identifier: MIT
//
// Places in a table of text: x, y and z in a line each.

import { show } from '../base/checks.js';
import type { SlicedWork } from '../base/slices.js';
import { decimal, linesPerStep } from './text_words.js';

const axes = ['x', 'y', 'z'];

/**
 * The places in a CSV. Its first line tells whether semicolons, commas or blanks part the columns, and
 * may name them; without names, the first three are read. A column in quotes may have any of these in
 * it. Between semicolons or blanks, numbers may have decimal commas. Lines that begin with # are
 * comments; the last one before the first line may name the columns, too, as NumPy and 3D Slicer write
 * it. If the rows have one column more than the first line has names, the first one has the names of
 * the rows, as R writes them.
 */
export function* readCsvPlaces(bytes: Uint8Array): SlicedWork<number[]> {
  const text = new TextDecoder().decode(bytes);
  const places: number[] = [];
  let columns = [0, 1, 2];
  let comment = '';
  /** The number of names in the line before, if that is the first one. */
  let names = 0;
  let known: Table | undefined;
  let lineNumber = 0;
  for (const { 1: line, index } of text.matchAll(/([^\r\n]*)(\r\n|\r|\n|$)/g)) {
    if (lineNumber++ % linesPerStep === 0) yield index / text.length;
    if (/^\s*#/.test(line)) comment = line.replace(/^[\s#]*(columns\s*=)?/, '').trim();
    if (/^\s*(#|$)/.test(line)) continue;
    const isFirst = !known;
    const table = known ?? new Table(line);
    known = table;
    const words = table.wordsOf(line.trim());
    if (isFirst) {
      const inComment = table.wordsOf(comment);
      if (inComment.length === words.length) columns = columnsOf(inComment) ?? columns;
      if (columns.some((column) => words[column] && Number.isNaN(table.numberOf(words[column])))) {
        columns = columnsOf(words) ?? refuseNames(words, lineNumber);
        names = words.length;
        continue;
      }
    }
    const hasRowNames = names > 0 && words.length === names + 1 && words.at(-1) !== '';
    if (hasRowNames) columns = columns.map((column) => column + 1);
    names = 0;
    for (const [k, column] of columns.entries()) {
      const value = table.numberOf(words[column]);
      if (!Number.isFinite(value)) refuseNumber(words[column], lineNumber, axes[k]);
      places.push(value);
    }
  }
  return places;
}

/** How a table is written, as its first line tells. */
class Table {
  readonly #hasDecimalCommas: boolean;
  /** A column, in quotes or plain, and what ends it. */
  readonly #column: RegExp;

  constructor(firstLine: string) {
    const unquoted = firstLine.replaceAll(/"[^"]*"/g, '');
    const mark = [';', ','].find((each) => unquoted.includes(each));
    const [plain, end] = mark ? [`[^${mark}]*`, mark] : ['\\S*', '\\s+'];
    this.#hasDecimalCommas = mark !== ',';
    this.#column = new RegExp(`(?:\\s*"((?:[^"]|"")*)"\\s*(?=${end}|$)|(${plain}))(${end}|$)`, 'g');
  }

  wordsOf(line: string): string[] {
    const words: string[] = [];
    for (const [, quoted, plain, end] of line.matchAll(this.#column)) {
      words.push((quoted?.replaceAll('""', '"') ?? plain).trim());
      if (!end) break;
    }
    return words;
  }

  /** NaN if it is none. */
  numberOf(word = ''): number {
    return word ? decimal(this.#hasDecimalCommas ? word.replace(',', '.') : word) : NaN;
  }
}

/** Where x, y and z are among names; undefined if they are not. */
function columnsOf(names: readonly string[]): number[] | undefined {
  const plain = names.map((name) => name.toLowerCase());
  const columns = axes.map((axis) => plain.indexOf(axis));
  return columns.every((column) => column >= 0) ? columns : undefined;
}

function refuseNumber(word: string | undefined, line: number, axis: string): never {
  throw new Error(`line ${line}: ${axis} is ${word ? `'${word}', not a number` : 'missing'}`);
}

function refuseNames(names: readonly string[], line: number): never {
  const read = show(names.join(' ').slice(0, 40));
  throw new Error(`line ${line} is neither three numbers nor names with x, y and z: ${read}`);
}
