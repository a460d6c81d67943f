// SPDX-License-Identifier: MIT
//
// A diagram in the scene, ready to be drawn: a worker makes it of each that is drawn as a whole.

import type { DiagramData } from 'geodesic-voronoi';
import { type Cells, type CellTriangles, cellTriangles } from './cell_triangles.js';
import { roomFor } from './record_room.js';
import type { SceneMesh } from './scene_mesh.js';

/** As much of a diagram as is looked at. */
export interface DiagramLines extends Cells {
  segments: Pick<DiagramData['segments'], 'points'>;
}

export interface DiagramGeometry {
  cells: CellTriangles;
  /** x, y, z of both ends of every segment of the bisectors, and room for more segments. */
  segmentEnds: Float32Array;
}

/** Makes a diagram ready to be drawn; undefined if whoever draws has to. */
export type MakeGeometry = (data: DiagramData) => Promise<DiagramGeometry | undefined>;

export function diagramGeometry(
  mesh: SceneMesh,
  { cells, points, segments }: DiagramLines,
): DiagramGeometry {
  const segmentEnds = new Float32Array(6 * roomFor(segments.points.length / 2));
  mesh.frame.writeToScene(points.position, segments.points, segmentEnds);
  return { cells: cellTriangles(mesh, { cells, points }, roomFor), segmentEnds };
}
