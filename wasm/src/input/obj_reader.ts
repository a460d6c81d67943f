// SPDX-License-Identifier: MIT
//
// Wavefront OBJ: the vertices (v) and the faces (f) of all its groups. A face names its corners by the
// vertices' numbers: from 1, or from -1 for the last one before it. Their texture coordinates and
// normals, and materials, do not matter here.

import { GeodesicVoronoiError } from '../errors.js';
import { GrowingArray } from './growing_array.js';
import { requireVertices, type SizeLimits } from './limits.js';
import { type Line, lineFault, linesOf, numberOf } from './lines.js';
import type { ReadModel } from './read_model.js';
import { Polygons } from './polygons.js';

export function readObj(bytes: Uint8Array, limits: SizeLimits): ReadModel {
  const reader = new ObjReader(limits);
  for (const line of linesOf(bytes)) reader.read(line);
  return reader.model();
}

class ObjReader {
  readonly #positions = new GrowingArray(Float64Array);
  readonly #polygons: Polygons;
  readonly #limits: SizeLimits;
  /** Vertices may follow the faces that name them. */
  #highest = { vertex: -1, line: 0 };
  /** Faces of fewer than three corners, lines and points. */
  #passedOver = 0;

  constructor(limits: SizeLimits) {
    this.#limits = limits;
    this.#polygons = new Polygons(limits);
  }

  read(line: Line): void {
    switch (line.words[0]) {
      case 'v':
        this.#readVertex(line);
        break;
      case 'f':
      case 'fo': // of the format's first version
        this.#readFace(line);
        break;
      case 'l':
      case 'p':
        ++this.#passedOver;
    }
  }

  model(): ReadModel {
    if (this.#polygons.count === 0) {
      throw new GeodesicVoronoiError('invalid-file', 'the OBJ has no faces');
    }
    const { vertex, line } = this.#highest;
    if (vertex >= this.#vertexCount) {
      const message = `the face names vertex ${vertex + 1}, but there are ${this.#vertexCount}`;
      throw lineFault({ number: line }, message);
    }
    const positions = this.#positions.toArray();
    const { indices, notes } = this.#polygons.triangulated(positions);
    if (this.#passedOver > 0) notes.push(`${this.#passedOver} lines and points were passed over`);
    return { positions, indices, notes };
  }

  get #vertexCount(): number {
    return this.#positions.length / 3;
  }

  /** A weight or a colour may follow. */
  #readVertex(line: Line): void {
    for (let k = 1; k <= 3; ++k) this.#positions.push(numberOf(line.words[k], line));
    requireVertices(this.#vertexCount, this.#limits);
  }

  #readFace(line: Line): void {
    const [, ...corners] = line.words;
    if (corners.length < 3) {
      ++this.#passedOver;
      return;
    }
    for (const corner of corners) this.#polygons.addCorner(this.#vertexOf(corner, line));
    this.#polygons.endPolygon();
  }

  #vertexOf(corner: string, line: Line): number {
    const slash = corner.indexOf('/');
    const number = Number(slash < 0 ? corner : corner.slice(0, slash));
    const vertex = number < 0 ? this.#vertexCount + number : number - 1;
    if (!Number.isInteger(number) || vertex < 0 || vertex >= this.#limits.maxVertices) {
      throw lineFault(line, `'${corner.slice(0, 40)}' names no vertex`);
    }
    if (vertex > this.#highest.vertex) this.#highest = { vertex, line: line.number };
    return vertex;
  }
}
