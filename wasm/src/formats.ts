// SPDX-License-Identifier: MIT
//
// A diagram as a file. `scale` is what lengths are multiplied with on the way out.

import { GlbBuilder } from './glb.js';
import type { Diagram, DiagramData, SurfacePoints } from './types.js';

/** The JSON form of a list of points. */
export interface SurfacePointsJson {
  face: number[];
  bary: number[];
}

/** The JSON form of a diagram; every index in `loops` and `points` counts the points. */
export interface DiagramJson {
  metric: string;
  sites: SurfacePointsJson;
  points: SurfacePointsJson & { position: number[] };
  regions: { area: number; loops: number[][]; neighbours: number[] }[];
  /** The bisectors, in maximal chains between Voronoi points; the lower label is on the left. */
  arcs: { labels: number[]; points: number[] }[];
  voronoiPoints: { point: number; labels: number[] }[];
  /** As in `DiagramData`. */
  faceLabel: number[];
}

export function diagramJson(
  { metric, sites, data, regions }: Pick<Diagram, 'metric' | 'sites' | 'data' | 'regions'>,
  scale = 1,
): DiagramJson {
  const { points, arcs, voronoiPoints } = data;
  return {
    metric,
    sites: pointsJson(sites),
    points: { ...pointsJson(points), position: Array.from(points.position, (x) => scale * x) },
    regions: regions.map(({ area, loops, neighbours }) => ({
      area: scale * scale * area,
      loops: loops.map((loop) => [...loop]),
      neighbours,
    })),
    arcs: Array.from({ length: arcs.labels.length / 2 }, (_, i) => ({
      labels: [...arcs.labels.subarray(2 * i, 2 * i + 2)],
      points: [...arcs.points.subarray(arcs.offset[i], arcs.offset[i + 1])],
    })),
    voronoiPoints: Array.from(voronoiPoints.point, (point, i) => ({
      point,
      labels: [
        ...voronoiPoints.labels.subarray(
          voronoiPoints.labelOffset[i],
          voronoiPoints.labelOffset[i + 1],
        ),
      ],
    })),
    faceLabel: [...data.faceLabel],
  };
}

export function pointsJson({ face, bary }: SurfacePoints): SurfacePointsJson {
  return { face: [...face], bary: [...bary] };
}

/** The bisectors as Wavefront OBJ: a polyline per arc, in a group that names its two labels. */
export function diagramObj({ points, arcs }: DiagramData, scale = 1): string {
  const { used, numbers } = compact(arcs.points, points.face.length);
  const lines = ['# Bisectors of a geodesic Voronoi diagram'];
  for (const point of used) {
    const position = points.position.subarray(3 * point, 3 * point + 3);
    lines.push(`v ${Array.from(position, (x) => scale * x).join(' ')}`);
  }
  for (let i = 0; i + 1 < arcs.offset.length; ++i) {
    const [left, right] = arcs.labels.subarray(2 * i);
    const chain = numbers.subarray(arcs.offset[i], arcs.offset[i + 1]);
    lines.push(`g bisector_${left}_${right}`, `l ${Array.from(chain, (n) => n + 1).join(' ')}`);
  }
  return `${lines.join('\n')}\n`;
}

/** The bisectors as GLB: one primitive of line segments. */
export function diagramGlb({ points, segments }: DiagramData, scale = 1): Uint8Array<ArrayBuffer> {
  const { used, numbers } = compact(segments.points, points.face.length);
  const positions = new Float32Array(3 * used.length);
  used.forEach((point, i) => {
    for (let k = 0; k < 3; ++k) positions[3 * i + k] = scale * points.position[3 * point + k];
  });
  const file = new GlbBuilder();
  // One region, no bisectors: glTF has no empty primitive.
  if (used.length === 0) return file.finish({ scene: 0, scenes: [{}] });
  const lines = 1;
  const primitive = {
    attributes: { POSITION: file.attribute(positions, 'VEC3') },
    indices: file.indices(numbers),
    mode: lines,
  };
  return file.finish({
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ name: 'bisectors', mesh: 0 }],
    meshes: [{ primitives: [primitive] }],
  });
}

/** The points that a list names, ascending, and the list in terms of them. */
function compact(
  list: Int32Array,
  pointCount: number,
): { used: Uint32Array; numbers: Uint32Array<ArrayBuffer> } {
  const number = new Uint32Array(pointCount);
  const used = new Uint32Array(new Set(list)).sort();
  used.forEach((point, i) => {
    number[point] = i;
  });
  return { used, numbers: Uint32Array.from(list, (point) => number[point]) };
}
