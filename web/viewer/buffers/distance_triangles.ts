// SPDX-License-Identifier: MIT
//
// The surface with the distance to the nearest site at every point, ready to be drawn.

import type { SurfacePoints } from 'geodesic-voronoi';
import { cellTriangles, type Cells } from './cell_triangles.js';
import { mixed } from './face_label.js';
import type { SceneMesh } from './scene_mesh.js';

/** The parts of a diagram that are drawn, with distances in the model's units. */
export interface DistanceSamples {
  cells: Cells;
  faceLabel: Int32Array;
  /** At the points of the diagram. */
  atPoints: Float64Array;
  /** At the vertices that `cornersToAsk` names, by their numbers. */
  atVertices: Float64Array;
}

/**
 * Where one label owns a triangle, or a cell of one, paths come from one virtual source s, unfolded
 * into the triangle's plane. The squared distance is |p - s|², so squared distance minus |p|² is
 * linear: this *reach* is stored at corners. The shader interpolates it and adds |p|² to get the
 * squared distance.
 */
export interface DistanceTriangles {
  /** The reach at each corner of the model's triangles; those that are mixed lie behind the cells. */
  faceReach: Float32Array;
  /** Triangles of cells: place, shading normal and reach at each corner. */
  position: Float32Array;
  normal: Float32Array;
  reach: Float32Array;
}

/** The reach where no site reaches. */
const noReach = 1e6;

/** Vertices of the triangles in a diagram; point i is `vertex[i]`, as the corner of a triangle. */
export function cornersToAsk(
  { indices, positions }: Pick<SceneMesh, 'indices' | 'positions'>,
  faceLabel: Int32Array,
): { vertex: Int32Array; points: SurfacePoints } {
  const vertexCount = positions.length / 3;
  const vertex = new Int32Array(vertexCount);
  const face = new Int32Array(vertexCount);
  const bary = new Float64Array(3 * vertexCount);
  const isKnown = new Uint8Array(vertexCount);
  let count = 0;
  for (let f = 0; f < faceLabel.length; ++f) {
    if (faceLabel[f] < 0 && faceLabel[f] !== mixed) continue;
    for (let corner = 0; corner < 3; ++corner) {
      const v = indices[3 * f + corner];
      if (isKnown[v]) continue;
      isKnown[v] = 1;
      vertex[count] = v;
      face[count] = f;
      bary[3 * count++ + corner] = 1;
    }
  }
  return {
    vertex: vertex.subarray(0, count),
    points: { face: face.subarray(0, count), bary: bary.subarray(0, 3 * count) },
  };
}

export function distanceTriangles(
  mesh: SceneMesh,
  { cells, faceLabel, atPoints, atVertices }: DistanceSamples,
): DistanceTriangles {
  const { scale } = mesh.frame;
  const reachAt = (distance: number, position: Float32Array, at: number) => {
    if (!(distance < Infinity)) return noReach;
    let squared = 0;
    for (let axis = 0; axis < 3; ++axis) squared += position[at + axis] ** 2;
    return (scale * distance) ** 2 - squared;
  };
  const count = mesh.indices.length;
  const faceReach = new Float32Array(count);
  for (let corner = 0; corner < count; ++corner) {
    const face = Math.floor(corner / 3);
    const vertex = mesh.indices[corner];
    const isReached = faceLabel[face] >= 0 || faceLabel[face] === mixed;
    faceReach[corner] = isReached
      ? reachAt(atVertices[vertex], mesh.positions, 3 * vertex)
      : noReach;
  }
  const { position, normal, points } = cellTriangles(mesh, cells);
  const reach = Float32Array.from(points, (point, corner) =>
    reachAt(atPoints[point], position, 3 * corner),
  );
  return { faceReach, position, normal, reach };
}
