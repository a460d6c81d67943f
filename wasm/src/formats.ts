// SPDX-License-Identifier: MIT
//
// A diagram as a file. `scale` is what lengths are multiplied with on the way out.

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

function pointsJson({ face, bary }: SurfacePoints): SurfacePointsJson {
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
  const asset = { version: '2.0', generator: 'geodesic-voronoi' };
  // One region, no bisectors: glTF has no empty primitive.
  if (used.length === 0) return glb({ asset, scene: 0, scenes: [{}] }, []);

  const axis = (k: number) => positions.filter((_, i) => i % 3 === k);
  const float = 5126;
  const unsignedInt = 5125;
  return glb(
    {
      asset,
      scene: 0,
      scenes: [{ nodes: [0] }],
      nodes: [{ name: 'bisectors', mesh: 0 }],
      meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1, mode: 1 }] }],
      accessors: [
        {
          bufferView: 0,
          componentType: float,
          count: used.length,
          type: 'VEC3',
          min: [0, 1, 2].map((k) => axis(k).reduce((a, b) => Math.min(a, b))),
          max: [0, 1, 2].map((k) => axis(k).reduce((a, b) => Math.max(a, b))),
        },
        { bufferView: 1, componentType: unsignedInt, count: numbers.length, type: 'SCALAR' },
      ],
      bufferViews: [
        { buffer: 0, byteOffset: 0, byteLength: positions.byteLength },
        { buffer: 0, byteOffset: positions.byteLength, byteLength: numbers.byteLength },
      ],
      buffers: [{ byteLength: positions.byteLength + numbers.byteLength }],
    },
    [positions, numbers],
  );
}

/** The points that a list names, ascending, and the list in terms of them. */
function compact(
  list: Int32Array,
  pointCount: number,
): { used: Uint32Array; numbers: Uint32Array } {
  const number = new Uint32Array(pointCount);
  const used = new Uint32Array(new Set(list)).sort();
  used.forEach((point, i) => {
    number[point] = i;
  });
  return { used, numbers: Uint32Array.from(list, (point) => number[point]) };
}

/** A binary glTF of a JSON chunk and, if there is data, a BIN chunk; all of 4-byte elements. */
function glb(json: object, data: (Float32Array | Uint32Array)[]): Uint8Array<ArrayBuffer> {
  const text = new TextEncoder().encode(JSON.stringify(json));
  const jsonLength = 4 * Math.ceil(text.length / 4);
  const binLength = data.reduce((sum, array) => sum + array.byteLength, 0);
  const length = 12 + 8 + jsonLength + (binLength > 0 ? 8 + binLength : 0);
  const bytes = new Uint8Array(length);
  const view = new DataView(bytes.buffer);
  const writeWords = (offset: number, ...words: number[]) =>
    words.forEach((word, i) => view.setUint32(offset + 4 * i, word, true));

  writeWords(0, 0x46546c67 /* glTF */, 2, length, jsonLength, 0x4e4f534a /* JSON */);
  bytes.fill(0x20, 20, 20 + jsonLength);
  bytes.set(text, 20);
  if (binLength === 0) return bytes;
  let offset = 20 + jsonLength;
  writeWords(offset, binLength, 0x004e4942 /* BIN */);
  offset += 8;
  for (const array of data) {
    bytes.set(new Uint8Array(array.buffer, array.byteOffset, array.byteLength), offset);
    offset += array.byteLength;
  }
  return bytes;
}
