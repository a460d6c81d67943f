// SPDX-License-Identifier: MIT
//
// A diagram in the scene, ready to be drawn: a worker makes the geometry of each that is drawn as a
// whole.

import type { DiagramData } from 'geodesic-voronoi';
import { type Cells, type CellTriangles, cellTriangles } from './cell_triangles.js';
import type { DiagramSummary } from './diagram_summary.js';
import { roomFor } from './record_room.js';
import type { SceneMesh } from './scene_mesh.js';

/** The parts of a diagram that its geometry is made from. */
export interface DiagramLines extends Cells {
  segments: Pick<DiagramData['segments'], 'points'>;
}

export interface DiagramGeometry {
  cells: CellTriangles;
  /** x, y, z of both ends of every segment of the bisectors, and room for more segments. */
  segmentEnds: Float32Array;
}

/** Everything that is drawn of a diagram. */
export interface PreparedDiagram {
  summary: DiagramSummary;
  /** Per label. */
  tones: Uint16Array;
  /** Undefined if the caller has to make it while drawing. */
  geometry: DiagramGeometry | undefined;
}

export function diagramGeometry(
  mesh: SceneMesh,
  { cells, points, segments }: DiagramLines,
): DiagramGeometry {
  const segmentEnds = new Float32Array(6 * roomFor(segments.points.length / 2));
  mesh.frame.toScene(points.position, segments.points, segmentEnds);
  return { cells: cellTriangles(mesh, { cells, points }, roomFor), segmentEnds };
}
