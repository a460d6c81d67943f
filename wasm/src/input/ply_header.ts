// SPDX-License-Identifier: MIT
//
// The header of a PLY: what elements it has, how many, and of what properties.

import { invalidFile } from '../api/errors.js';
import { lineFault } from './text_words.js';

interface Line {
  number: number;
  words: string[];
}

export const plyTypes = {
  int8: { bytes: 1, getter: 'getInt8' },
  uint8: { bytes: 1, getter: 'getUint8' },
  int16: { bytes: 2, getter: 'getInt16' },
  uint16: { bytes: 2, getter: 'getUint16' },
  int32: { bytes: 4, getter: 'getInt32' },
  uint32: { bytes: 4, getter: 'getUint32' },
  float32: { bytes: 4, getter: 'getFloat32' },
  float64: { bytes: 8, getter: 'getFloat64' },
} as const;
export type PlyType = keyof typeof plyTypes;

/** Type names of the first PLY files, beside today's. */
const aliases: Record<string, PlyType> = {
  char: 'int8',
  uchar: 'uint8',
  short: 'int16',
  ushort: 'uint16',
  int: 'int32',
  uint: 'uint32',
  float: 'float32',
  double: 'float64',
};

export interface PlyProperty {
  name: string;
  type: PlyType;
  /** The type of a list's length; undefined for a single value. */
  lengthType?: PlyType;
}

export interface PlyElement {
  name: string;
  count: number;
  properties: PlyProperty[];
}

export interface PlyHeader {
  format: PlyFormat;
  elements: PlyElement[];
  /** The length of the header: the data begin after it. */
  bytes: number;
  lines: number;
}

const formats = ['ascii', 'binary_little_endian', 'binary_big_endian'] as const;
type PlyFormat = (typeof formats)[number];

/** The most bytes of a header: a file whose header has not ended by then is no PLY. */
export const maxHeaderBytes = 2 ** 16;

export function readPlyHeader(bytes: Uint8Array): PlyHeader {
  const text = new TextDecoder('latin1').decode(bytes.subarray(0, maxHeaderBytes));
  const end = /(^|[\r\n])end_header[ \t]*(\r\n|\r|\n)/.exec(text);
  if (!end) throw invalidFile('the PLY is truncated: its header has no end');
  const bytesOfHeader = end.index + end[0].length;
  const rows = text.slice(0, bytesOfHeader).split(/\r\n|\r|\n/);
  const header: PlyHeader = {
    format: 'ascii',
    elements: [],
    bytes: bytesOfHeader,
    lines: rows.length - 1,
  };
  let isKnown = false;
  for (const [i, row] of rows.entries()) {
    const line = { number: i + 1, words: row.trim().split(/\s+/) };
    const [keyword, word] = line.words;
    if (keyword === 'format') {
      const format = formats.find((name) => name === word);
      if (!format)
        throw lineFault(line.number, `'${word}' is not a format of PLY (${formats.join(', ')})`);
      header.format = format;
      isKnown = true;
    } else if (keyword === 'element') {
      header.elements.push(elementOf(line));
    } else if (keyword === 'property') {
      const element = header.elements.at(-1);
      if (!element) throw lineFault(line.number, 'this property belongs to no element');
      element.properties.push(propertyOf(line));
    }
  }
  if (!isKnown) throw invalidFile('the PLY does not say its format');
  return header;
}

function elementOf(line: Line): PlyElement {
  const [, name = '', count] = line.words;
  if (!/^\d{1,12}$/.test(count ?? ''))
    throw lineFault(line.number, `'${count}' is not a count of elements`);
  return { name, count: Number(count), properties: [] };
}

function propertyOf(line: Line): PlyProperty {
  const [, first, ...rest] = line.words;
  if (first !== 'list') return { name: rest[0] ?? '', type: typeOf(first, line) };
  const [lengthType, type, name = ''] = rest;
  return { name, type: typeOf(type, line), lengthType: typeOf(lengthType, line) };
}

function typeOf(name: string | undefined, line: Line): PlyType {
  if (name !== undefined && Object.hasOwn(plyTypes, name)) return name as PlyType;
  if (name !== undefined && Object.hasOwn(aliases, name)) return aliases[name];
  throw lineFault(line.number, `'${name}' is not a type of PLY`);
}
