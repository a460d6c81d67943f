// SPDX-License-Identifier: MIT
//
// A diagram as a file.

import { isObject, toResult } from '../base/checks.js';
import { listAt } from '../base/lists.js';
import { toFileOptions, type FileOptions, type JsonOptions } from './file_options.js';
import { emptyGlb, GlbBuilder } from './glb.js';
import { textOf } from './text.js';
import {
  lengthsJson,
  placedPointsJson,
  pointsJson,
  type LengthsJson,
  type PlacedPointsJson,
  type SurfacePointsJson,
} from './json_forms.js';
import { regionsOf } from '../base/region.js';
import type { DiagramData, PlacedPoints } from '../api/results.js';
import type { Diagram } from '../api/types.js';

/** The JSON form of a diagram; every index in `loops`, `points` and `point` counts the points. */
export interface DiagramJson extends LengthsJson {
  /** The number of triangles in the mesh's file. */
  mesh: { faces: number };
  metric: string;
  sites: SurfacePointsJson;
  /** The points that the fields below refer to by index, each place once. */
  points: PlacedPointsJson;
  regions: { area: number; loops: number[][]; neighbours: number[] }[];
  /**
   * The bisectors, in maximal chains between Voronoi points; the lower label is on the left. From
   * point i to i + 1 they run through face i.
   */
  arcs: { labels: number[]; points: number[]; faces: number[] }[];
  voronoiPoints: { point: number; labels: number[] }[];
  /** This and the following fields are as in `DiagramData`. */
  faceLabel: number[];
  indifferentFaces: number[];
  cells: { face: number; label: number; points: number[] }[];
}

export function diagramJson(
  diagram: Pick<Diagram, 'metric' | 'sites' | 'data'>,
  options?: JsonOptions,
): DiagramJson {
  const { metric, sites, data } = toResult('diagram', diagram, 'sites', 'data');
  const { scale, unit } = toFileOptions(options, { unit: undefined });
  const { points, arcs, voronoiPoints, loops, cells } = data;
  const named = [loops.points, arcs.points, voronoiPoints.point, cells.points];
  const { used, number } = compact(named, points.face.length);
  const numbers = (list: Int32Array) => Array.from(list, (point) => number[point]);
  const arcFaces = facesOfArcs(data);
  return {
    mesh: { faces: data.faceLabel.length },
    metric,
    ...lengthsJson({ scale, unit }),
    sites: pointsJson(sites),
    points: placedPointsJson(pointsAt(points, used), scale),
    regions: regionsOf(data).map(({ area, loops, neighbours }) => ({
      area: scale * scale * area,
      loops: loops.map(numbers),
      neighbours,
    })),
    arcs: Array.from({ length: arcs.labels.length / 2 }, (_, i) => ({
      labels: [...arcs.labels.subarray(2 * i, 2 * i + 2)],
      points: numbers(listAt(arcs, i)),
      faces: arcFaces[i],
    })),
    voronoiPoints: Array.from(voronoiPoints.point, (point, i) => ({
      point: number[point],
      labels: [
        ...voronoiPoints.labels.subarray(
          voronoiPoints.labelOffset[i],
          voronoiPoints.labelOffset[i + 1],
        ),
      ],
    })),
    faceLabel: [...data.faceLabel],
    indifferentFaces: [...data.indifferentFaces],
    cells: Array.from(cells.face, (face, i) => ({
      face,
      label: cells.label[i],
      points: numbers(listAt(cells, i)),
    })),
  };
}

/** Per arc the faces of its segments, along the arc. */
function facesOfArcs({ segments, arcs }: DiagramData): number[][] {
  const faceOf = Array.from({ length: arcs.labels.length / 2 }, () => new Map<string, number>());
  segments.face.forEach((face, s) => {
    const [tail, tip] = segments.points.subarray(2 * s, 2 * s + 2);
    faceOf[segments.arc[s]].set(`${tail} ${tip}`, face);
  });
  return faceOf.map((faces, i) => {
    const points = listAt(arcs, i);
    return Array.from(points.subarray(1), (tip, k) => faces.get(`${points[k]} ${tip}`)!);
  });
}

function pointsAt({ face, bary, position }: PlacedPoints, indices: Uint32Array): PlacedPoints {
  const triples = (values: Float64Array) =>
    Float64Array.from(
      { length: 3 * indices.length },
      (_, i) => values[3 * indices[Math.floor(i / 3)] + (i % 3)],
    );
  return {
    face: Int32Array.from(indices, (i) => face[i]),
    bary: triples(bary),
    position: triples(position),
  };
}

/** Arrays of a diagram, or a diagram that has them. */
export type DiagramArrays<Name extends keyof DiagramData> =
  | Pick<DiagramData, Name>
  | { data: Pick<DiagramData, Name> };

function arraysOf<Name extends keyof DiagramData>(
  diagram: DiagramArrays<Name>,
  ...names: Name[]
): Pick<DiagramData, Name> {
  const data = isObject(diagram) && 'data' in diagram ? diagram.data : diagram;
  return toResult('diagram', data, ...names);
}

/** The bisectors as Wavefront OBJ: a polyline per arc, in a group that names its two labels. */
export function diagramObj(
  diagram: DiagramArrays<'points' | 'arcs'>,
  options?: FileOptions,
): string {
  const { points, arcs } = arraysOf(diagram, 'points', 'arcs');
  const { scale } = toFileOptions(options, {});
  const { used, number } = compact([arcs.points], points.face.length);
  const lines = ['# Bisectors of a geodesic Voronoi diagram'];
  for (const point of used) {
    const position = points.position.subarray(3 * point, 3 * point + 3);
    lines.push(`v ${Array.from(position, (x) => scale * x).join(' ')}`);
  }
  for (let i = 0; i + 1 < arcs.offset.length; ++i) {
    const [left, right] = arcs.labels.subarray(2 * i);
    const chain = Array.from(listAt(arcs, i), (point) => number[point] + 1);
    lines.push(`g bisector_${left}_${right}`, `l ${chain.join(' ')}`);
  }
  return textOf(() => `${lines.join('\n')}\n`);
}

/** The bisectors as GLB: one primitive of line segments. */
export function diagramGlb(
  diagram: DiagramArrays<'points' | 'segments'>,
  options?: FileOptions,
): Uint8Array<ArrayBuffer> {
  const { points, segments } = arraysOf(diagram, 'points', 'segments');
  const { scale } = toFileOptions(options, {});
  const { used, number } = compact([segments.points], points.face.length);
  // One region has no bisectors.
  if (used.length === 0) return emptyGlb();
  const file = new GlbBuilder(points.position, scale);
  const lines = 1;
  const primitive = {
    attributes: { POSITION: file.positions(used) },
    indices: file.indices(Uint32Array.from(segments.points, (point) => number[point])),
    mode: lines,
  };
  return file.finish({
    nodes: [{ name: 'bisectors', mesh: 0 }],
    meshes: [{ primitives: [primitive] }],
  });
}

/** The points that lists refer to, ascending, and for each point its index among these. */
function compact(
  lists: readonly Int32Array[],
  pointCount: number,
): { used: Uint32Array; number: Uint32Array } {
  const isUsed = new Uint8Array(pointCount);
  for (const list of lists) for (const point of list) isUsed[point] = 1;
  const used = Uint32Array.from(isUsed.keys()).filter((point) => isUsed[point] === 1);
  const number = new Uint32Array(pointCount);
  used.forEach((point, i) => {
    number[point] = i;
  });
  return { used, number };
}
