// SPDX-License-Identifier: MIT
//
// How long a binary STL is: a header, a count, and for each triangle a normal and three corners of three
// floats each, and two bytes without meaning.

import { toSizeLimits } from './limits.js';

const headerBytes = 84;
const triangleBytes = 50;

/** Whether the length is the one that the count of triangles calls for. */
export function isBinaryStl(bytes: Uint8Array): boolean {
  return bytes.length > headerBytes && bytes.length === stlBytes(stlTriangleCount(bytes));
}

/**
 * Whether it counts no more triangles than are read by default. Most other files have text or a larger
 * number there.
 */
export function mayBeBinaryStl(bytes: Uint8Array): boolean {
  const count = stlTriangleCount(bytes);
  return count > 0 && count <= toSizeLimits({}).maxTriangles;
}

/** 0 if there is not even a header. */
export function stlTriangleCount({ buffer, byteOffset, byteLength }: Uint8Array): number {
  if (byteLength < headerBytes) return 0;
  return new DataView(buffer, byteOffset, byteLength).getUint32(headerBytes - 4, true);
}

/** The length with so many triangles, which is also where the next one begins. */
export function stlBytes(triangles: number): number {
  return headerBytes + triangleBytes * triangles;
}
