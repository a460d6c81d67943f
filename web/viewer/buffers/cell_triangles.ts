// SPDX-License-Identifier: MIT
//
// The cells of mixed faces, cut into triangles that can be drawn.

import type { DiagramData } from 'geodesic-voronoi';
import type { SceneMesh } from './scene_mesh.js';

/** The parts of a diagram that are cut. */
export interface Cells {
  cells: DiagramData['cells'];
  points: Pick<DiagramData['points'], 'position'>;
}

/**
 * Cells as triangles: as many as there are pairs of keys; the other arrays may have room for more.
 */
export interface CellTriangles {
  /** Per triangle its face and its label. */
  keys: Int32Array;
  /** Per corner x, y, z in the scene, and the shading normal. */
  position: Float32Array;
  normal: Float32Array;
  /** Per corner the point of the diagram. */
  points: Int32Array;
}

/**
 * The cells of a diagram as triangle fans, since they are convex. An iteration of a tessellation
 * draws tens of thousands of them: nothing is allocated per cell or corner. `roomFor` turns a
 * number of triangles into the number that the arrays have room for.
 */
export function cellTriangles(
  mesh: SceneMesh,
  { cells, points }: Cells,
  roomFor: (count: number) => number = (count) => count,
): CellTriangles {
  const cellCount = cells.face.length;
  // A fan of n corners has n - 2 triangles; no cell has less than three.
  const count = cells.points.length - 2 * cellCount;
  const keys = new Int32Array(2 * count);
  const room = roomFor(count);
  const position = new Float32Array(9 * room);
  const normal = new Float32Array(9 * room);
  const named = new Int32Array(3 * count);

  const places = mesh.frame.toScene(points.position);
  // Of the corners of one cell; of the barycentric coordinates, the second and the third.
  const mostCorners = longestCell(cells);
  const fan = new Float32Array(3 * mostCorners);
  const normals = new Float32Array(3 * mostCorners);
  const barys = new Float64Array(2 * mostCorners);
  const bary = [0, 0, 0];
  let triangle = 0;
  for (let cell = 0; cell < cellCount; ++cell) {
    const face = cells.face[cell];
    const first = cells.offset[cell];
    const corners = cells.offset[cell + 1] - first;
    for (let i = 0; i < corners; ++i) {
      const point = 3 * cells.points[first + i];
      for (let axis = 0; axis < 3; ++axis) fan[3 * i + axis] = places[point + axis];
      // A point names one of the faces it lies on, which need not be this one.
      mesh.writeBarycentric(face, places[point], places[point + 1], places[point + 2], bary);
      mesh.writeNormal(face, bary, normals, 3 * i);
      barys[2 * i] = bary[1];
      barys[2 * i + 1] = bary[2];
    }
    const turned = isClockwise(barys, corners);
    for (let i = 2; i < corners; ++i, ++triangle) {
      keys[2 * triangle] = face;
      keys[2 * triangle + 1] = cells.label[cell];
      const second = turned ? i : i - 1;
      const third = turned ? i - 1 : i;
      copyCorners(fan, second, third, position, 9 * triangle);
      copyCorners(normals, second, third, normal, 9 * triangle);
      named[3 * triangle] = cells.points[first];
      named[3 * triangle + 1] = cells.points[first + second];
      named[3 * triangle + 2] = cells.points[first + third];
    }
  }
  return { keys, position, normal, points: named };
}

function longestCell({ offset }: Cells['cells']): number {
  let longest = 0;
  for (let i = 1; i < offset.length; ++i) longest = Math.max(longest, offset[i] - offset[i - 1]);
  return longest;
}

/** The triples of corner 0 and two others. */
function copyCorners(
  from: Float32Array,
  second: number,
  third: number,
  to: Float32Array,
  at: number,
): void {
  for (let axis = 0; axis < 3; ++axis) {
    to[at + axis] = from[axis];
    to[at + 3 + axis] = from[3 * second + axis];
    to[at + 6 + axis] = from[3 * third + axis];
  }
}

/**
 * Whether a polygon in a face winds against the face, as the cells do of a triangle that the mesh
 * builder turned over. Its normals are those of the input's triangle.
 */
function isClockwise(barys: Float64Array, corners: number): boolean {
  let doubleArea = 0;
  let last = 2 * (corners - 1);
  for (let i = 0; i < 2 * corners; i += 2) {
    doubleArea += barys[last] * barys[i + 1] - barys[i] * barys[last + 1];
    last = i;
  }
  return doubleArea < 0;
}
