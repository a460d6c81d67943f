// SPDX-License-Identifier: MIT
//
// Places in a table of text: x, y and z in a line each.

const axes = ['x', 'y', 'z'];

/**
 * The places in a CSV. Numbers are parted by commas, semicolons or blanks. The first line may name
 * the columns; without names, they are the first three. Lines that begin with # are comments.
 */
export function readCsvPlaces(bytes: Uint8Array): number[] {
  const text = new TextDecoder().decode(bytes);
  const places: number[] = [];
  let columns = [0, 1, 2];
  let isFirst = true;
  for (const [i, line] of text.split(/\r\n|\r|\n/).entries()) {
    if (/^\s*(#|$)/.test(line)) continue;
    const words = line.trim().split(/\s*[,;]\s*|\s+/);
    const names = isFirst && Number.isNaN(Number(words[0])) ? words : undefined;
    isFirst = false;
    if (names) columns = columnsOf(names);
    else places.push(...columns.map((column, k) => numberOf(words[column], i + 1, axes[k])));
  }
  return places;
}

function columnsOf(names: readonly string[]): number[] {
  const plain = names.map((name) => name.replace(/^"(.*)"$/, '$1').toLowerCase());
  const columns = axes.map((axis) => plain.indexOf(axis));
  const missing = axes.find((_, k) => columns[k] < 0);
  if (missing) throw new Error(`no column is called ${missing}: there are ${plain.join(', ')}`);
  return columns;
}

function numberOf(word: string | undefined, line: number, axis: string): number {
  const value = Number(word || NaN);
  if (Number.isFinite(value)) return value;
  throw new Error(`line ${line}: ${axis} is ${word ? `'${word}', not a number` : 'missing'}`);
}
