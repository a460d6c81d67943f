// SPDX-License-Identifier: MIT
//
// Wavefront OBJ: the vertices (v) and the faces (f) of all its groups. A face names its corners by the
// vertices' numbers: from 1, or from -1 for the last one before it. Their texture coordinates and
// normals, and materials, do not matter here.

import { invalidFile } from '../api/errors.js';
import { integer } from '../base/sentences.js';
import type { SlicedWork } from '../base/slices.js';
import type { ReadModel } from '../base/triangles.js';
import { GrowingArray } from '../base/growing_array.js';
import { requireVertices, type SizeLimits } from './limits.js';
import { Polygons } from './polygons.js';
import { decimal, lineFault, linesPerStep, TextWords } from './text_words.js';

export function* readObj(bytes: Uint8Array, limits: SizeLimits): SlicedWork<ReadModel> {
  const words = new TextWords(bytes, { hasComments: true });
  const reader = new ObjReader(words, limits);
  for (let line = 1; words.nextLine(); ++line) {
    reader.readLine();
    if (line % linesPerStep === 0) yield words.share;
  }
  return yield* reader.take();
}

class ObjReader {
  readonly #words: TextWords;
  readonly #positions = new GrowingArray(Float64Array);
  readonly #polygons: Polygons;
  readonly #limits: SizeLimits;
  /** Vertices may follow the faces that name them. */
  #highest = { vertex: -1, line: 0 };

  constructor(words: TextWords, limits: SizeLimits) {
    this.#words = words;
    this.#limits = limits;
    this.#polygons = new Polygons(limits);
  }

  readLine(): void {
    switch (this.#words.next()) {
      case 'v':
        this.#readVertex();
        break;
      case 'f':
      case 'fo': // of the format's first version
        this.#readFace();
        break;
      case 'l':
      case 'p':
      case 'curv':
      case 'curv2':
      case 'surf':
        this.#polygons.passOver();
    }
  }

  *take(): SlicedWork<ReadModel> {
    if (this.#polygons.count === 0) {
      throw invalidFile('the OBJ has no faces');
    }
    const { vertex, line } = this.#highest;
    if (vertex >= this.#vertexCount) {
      throw lineFault(
        line,
        `the face names vertex ${vertex + 1}, but the number of vertices is ${integer(this.#vertexCount)}`,
      );
    }
    const positions = yield* this.#positions.take();
    return { positions, ...(yield* this.#polygons.take(positions)) };
  }

  get #vertexCount(): number {
    return this.#positions.length / 3;
  }

  /** A weight or a colour may follow. */
  #readVertex(): void {
    for (let k = 0; k < 3; ++k) this.#positions.push(this.#words.nextNumber());
    requireVertices(this.#vertexCount, this.#limits);
  }

  #readFace(): void {
    const first = [this.#words.next(), this.#words.next(), this.#words.next()];
    if (first[2] === undefined) {
      this.#polygons.passOver();
      return;
    }
    for (const corner of first as string[]) this.#polygons.addCorner(this.#vertexOf(corner));
    for (let corner = this.#words.next(); corner !== undefined; corner = this.#words.next())
      this.#polygons.addCorner(this.#vertexOf(corner));
    this.#polygons.endPolygon();
  }

  #vertexOf(corner: string): number {
    const slash = corner.indexOf('/');
    const number = decimal(slash < 0 ? corner : corner.slice(0, slash));
    const vertex = number < 0 ? this.#vertexCount + number : number - 1;
    if (!Number.isInteger(number) || vertex < 0 || vertex >= this.#limits.maxVertices) {
      throw this.#words.fault(`'${corner.slice(0, 40)}' names no vertex`);
    }
    if (vertex > this.#highest.vertex) this.#highest = { vertex, line: this.#words.line };
    return vertex;
  }
}
