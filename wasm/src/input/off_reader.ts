// SPDX-License-Identifier: MIT
//
// OFF, the format of Geomview, as text: the counts, a vertex per line, a face per line. Normals,
// colours and texture coordinates do not matter here.

import { invalidFile } from '../api/errors.js';
import { counted, integer } from '../base/sentences.js';
import type { SlicedWork } from '../base/slices.js';
import type { ReadModel } from '../base/triangles.js';
import { GrowingArray } from '../base/growing_array.js';
import { requireTriangles, requireVertices, type SizeLimits } from './limits.js';
import { Polygons } from './polygons.js';
import { decimal, linesPerStep, TextWords } from './text_words.js';

/** No vertex or face takes fewer: `0 0 0` or `3 0 1 2`, with the line's end. */
const leastVertexBytes = 6;
const leastFaceBytes = 8;

export function* readOff(bytes: Uint8Array, limits: SizeLimits): SlicedWork<ReadModel> {
  const words = new OffWords(bytes);
  const { vertexCount, faceCount } = readHead(words);
  requireVertices(vertexCount, limits);
  requireTriangles(faceCount, limits);

  const atMost = (count: number, bytesEach: number) =>
    Math.min(count, Math.floor(bytes.length / bytesEach));
  const places = new GrowingArray(Float64Array, 3 * atMost(vertexCount, leastVertexBytes));
  for (let vertex = 0; vertex < vertexCount; ++vertex) {
    places.push(
      words.numberOf(
        words.firstOfLine(
          () => `${integer(vertex)} of ${counted(vertexCount, 'vertex', 'vertices')}`,
        ),
      ),
    );
    places.push(words.nextNumber());
    places.push(words.nextNumber());
    if (vertex % linesPerStep === 0) yield words.share;
  }

  const polygons = new Polygons(limits, atMost(faceCount, leastFaceBytes));
  for (let face = 0; face < faceCount; ++face) {
    const size = words.countOf(
      words.firstOfLine(() => `${integer(face)} of ${counted(faceCount, 'face')}`),
    );
    if (size < 3) {
      polygons.passOver();
    } else {
      for (let i = 0; i < size; ++i) polygons.addCorner(vertexOf(words, vertexCount));
      polygons.endPolygon();
    }
    if (face % linesPerStep === 0) yield words.share;
  }
  if (polygons.count === 0) throw invalidFile('the OFF has no faces of three corners or more');

  const positions = yield* places.take();
  return { positions, ...(yield* polygons.take(positions)) };
}

/** The keyword, which may be missing, and the counts, which stand beside it or in the next line. */
function readHead(words: OffWords): { vertexCount: number; faceCount: number } {
  const keyword = words.firstOfLine(() => 'nothing');
  if (/^\d+$/.test(keyword))
    return { vertexCount: words.countOf(keyword), faceCount: words.countOf(words.next()) };
  if (!/^(ST|C|N)*OFF$/.test(keyword))
    throw words.fault(
      `'${keyword}' is a kind of OFF that is not read: it is not of three dimensions`,
    );
  const beside = words.next();
  if (beside === 'BINARY') throw words.fault('binary OFF is not read: save it as text');
  return {
    vertexCount: words.countOf(beside ?? words.firstOfLine(() => 'its keyword')),
    faceCount: words.countOf(words.next()),
  };
}

function vertexOf(words: OffWords, vertexCount: number): number {
  const vertex = words.countOf(words.next());
  if (vertex < vertexCount) return vertex;
  throw words.fault(
    `the face names vertex ${vertex} (from 0), but the number of vertices is ${integer(vertexCount)}`,
  );
}

class OffWords extends TextWords {
  constructor(bytes: Uint8Array) {
    super(bytes, { hasComments: true });
  }

  /** The first word of the next line that is no comment; `read` tells what was there before it. */
  firstOfLine(read: () => string): string {
    while (this.nextLine()) {
      const word = this.next();
      if (word !== undefined) return word;
    }
    throw this.fault(`the OFF is truncated: it ends after ${read()}`);
  }

  countOf(word: string | undefined): number {
    const count = decimal(word ?? '');
    if (word !== undefined && Number.isInteger(count) && count >= 0) return count;
    throw this.fault(
      word === undefined
        ? `a number is missing after '${this.excerpt()}'`
        : `'${word.slice(0, 40)}' is no number of vertices or faces`,
    );
  }
}
