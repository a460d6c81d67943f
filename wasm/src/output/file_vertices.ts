// SPDX-License-Identifier: MIT
//
// Vertices with their normals and texture coordinates, as each file format wants them.

import type { FileVertices } from './vertex_attributes.js';
import type { GlbBuilder } from './glb.js';
import type { PlyColumns } from './ply.js';

/** As the attributes of a primitive. */
export function glbAttributes(
  file: GlbBuilder,
  { points, normals, uvs }: FileVertices,
): Record<string, number> {
  return {
    POSITION: file.positions(points),
    ...(normals && { NORMAL: file.attribute(normals, 'VEC3') }),
    ...(uvs && { TEXCOORD_0: file.attribute(uvs, 'VEC2') }),
  };
}

export function plyColumns(
  position: Float64Array,
  { points, normals, uvs }: FileVertices,
  scale: number,
): PlyColumns[] {
  const columns: PlyColumns[] = [
    { names: ['x', 'y', 'z'], type: 'double', values: positionsAt(position, points, scale) },
  ];
  if (normals) columns.push({ names: ['nx', 'ny', 'nz'], type: 'float', values: normals });
  if (uvs) columns.push({ names: ['s', 't'], type: 'float', values: upwards(uvs) });
  return columns;
}

/** Lines of an OBJ: positions are those of all points, the rest is per vertex. */
export function objLines(
  position: Float64Array,
  { normals, uvs }: FileVertices,
  scale: number,
): string[] {
  const lines = (key: string, values: ArrayLike<number>, size: number, factor = 1) =>
    Array.from({ length: values.length / size }, (_, i) => {
      const numbers = Array.from({ length: size }, (_, k) => factor * values[size * i + k]);
      return `${key} ${numbers.join(' ')}`;
    });
  return [
    ...lines('v', position, 3, scale),
    ...(uvs ? lines('vt', upwards(uvs), 2) : []),
    ...(normals ? lines('vn', normals, 3) : []),
  ];
}

/** A corner of an OBJ face, by the point it is at and its vertex. */
export function objCorner({ normals, uvs }: FileVertices, point: number, vertex: number): string {
  const place = String(point + 1);
  if (uvs) return `${place}/${vertex + 1}${normals ? `/${vertex + 1}` : ''}`;
  return normals ? `${place}//${vertex + 1}` : place;
}

function positionsAt(position: Float64Array, points: Int32Array, scale: number): Float64Array {
  return Float64Array.from(
    { length: 3 * points.length },
    (_, i) => scale * position[3 * points[Math.floor(i / 3)] + (i % 3)],
  );
}

/** Texture coordinates from the bottom of the image, where glTF counts from the top. */
function upwards(uvs: Float32Array): Float32Array {
  return uvs.map((x, i) => (i % 2 === 1 ? 1 - x : x));
}
