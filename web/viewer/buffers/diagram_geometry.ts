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
  segments: Pick<DiagramData['segments'], 'face' | 'points'>;
}

export interface DiagramGeometry {
  cells: CellTriangles;
  /** See `segmentRecords`; there is room for more segments. */
  segments: Float32Array;
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
  return {
    cells: cellTriangles(mesh, { cells, points }, roomFor),
    segments: segmentRecords(mesh, { points, segments }, roomFor),
  };
}

const centre = [1 / 3, 1 / 3, 1 / 3];

/**
 * Of every segment of the bisectors, x, y, z of both ends and of the shading normal of its face;
 * with room for `roomFor(count)` segments.
 */
export function segmentRecords(
  mesh: SceneMesh,
  { points, segments: { face, points: ends } }: Pick<DiagramLines, 'points' | 'segments'>,
  roomFor = (count: number) => count,
): Float32Array {
  const places = mesh.frame.toScene(points.position, ends);
  const records = new Float32Array(9 * roomFor(face.length));
  for (let i = 0; i < face.length; ++i) {
    for (let k = 0; k < 6; ++k) records[9 * i + k] = places[6 * i + k];
    mesh.writeNormal(face[i], centre, records, 9 * i + 6);
  }
  return records;
}
