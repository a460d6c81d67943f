// SPDX-License-Identifier: MIT
//
// PLY (the Stanford polygon format), text or binary of either byte order: the places of its vertices, their
// property `density` if they have it, its faces, and triangle strips, which scans come in. Everything else is
// passed over.

import { GeodesicVoronoiError } from '../errors.js';
import { GrowingArray } from './growing_array.js';
import { requireVertices, type SizeLimits } from './limits.js';
import { lineFault, linesOf, numberOf } from './lines.js';
import {
  type PlyElement,
  type PlyHeader,
  type PlyProperty,
  type PlyType,
  plyTypes,
  readPlyHeader,
} from './ply_header.js';
import type { ReadModel } from './read_model.js';
import { Polygons } from './polygons.js';

const axes = ['x', 'y', 'z'];

export function readPly(bytes: Uint8Array, limits: SizeLimits): ReadModel {
  const header = readPlyHeader(bytes);
  const values =
    header.format === 'ascii'
      ? new TextValues(bytes, header)
      : new BinaryValues(bytes, header.bytes, header.format === 'binary_little_endian');
  const reader = new PlyReader(values, limits);
  for (const element of header.elements) reader.read(element);
  return reader.model();
}

/** The data, value after value. */
interface Values {
  next(type: PlyType): number;
  /** Where the last value was, for messages. */
  readonly place: string;
}

class PlyReader {
  readonly #values: Values;
  readonly #positions = new GrowingArray(Float64Array);
  readonly #density = new GrowingArray(Float64Array);
  readonly #polygons: Polygons;
  readonly #limits: SizeLimits;
  #highest = { vertex: -1, place: '' };

  constructor(values: Values, limits: SizeLimits) {
    this.#values = values;
    this.#polygons = new Polygons(limits);
    this.#limits = limits;
  }

  read(element: PlyElement): void {
    const { name, count } = element;
    if (name === 'vertex') {
      requirePlaces(element);
      requireVertices(count, this.#limits);
    }
    // An element without properties takes no bytes: there may be any number of it.
    const rows = element.properties.length > 0 ? count : 0;
    for (let i = 0; i < rows; ++i) {
      if (name === 'vertex') this.#readVertex(element);
      else for (const property of element.properties) this.#readProperty(name, property);
    }
  }

  model(): ReadModel {
    const vertexCount = this.#positions.length / 3;
    if (this.#polygons.count === 0) throw fault('the PLY has no faces');
    if (this.#highest.vertex >= vertexCount) {
      const { vertex, place } = this.#highest;
      throw fault(`${place}: a face names vertex ${vertex}, but there are ${vertexCount} (from 0)`);
    }
    const positions = this.#positions.toArray();
    const density = this.#density.toArray();
    return { positions, density, ...this.#polygons.triangulated(positions) };
  }

  #readVertex({ properties }: PlyElement): void {
    const place = [NaN, NaN, NaN];
    for (const { name, type, lengthType } of properties) {
      const axis = axes.indexOf(name);
      if (lengthType) this.#skip(type, this.#length(lengthType));
      else if (name === 'density') this.#density.push(this.#values.next(type));
      else if (axis < 0) this.#skip(type, 1);
      else place[axis] = this.#values.next(type);
    }
    for (const x of place) this.#positions.push(x);
  }

  #readProperty(element: string, { name, type, lengthType }: PlyProperty): void {
    const length = lengthType ? this.#length(lengthType) : 1;
    const isCorners = lengthType && /^vertex_ind(ices|ex)$/.test(name);
    if (isCorners && element === 'face') this.#readFace(type, length);
    else if (isCorners && element === 'tristrips') this.#readStrips(type, length);
    else this.#skip(type, length);
  }

  #readFace(type: PlyType, length: number): void {
    if (length < 3) {
      this.#skip(type, length); // an edge or a point
      return;
    }
    for (let i = 0; i < length; ++i) this.#polygons.addCorner(this.#vertex(type));
    this.#polygons.endPolygon();
  }

  /** Each vertex makes a triangle with the two before it, every other one turned; -1 begins anew. */
  #readStrips(type: PlyType, length: number): void {
    let strip: number[] = [];
    let isTurned = false;
    for (let i = 0; i < length; ++i) {
      const vertex = this.#vertex(type, -1);
      strip = vertex < 0 ? [] : [...strip.slice(-2), vertex];
      if (strip.length < 3) {
        isTurned = false;
        continue;
      }
      const [a, b, c] = strip;
      for (const corner of isTurned ? [a, c, b] : [a, b, c]) this.#polygons.addCorner(corner);
      this.#polygons.endPolygon();
      isTurned = !isTurned;
    }
  }

  #vertex(type: PlyType, least = 0): number {
    const vertex = this.#values.next(type);
    if (!Number.isInteger(vertex) || vertex < least || vertex >= this.#limits.maxVertices) {
      throw fault(`${this.#values.place}: ${vertex} is not a vertex`);
    }
    if (vertex > this.#highest.vertex) this.#highest = { vertex, place: this.#values.place };
    return vertex;
  }

  #length(type: PlyType): number {
    const length = this.#values.next(type);
    if (Number.isInteger(length) && length >= 0) return length;
    throw fault(`${this.#values.place}: ${length} is not the length of a list`);
  }

  #skip(type: PlyType, count: number): void {
    for (let i = 0; i < count; ++i) this.#values.next(type);
  }
}

function requirePlaces({ properties }: PlyElement): void {
  for (const axis of axes) {
    if (!properties.some(({ name }) => name === axis))
      throw fault(`the PLY's vertices have no ${axis}`);
  }
}

class BinaryValues implements Values {
  readonly #view: DataView;
  readonly #isLittleEndian: boolean;
  #at: number;
  #last: number;

  constructor(bytes: Uint8Array, start: number, isLittleEndian: boolean) {
    this.#view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.#isLittleEndian = isLittleEndian;
    this.#at = this.#last = start;
  }

  get place(): string {
    return `byte ${this.#last}`;
  }

  next(type: PlyType): number {
    const { bytes, getter } = plyTypes[type];
    this.#last = this.#at;
    this.#at += bytes;
    if (this.#at > this.#view.byteLength) {
      throw fault(`the PLY is truncated: it ends at byte ${this.#view.byteLength}`);
    }
    return this.#view[getter](this.#last, this.#isLittleEndian);
  }
}

class TextValues implements Values {
  readonly #lines: ReturnType<typeof linesOf>;
  readonly #firstLine: number;
  #line = { number: 0, words: [] as string[] };
  #word = 0;

  constructor(bytes: Uint8Array, header: PlyHeader) {
    this.#lines = linesOf(bytes.subarray(header.bytes));
    this.#firstLine = header.lines;
  }

  get place(): string {
    return `line ${this.#line.number}`;
  }

  /** Values may be on as many lines as they like. */
  next(): number {
    if (this.#word === this.#line.words.length) {
      const { value, done } = this.#lines.next();
      if (done) throw lineFault(this.#line, 'the PLY is truncated: it ends here');
      this.#line = { number: this.#firstLine + value.number, words: value.words };
      this.#word = 0;
    }
    return numberOf(this.#line.words[this.#word++], this.#line);
  }
}

function fault(message: string): GeodesicVoronoiError {
  return new GeodesicVoronoiError('invalid-file', message);
}
