// SPDX-License-Identifier: MIT
//
// PLY (the Stanford polygon format), text or binary of either byte order: the places of its
// vertices, their property `density` if they have it, its faces, and triangle strips, which scans
// come in. Everything else is passed over.

import { invalidFile } from '../api/errors.js';
import { counted, integer } from '../base/sentences.js';
import type { SlicedWork } from '../base/slices.js';
import type { ReadModel } from '../base/triangles.js';
import { GrowingArray } from '../base/growing_array.js';
import { requireVertices, type SizeLimits } from './limits.js';
import {
  type PlyElement,
  type PlyHeader,
  type PlyProperty,
  type PlyType,
  plyTypes,
  readPlyHeader,
} from './ply_header.js';
import { Polygons } from './polygons.js';
import { TextWords } from './text_words.js';

const axes = ['x', 'y', 'z'];

export function* readPly(bytes: Uint8Array, limits: SizeLimits): SlicedWork<ReadModel> {
  const reader = yield* readElements(bytes, limits);
  return yield* reader.take();
}

/** The places of the vertices, which need not have faces: x, y, z each. */
export function* readPlyPlaces(bytes: Uint8Array, limits: SizeLimits): SlicedWork<Float64Array> {
  const reader = yield* readElements(bytes, limits);
  return yield* reader.takePlaces();
}

function* readElements(bytes: Uint8Array, limits: SizeLimits): SlicedWork<PlyReader> {
  const header = readPlyHeader(bytes);
  const values =
    header.format === 'ascii'
      ? new TextValues(bytes, header)
      : new BinaryValues(bytes, header.bytes, header.format === 'binary_little_endian');
  // The count that the header promises, but no more than the file has bytes for.
  const promised = (name: string, leastBytes: number) => {
    const { count } = header.elements.find((element) => element.name === name) ?? { count: 0 };
    return Math.min(count, Math.floor(bytes.length / leastBytes));
  };
  const reader = new PlyReader(values, limits, promised('vertex', 3), promised('face', 4));
  for (const element of header.elements) yield* reader.read(element);
  return reader;
}

/** The data, value after value. */
interface Values {
  next(type: PlyType): number;
  /** The place of the last value, for messages. */
  readonly place: string;
  /** The share of the data read so far, 0 … 1. */
  readonly share: number;
}

/** Values read between two places where the work can be interrupted. */
const valuesPerStep = 256;

/** What is done with the values of a property, or with its list. */
interface Use {
  begin(length: number): void;
  add(value: number): void;
  end(): void;
}

class PlyReader {
  readonly #values: Values;
  readonly #positions: GrowingArray<Float64Array>;
  readonly #density = new GrowingArray(Float64Array);
  readonly #polygons: Polygons;
  readonly #limits: SizeLimits;
  #highest = { vertex: -1, place: '' };

  constructor(values: Values, limits: SizeLimits, vertices: number, triangles: number) {
    this.#values = values;
    this.#positions = new GrowingArray(Float64Array, 3 * vertices);
    this.#polygons = new Polygons(limits, triangles);
    this.#limits = limits;
  }

