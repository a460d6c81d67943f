// SPDX-License-Identifier: MIT
//
// STL, binary or text: triangles by their corners' places; its normals follow from those. Which of the
// two it is, the length says: there are binary files that begin with "solid" as text does.

import { GeodesicVoronoiError } from '../errors.js';
import { GrowingArray } from './growing_array.js';
import { requireTriangles, requireVertices, type SizeLimits } from './limits.js';
import { excerpt, type Line, lineFault, linesOf, numberOf } from './lines.js';
import type { ReadModel } from './read_model.js';
import { stlBytes, stlTriangleCount } from './stl_layout.js';

export function readBinaryStl(bytes: Uint8Array, limits: SizeLimits): ReadModel {
  const count = stlTriangleCount(bytes);
  if (count === 0) throw fault('the STL has no triangles');
  if (bytes.length < stlBytes(count)) {
    throw fault(
      `the STL is truncated: its ${count} triangles need ${stlBytes(count)} bytes, but it has ${bytes.length}`,
    );
  }
  requireTriangles(count, limits);
  requireVertices(3 * count, limits);
  const view = viewOf(bytes);
  const positions = Float64Array.from({ length: 9 * count }, (_, i) =>
    view.getFloat32(stlBytes(Math.floor(i / 9)) + 4 * (3 + (i % 9)), true),
  );
  return modelOf(positions);
}

export function readTextStl(bytes: Uint8Array, limits: SizeLimits): ReadModel {
  const positions = new GrowingArray(Float64Array);
  /** Corners of the triangle that is being read; -1 outside. */
  let corners = -1;
  let last: Line = { number: 1, words: [] };
  for (const line of linesOf(bytes)) {
    last = line;
    const keyword = line.words[0].toLowerCase();
    if (keyword === 'outer') {
      if (corners >= 0) throw lineFault(line, 'a triangle begins before the last one has ended');
      corners = 0;
    } else if (keyword === 'vertex') {
      if (corners < 0)
        throw lineFault(line, 'this vertex is in no triangle (outer loop … endloop)');
      ++corners;
      for (let k = 1; k <= 3; ++k) positions.push(numberOf(line.words[k], line));
      requireTriangles(positions.length / 9, limits);
      requireVertices(positions.length / 3, limits);
    } else if (keyword === 'endloop') {
      if (corners !== 3)
        throw lineFault(line, `a triangle with ${Math.max(0, corners)} corners ends here`);
      corners = -1;
    } else if (!['solid', 'facet', 'endfacet', 'endsolid', 'color'].includes(keyword)) {
      throw lineFault(line, `'${excerpt(line)}' has no meaning in an STL`);
    }
  }
  if (corners >= 0) throw lineFault(last, 'the STL is truncated: it ends within a triangle');
  if (positions.length === 0) throw fault('the STL has no triangles');
  return modelOf(positions.toArray());
}

function modelOf(positions: Float64Array): ReadModel {
  return {
    positions,
    indices: Int32Array.from({ length: positions.length / 3 }, (_, i) => i),
    notes: [],
  };
}

function viewOf(bytes: Uint8Array): DataView {
  return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
}

function fault(message: string): GeodesicVoronoiError {
  return new GeodesicVoronoiError('invalid-file', message);
}
