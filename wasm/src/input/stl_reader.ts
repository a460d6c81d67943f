// SPDX-License-Identifier: MIT
//
// STL, binary or text: triangles by the places of their corners; normals are ignored, since they
// follow from these. The length tells binary from text, since some binary files begin with "solid",
// as text does.

import { invalidFile } from '../api/errors.js';
import type { SlicedWork } from '../base/slices.js';
import type { ReadModel } from '../base/triangles.js';
import { GrowingArray } from '../base/growing_array.js';
import { requireTriangles, requireVertices, type SizeLimits } from './limits.js';
import { stlBytes, stlTriangleCount } from './stl_layout.js';
import { linesPerStep, TextWords } from './text_words.js';
import { counted, integer } from '../base/sentences.js';

/** Triangles that are read between two places where the work can be interrupted. */
const trianglesPerStep = 64;

export function* readBinaryStl(bytes: Uint8Array, limits: SizeLimits): SlicedWork<ReadModel> {
  const count = stlTriangleCount(bytes);
  if (count === 0) throw invalidFile('the STL has no triangles');
  if (bytes.length < stlBytes(count)) {
    throw invalidFile(
      `the STL is truncated: for ${counted(count, 'triangle')} it needs ${integer(stlBytes(count))} bytes, but it has ${integer(bytes.length)}`,
    );
  }
  requireTriangles(count, limits);
  requireVertices(3 * count, limits);
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  const positions = new Float64Array(9 * count);
  for (let t = 0; t < count; ++t) {
    const corners = stlBytes(t) + 12; // after the normal
    for (let i = 0; i < 9; ++i) positions[9 * t + i] = view.getFloat32(corners + 4 * i, true);
    if (t % trianglesPerStep === 0) yield t / count;
  }
  return yield* modelOf(positions);
}

export function* readTextStl(bytes: Uint8Array, limits: SizeLimits): SlicedWork<ReadModel> {
  const words = new TextWords(bytes);
  const positions = new GrowingArray(Float64Array);
  /** Corners of the triangle that is being read; -1 outside. */
  let corners = -1;
  for (let line = 1; words.nextLine(); ++line) {
    const keyword = words.next()!.toLowerCase();
    if (keyword === 'outer') {
      if (corners >= 0) throw words.fault('a triangle begins before the last one has ended');
      corners = 0;
    } else if (keyword === 'vertex') {
      if (corners < 0) throw words.fault('this vertex is in no triangle (outer loop … endloop)');
      ++corners;
      for (let k = 0; k < 3; ++k) positions.push(words.nextNumber());
      requireTriangles(positions.length / 9, limits);
      requireVertices(positions.length / 3, limits);
    } else if (keyword === 'endloop') {
      if (corners !== 3)
        throw words.fault(`a triangle with ${counted(Math.max(0, corners), 'corner')} ends here`);
      corners = -1;
    } else if (!['solid', 'facet', 'endfacet', 'endsolid', 'color'].includes(keyword)) {
      throw words.fault(`'${words.excerpt()}' has no meaning in an STL`);
    }
    if (line % linesPerStep === 0) yield words.share;
  }
  if (corners >= 0) throw words.fault('the STL is truncated: it ends within a triangle');
  if (positions.length === 0)
    throw invalidFile('the STL has no triangles (each statement needs a line of its own)');
  return yield* modelOf(yield* positions.take());
}

function* modelOf(positions: Float64Array): SlicedWork<ReadModel> {
  const indices = new Int32Array(positions.length / 3);
  for (let i = 0; i < indices.length; ++i) {
    indices[i] = i;
    if (i % 2 ** 16 === 0) yield 1;
  }
  return { positions, indices, notes: [] };
}
