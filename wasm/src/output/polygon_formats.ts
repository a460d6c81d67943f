// SPDX-License-Identifier: MIT
//
// A dual, or regions as polygons, as a file.

import { pointVertices } from './vertex_attributes.js';
import { toResult } from '../base/checks.js';
import { listAt } from '../base/lists.js';
import {
  toFileOptions,
  type FileOptions,
  type JsonOptions,
  type SurfaceFileOptions,
} from './file_options.js';
import { glbAttributes, objCorner, objLines, plyColumns } from './file_vertices.js';
import {
  lengthsJson,
  placedPointsJson,
  type LengthsJson,
  type PlacedPointsJson,
} from './json_forms.js';
import { emptyGlb, GlbBuilder } from './glb.js';
import { ply, type PlyColumns } from './ply.js';
import type { PolygonMesh, PolygonTopology } from '../api/results.js';
import { stl } from './stl.js';
import { textOf } from './text.js';

/** The JSON form of a polygon mesh; `vertexLabel` of a dual, `faceLabel` of regions. */
export interface PolygonMeshJson extends LengthsJson {
  points: PlacedPointsJson;
  faces: number[][];
  vertexLabel: number[];
  faceLabel: number[];
  topology: PolygonTopology;
}

export function polygonJson(polygons: PolygonMesh, options?: JsonOptions): PolygonMeshJson {
  const { scale, unit } = toFileOptions(options, { unit: undefined });
  const { points, faces, vertexLabel, faceLabel, topology } = toPolygons(polygons);
  return {
    ...lengthsJson({ scale, unit }),
    points: placedPointsJson(points, scale),
    faces: Array.from({ length: faces.offset.length - 1 }, (_, f) => [...listAt(faces, f)]),
    vertexLabel: [...vertexLabel],
    faceLabel: [...faceLabel],
    topology,
  };
}

/** The polygons cut into triangles: one primitive. */
export function polygonGlb(
  polygons: PolygonMesh,
  options?: SurfaceFileOptions,
): Uint8Array<ArrayBuffer> {
  const { points, triangles } = toPolygons(polygons);
  const { mesh, scale } = toFileOptions(options, { mesh: undefined });
  if (triangles.face.length === 0) return emptyGlb();
  const file = new GlbBuilder(points.position, scale);
  const primitive = {
    attributes: glbAttributes(file, pointVertices(points, mesh)),
    indices: file.indices(Uint32Array.from(triangles.points)),
  };
  return file.finish({
    nodes: [{ name: 'polygons', mesh: 0 }],
    meshes: [{ name: 'polygons', primitives: [primitive] }],
  });
}

/** Polygons; those of regions in a group each. */
export function polygonObj(polygons: PolygonMesh, options?: SurfaceFileOptions): string {
  const { points } = toPolygons(polygons);
  const { mesh, scale } = toFileOptions(options, { mesh: undefined });
  const { faces, faceLabel } = withArea(polygons);
  const vertices = pointVertices(points, mesh);
  const lines = objLines(points.position, vertices, scale);
  for (let f = 0; f + 1 < faces.offset.length; ++f) {
    if (faceLabel.length > 0) lines.push(`g region_${faceLabel[f]}`);
    lines.push(
      `f ${Array.from(listAt(faces, f), (point) => objCorner(vertices, point, point)).join(' ')}`,
    );
  }
  return textOf(() => `# Polygons of a geodesic Voronoi diagram\n${lines.join('\n')}\n`);
}

/** Polygons; with the region of each vertex of a dual, or of each face that is a region. */
export function polygonPly(
  polygons: PolygonMesh,
  options?: SurfaceFileOptions,
): Uint8Array<ArrayBuffer> {
  const { points, vertexLabel } = toPolygons(polygons);
  const { mesh, scale } = toFileOptions(options, { mesh: undefined });
  const { faces, faceLabel } = withArea(polygons);
  const labels = (values: Int32Array): PlyColumns[] =>
    values.length > 0 ? [{ names: ['label'], type: 'int', values }] : [];
  return ply(
    'Polygons of a geodesic Voronoi diagram',
    [...plyColumns(points.position, pointVertices(points, mesh), scale), ...labels(vertexLabel)],
    faces,
    labels(faceLabel),
  );
}

/** The polygons cut into triangles. */
export function polygonStl(polygons: PolygonMesh, options?: FileOptions): Uint8Array<ArrayBuffer> {
  const { points, triangles } = toPolygons(polygons);
  const { scale } = toFileOptions(options, {});
  const comment = 'Polygons of a geodesic Voronoi diagram';
  return stl(comment, points.position, triangles.points, scale);
}

/** Drops polygons of one or two corners, which occur where regions have few neighbours. */
function withArea({ faces, faceLabel }: PolygonMesh): Pick<PolygonMesh, 'faces' | 'faceLabel'> {
  const count = faces.offset.length - 1;
  const kept = Array.from({ length: count }, (_, f) => f).filter(
    (f) => listAt(faces, f).length >= 3,
  );
  if (kept.length === count) return { faces, faceLabel };
  const lists = kept.map((f) => listAt(faces, f));
  let end = 0;
  return {
    faces: {
      offset: Int32Array.from([0, ...lists.map(({ length }) => (end += length))]),
      points: Int32Array.from(lists.flatMap((list) => [...list])),
    },
    faceLabel: faceLabel.length > 0 ? Int32Array.from(kept, (f) => faceLabel[f]) : faceLabel,
  };
}

function toPolygons(polygons: PolygonMesh): PolygonMesh {
  return toResult(
    'polygons',
    polygons,
    'points',
    'faces',
    'vertexLabel',
    'faceLabel',
    'triangles',
    'topology',
  );
}