  *read(element: PlyElement): SlicedWork<void> {
    const { name, count, properties } = element;
    if (name === 'vertex') {
      requirePlaces(element);
      requireVertices(count, this.#limits);
    }
    const place = [NaN, NaN, NaN];
    const uses = properties.map((property) => this.#useOf(name, property, place));
    // An element without properties takes no bytes: there may be any number of it.
    const rows = properties.length > 0 ? count : 0;
    let steps = 0;
    for (let row = 0; row < rows; ++row) {
      for (const [i, use] of uses.entries()) {
        const { type, lengthType } = properties[i];
        const length = lengthType ? this.#length(lengthType) : 1;
        use.begin(length);
        for (let k = 0; k < length; ++k) {
          use.add(this.#values.next(type));
          if (++steps % valuesPerStep === 0) yield this.#values.share;
        }
        use.end();
        if (++steps % valuesPerStep === 0) yield this.#values.share;
      }
      if (name === 'vertex') for (const x of place) this.#positions.push(x);
    }
  }

  *takePlaces(): SlicedWork<Float64Array> {
    return yield* this.#positions.take();
  }

  *take(): SlicedWork<ReadModel> {
    const vertexCount = this.#positions.length / 3;
    if (this.#polygons.count === 0) throw invalidFile('the PLY has no faces');
    if (this.#highest.vertex >= vertexCount) {
      const { vertex, place } = this.#highest;
      throw invalidFile(
        `${place}: a face names vertex ${vertex} (from 0), but the number of vertices is ${integer(vertexCount)}`,
      );
    }
    const positions = yield* this.#positions.take();
    const density = yield* this.#density.take();
    // A header may name the property, or the vertices, twice.
    if (density.length > 0 && density.length !== vertexCount)
      throw invalidFile(
        `the PLY has ${integer(density.length)} densities for ${counted(vertexCount, 'vertex', 'vertices')}`,
      );
    return { positions, density, ...(yield* this.#polygons.take(positions)) };
  }

  #useOf(element: string, { name, lengthType }: PlyProperty, place: number[]): Use {
    if (element === 'vertex' && !lengthType) {
      const axis = axes.indexOf(name);
      if (axis >= 0) return { begin() {}, add: (x) => (place[axis] = x), end() {} };
      if (name === 'density') {
        return { begin() {}, add: (value) => this.#density.push(value), end() {} };
      }
    }
    const isCorners = lengthType && /^vertex_ind(ices|ex)$/.test(name);
    if (isCorners && element === 'face') return this.#faces();
    if (isCorners && element === 'tristrips') return this.#strips();
    return { begin() {}, add() {}, end() {} };
  }

  #faces(): Use {
    let isPolygon = false; // else an edge or a point
    return {
      begin: (length) => (isPolygon = length >= 3),
      add: (vertex) => {
        if (isPolygon) this.#polygons.addCorner(this.#vertex(vertex));
      },
      end: () => {
        if (isPolygon) this.#polygons.endPolygon();
      },
    };
  }

  /**
   * Each vertex makes a triangle with the two before it, every other one turned; -1 begins anew.
   */
  #strips(): Use {
    let [a, b] = [-1, -1];
    let isTurned = false;
    const restart = () => {
      [a, b] = [-1, -1];
      isTurned = false;
    };
    return {
      begin: restart,
      add: (vertex) => {
        if (vertex === -1) return restart();
        const c = this.#vertex(vertex);
        if (a >= 0) {
          for (const corner of isTurned ? [a, c, b] : [a, b, c]) this.#polygons.addCorner(corner);
          this.#polygons.endPolygon();
          isTurned = !isTurned;
        }
        [a, b] = [b, c];
      },
      end: restart,
    };
  }

  #vertex(vertex: number): number {
    if (!Number.isInteger(vertex) || vertex < 0 || vertex >= this.#limits.maxVertices) {
      throw invalidFile(`${this.#values.place}: ${vertex} is not a vertex`);
    }
    if (vertex > this.#highest.vertex) this.#highest = { vertex, place: this.#values.place };
    return vertex;
  }

  #length(type: PlyType): number {
    const length = this.#values.next(type);
    if (Number.isInteger(length) && length >= 0) return length;
    throw invalidFile(`${this.#values.place}: ${length} is not the length of a list`);
  }
}

function requirePlaces({ properties }: PlyElement): void {
  for (const axis of axes) {
    if (!properties.some(({ name }) => name === axis))
      throw invalidFile(`the PLY's vertices have no ${axis}`);
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

  get share(): number {
    return this.#at / this.#view.byteLength;
  }

  next(type: PlyType): number {
    const { bytes, getter } = plyTypes[type];
    this.#last = this.#at;
    this.#at += bytes;
    if (this.#at > this.#view.byteLength) {
      throw invalidFile(`the PLY is truncated: it ends at byte ${this.#view.byteLength}`);
    }
    return this.#view[getter](this.#last, this.#isLittleEndian);
  }
}

class TextValues implements Values {
  readonly #words: TextWords;

  constructor(bytes: Uint8Array, header: PlyHeader) {
    this.#words = new TextWords(bytes.subarray(header.bytes), { linesBefore: header.lines });
  }

  get place(): string {
    return `line ${this.#words.line}`;
  }

  get share(): number {
    return this.#words.share;
  }

  /** Values may be on as many lines as they like. */
  next(): number {
    for (;;) {
      const word = this.#words.next();
      if (word !== undefined) return this.#words.numberOf(word);
      if (!this.#words.nextLine()) throw this.#words.fault('the PLY is truncated: it ends here');
    }
  }
}
