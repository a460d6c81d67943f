// SPDX-License-Identifier: MIT
//
// Distances per vertex, and paths, as files.

import { inputVertices } from './vertex_attributes.js';
import { toResult } from '../base/checks.js';
import { invalidArgument } from '../api/errors.js';
import {
  toAttributeSource,
  toFileOptions,
  type AttributeSource,
  type FileOptions,
  type JsonOptions,
} from './file_options.js';
import { glbAttributes, plyColumns } from './file_vertices.js';
import {
  placedPointsJson,
  pointsJson,
  lengthsJson,
  type LengthsJson,
  type PlacedPointsJson,
  type SurfacePointsJson,
} from './json_forms.js';
import { GlbBuilder } from './glb.js';
import { ply } from './ply.js';
import { textOf } from './text.js';
import type { Distances, SurfacePath, VertexDistances } from '../api/results.js';
import { counted, integer } from '../base/sentences.js';

/** The JSON form of distances: one entry per input vertex, two in `direction`. */
export interface DistancesJson extends LengthsJson {
  metric: string;
  sites: SurfacePointsJson;
  /** -1 where no site reaches. */
  label: number[];
  /** null where no site reaches, as in `direction`. */
  distance: (number | null)[];
  direction: (number | null)[];
}

/** Options of a file with distances. */
export interface DistancesFileOptions extends FileOptions {
  /** The mesh that the distances are of. */
  mesh: AttributeSource;
}

export function distancesJson(distances: Distances, options?: JsonOptions): DistancesJson {
  const { metric, sites, label, distance, direction } = toResult(
    'distances',
    distances,
    'sites',
    'label',
    'distance',
    'direction',
  );
  const { scale, unit } = toFileOptions(options, { unit: undefined });
  // JSON has neither infinity nor NaN.
  const finite = (x: number) => (Number.isFinite(x) ? x : null);
  return {
    metric,
    ...lengthsJson({ scale, unit }),
    sites: pointsJson(sites),
    label: [...label],
    distance: Array.from(distance, (d) => finite(scale * d)),
    direction: Array.from(direction, finite),
  };
}

/** The input's vertices and triangles, with properties label, distance, direction_x and direction_y. */
export function distancesPly(
  distances: VertexDistances,
  options: DistancesFileOptions,
): Uint8Array<ArrayBuffer> {
  const { label, distance, direction } = toResult(
    'distances',
    distances,
    'label',
    'distance',
    'direction',
  );
  const { mesh, scale } = withMesh(distances, options);
  return ply(
    'Geodesic distances',
    [
      ...plyColumns(mesh.positions, inputVertices(mesh), scale),
      { names: ['label'], type: 'int', values: label },
      { names: ['distance'], type: 'double', values: distance.map((d) => scale * d) },
      { names: ['direction_x', 'direction_y'], type: 'double', values: direction },
    ],
    {
      offset: Int32Array.from({ length: mesh.indices.length / 3 + 1 }, (_, f) => 3 * f),
      points: mesh.indices,
    },
    [],
  );
}

/**
 * The input's vertices, and its triangles but for those with a corner that is not finite, with the
 * attributes `_LABEL` and `_DISTANCE`, both -1 where no site reaches: glTF has no infinity, and wants
 * attributes of applications to be floats or short integers.
 */
export function distancesGlb(
  distances: VertexDistances,
  options: DistancesFileOptions,
): Uint8Array<ArrayBuffer> {
  const { label, distance } = toResult('distances', distances, 'label', 'distance');
  const { mesh, scale } = withMesh(distances, options);
  const { positions, indices } = mesh;
  const hasPlace = Uint8Array.from(label, (_, v) =>
    Number(positions.subarray(3 * v, 3 * v + 3).every(Number.isFinite)),
  );
  const corners = indices.filter((_, c) => {
    const first = c - (c % 3);
    return hasPlace[indices[first]] && hasPlace[indices[first + 1]] && hasPlace[indices[first + 2]];
  });
  const known = distance.map((d) => (d === Infinity ? -1 : scale * d));
  const file = new GlbBuilder(positions, scale);
  const primitive = {
    attributes: {
      ...glbAttributes(file, inputVertices(mesh)),
      _LABEL: file.attribute(Float32Array.from(label), 'SCALAR'),
      _DISTANCE: file.attribute(Float32Array.from(known), 'SCALAR'),
    },
    indices: file.indices(Uint32Array.from(corners)),
  };
  return file.finish({
    nodes: [{ name: 'distances', mesh: 0 }],
    meshes: [{ name: 'distances', primitives: [primitive] }],
  });
}

/** The options, with the mesh that they have to bring: one of as many vertices. */
function withMesh(
  { label }: VertexDistances,
  options: DistancesFileOptions,
): { mesh: AttributeSource; scale: number } {
  const { mesh, scale } = toFileOptions(options, { mesh: undefined });
  const count = toAttributeSource(mesh).positions.length / 3;
  if (label.length === count) return { mesh, scale };
  throw invalidArgument(
    `mesh has ${counted(count, 'vertex', 'vertices')}: it is not the one of the distances, which are of ${integer(label.length)}`,
  );
}

/** The JSON form of paths; without points, and of length null, where there is none. */
export interface PathsJson extends LengthsJson {
  paths: { points: PlacedPointsJson; length: number | null }[];
}

export function pathsJson(
  paths: SurfacePath | readonly SurfacePath[],
  options?: JsonOptions,
): PathsJson {
  const { scale, unit } = toFileOptions(options, { unit: undefined });
  return {
    ...lengthsJson({ scale, unit }),
    paths: toPaths(paths).map(({ points, length }) => ({
      points: placedPointsJson(points, scale),
      length: length === Infinity ? null : scale * length,
    })),
  };
}

/** A polyline per path, in a group each; a point where the path has no length. */
export function pathsObj(
  paths: SurfacePath | readonly SurfacePath[],
  options?: FileOptions,
): string {
  const { scale } = toFileOptions(options, {});
  const lines = ['# Shortest paths'];
  let count = 0;
  toPaths(paths).forEach(({ points: { face, position } }, i) => {
    if (face.length === 0) return;
    for (let k = 0; k < position.length; k += 3) {
      const place = position.subarray(k, k + 3);
      lines.push(`v ${Array.from(place, (x) => scale * x).join(' ')}`);
    }
    const element = face.length > 1 ? 'l' : 'p';
    lines.push(`g path_${i}`, `${element} ${Array.from(face, () => ++count).join(' ')}`);
  });
  return textOf(() => `${lines.join('\n')}\n`);
}

/** Paths, of which one may be given without a list. */
function toPaths(paths: SurfacePath | readonly SurfacePath[]): readonly SurfacePath[] {
  if (!Array.isArray(paths)) return [toResult('path', paths as SurfacePath, 'points')];
  return paths.map((path, i) => toResult(`paths[${i}]`, path, 'points'));
}
