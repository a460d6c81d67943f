// SPDX-License-Identifier: MIT
//
// A partition as a file.

import { partitionVertices, someVertices, type TriangleRun } from './vertex_attributes.js';
import { show, toResult } from '../base/checks.js';
import { integers, oneOf, requireAllowed, share } from '../base/rules.js';
import {
  partitionLayouts,
  toFileOptions,
  type AttributeSource,
  type FileOptions,
  type JsonOptions,
  type PartitionLayout,
  type SurfaceFileOptions,
} from './file_options.js';
import { invalidArgument } from '../api/errors.js';
import { glbAttributes, objCorner, objLines, plyColumns } from './file_vertices.js';
import {
  placedPointsJson,
  pointsJson,
  lengthsJson,
  type LengthsJson,
  type PlacedPointsJson,
  type SurfacePointsJson,
} from './json_forms.js';
import { column, csv } from './csv.js';
import { emptyGlb, GlbBuilder } from './glb.js';
import { ply } from './ply.js';
import type { Partition, SurfacePoints } from '../api/results.js';
import { stl } from './stl.js';
import { textOf } from './text.js';
import { counted } from '../base/sentences.js';

export interface PartitionColourOptions extends SurfaceFileOptions {
  /** Linear RGB, 0 … 1, per region; by default hues, far apart for the first few regions. */
  colours?: readonly (readonly number[] | undefined)[] | undefined;
}

export interface PartitionGlbOptions extends PartitionColourOptions {
  /** Default 'regions'. */
  layout?: PartitionLayout | undefined;
}

export interface PartitionStlOptions extends FileOptions {
  /** The region to write, by the index of its site; -1 is what no site reaches. Default: all. */
  region?: number | undefined;
}

/** The JSON form of a partition; without its triangles where only facts of regions are wanted. */
export interface PartitionJson extends LengthsJson {
  sites: SurfacePointsJson;
  regions: {
    area: number;
    perimeter: number;
    boundaryLength: number;
    /** null for a site without region. */
    centroid: number[] | null;
    /** The nearest point of the region; face -1 for a site without. */
    nearCentroid: { face: number; bary: number[] };
    components: number;
    loops: number;
    eulerCharacteristic: number;
    genus: number;
    selfTouchings: number;
    neighbours: { label: number; length: number }[];
    firstTriangle: number;
    triangleCount: number;
  }[];
  points: PlacedPointsJson;
  triangles: { points: number[]; label: number[]; face: number[] };
}

/** Options of the JSON form of a partition. */
export interface PartitionJsonOptions extends JsonOptions {
  /** The sites of the diagram that the partition is of. */
  sites: SurfacePoints;
}

export function partitionJson(partition: Partition, options: PartitionJsonOptions): PartitionJson {
  const { points, triangles, regions } = toPartition(partition);
  const { sites, scale, unit } = toFileOptions(options, { sites: undefined, unit: undefined });
  toResult('sites', sites, 'face', 'bary');
  if (sites.face.length !== regions.area.length)
    throw invalidArgument(
      `sites has ${counted(sites.face.length, 'point')}: they are not those of the partition, which has ${counted(regions.area.length, 'region')}`,
    );
  const { neighbours, nearCentroid, triangleOffset } = regions;
  return {
    ...lengthsJson({ scale, unit }),
    sites: pointsJson(sites),
    regions: Array.from(regions.area, (area, i) => {
      const centroid = Array.from(regions.centroid.subarray(3 * i, 3 * i + 3), (x) => scale * x);
      return {
        area: scale * scale * area,
        perimeter: scale * regions.perimeter[i],
        boundaryLength: scale * regions.boundaryLength[i],
        centroid: centroid.some(Number.isNaN) ? null : centroid,
        nearCentroid: {
          face: nearCentroid.face[i],
          bary: [...nearCentroid.bary.subarray(3 * i, 3 * i + 3)],
        },
        components: regions.components[i],
        loops: regions.loops[i],
        eulerCharacteristic: regions.eulerCharacteristic[i],
        genus: regions.genus[i],
        selfTouchings: regions.selfTouchings[i],
        neighbours: Array.from(
          neighbours.label.subarray(neighbours.offset[i], neighbours.offset[i + 1]),
          (label, k) => ({ label, length: scale * neighbours.length[neighbours.offset[i] + k] }),
        ),
        firstTriangle: triangleOffset[i],
        triangleCount: triangleOffset[i + 1] - triangleOffset[i],
      };
    }),
    points: placedPointsJson(points, scale),
    triangles: {
      points: [...triangles.points],
      label: [...triangles.label],
      face: [...triangles.face],
    },
  };
}

export function partitionGlb(
  partition: Partition,
  options?: PartitionGlbOptions,
): Uint8Array<ArrayBuffer> {
  toPartition(partition);
  const { layout, ...form } = toFileOptions(options, {
    mesh: undefined,
    layout: 'regions',
    colours: [],
  });
  requireAllowed('layout', layout, oneOf(partitionLayouts));
  requireColours(form.colours);
  if (partition.triangles.label.length === 0) return emptyGlb();
  return layout === 'regions' ? regionsGlb(partition, form) : featuresGlb(partition, form);
}

type RegionColours = NonNullable<PartitionColourOptions['colours']>;

interface GlbForm {
  mesh: AttributeSource | undefined;
  scale: number;
  colours: RegionColours;
}

function regionsGlb(
  partition: Partition,
  { mesh, scale, colours }: GlbForm,
): Uint8Array<ArrayBuffer> {
  const file = new GlbBuilder(partition.points.position, scale);
  const runs = partsOf(partition);
  const { vertices, corners, offset } = partitionVertices(partition, mesh, runs);
  const parts = runs.map(({ label, first, last }, i) => {
    const [begin, end] = [offset[i], offset[i + 1]];
    const name = nameOf(label);
    const extras = { region: label };
    return {
      node: { name, mesh: i, extras },
      mesh: {
        name,
        primitives: [
          {
            attributes: glbAttributes(file, someVertices(vertices, begin, end)),
            indices: file.indices(corners.subarray(3 * first, 3 * last).map((c) => c - begin)),
            material: i,
          },
        ],
      },
      material: material(name, [...(colours[label] ?? hueOf(label)), 1]),
    };
  });
  return file.finish({
    nodes: parts.map(({ node }) => node),
    meshes: parts.map(({ mesh }) => mesh),
    materials: parts.map(({ material }) => material),
  });
}

function featuresGlb(
  partition: Partition,
  { mesh, scale, colours: regionColours }: GlbForm,
): Uint8Array<ArrayBuffer> {
  const siteCount = partition.regions.area.length;
  const file = new GlbBuilder(partition.points.position, scale);
  const runs = partsOf(partition);
  // Vertices on borders are repeated for each region, because a vertex has one feature id.
  const { vertices, corners, offset } = partitionVertices(partition, mesh, runs);
  const ids = new Float32Array(vertices.points.length);
  const colours = new Uint8Array(4 * ids.length);
  runs.forEach(({ label }, i) => {
    ids.fill(label < 0 ? siteCount : label, offset[i], offset[i + 1]);
    const colour = [...(regionColours[label] ?? hueOf(label)), 1].map((x) => Math.round(255 * x));
    for (let v = offset[i]; v < offset[i + 1]; ++v) colours.set(colour, 4 * v);
  });
  const isPartUnreached = runs[runs.length - 1].label < 0;
  const featureIds = {
    featureCount: runs.length - Number(isPartUnreached),
    attribute: 0,
    label: 'region',
    ...(isPartUnreached && { nullFeatureId: siteCount }),
  };
  const primitive = {
    attributes: {
      ...glbAttributes(file, vertices),
      COLOR_0: file.attribute(colours, 'VEC4'),
      _FEATURE_ID_0: file.attribute(ids, 'SCALAR'),
    },
    indices: file.indices(corners),
    material: 0,
    // Without a feature there is nothing to tell apart, and no valid extension.
    ...(featureIds.featureCount > 0 && {
      extensions: { EXT_mesh_features: { featureIds: [featureIds] } },
    }),
  };
  return file.finish({
    ...(featureIds.featureCount > 0 && { extensionsUsed: ['EXT_mesh_features'] }),
    nodes: [{ name: 'regions', mesh: 0 }],
    meshes: [{ name: 'regions', primitives: [primitive] }],
    materials: [material('regions', [1, 1, 1, 1])],
  });
}

/** A group per region; all vertices are shared. */
export function partitionObj(partition: Partition, options?: SurfaceFileOptions): string {
  toPartition(partition);
  const { mesh, scale } = toFileOptions(options, { mesh: undefined });
  const { vertices, corners } = partitionVertices(partition, mesh, [allOf(partition)]);
  const lines = objLines(partition.points.position, vertices, scale);
  const corner = (c: number) => objCorner(vertices, partition.triangles.points[c], corners[c]);
  for (const { label, first, last } of partsOf(partition)) {
    lines.push(`g ${nameOf(label).replace(' ', '_')}`);
    for (let t = first; t < last; ++t)
      lines.push(`f ${corner(3 * t)} ${corner(3 * t + 1)} ${corner(3 * t + 2)}`);
  }
  return textOf(() => `# Regions of a geodesic Voronoi diagram\n${lines.join('\n')}\n`);
}

/** Every face with its label, -1 where no site reaches, and the colour of its region. */
export function partitionPly(
  partition: Partition,
  options?: PartitionColourOptions,
): Uint8Array<ArrayBuffer> {
  toPartition(partition);
  const { mesh, scale, colours } = toFileOptions(options, { mesh: undefined, colours: [] });
  requireColours(colours);
  const { label } = partition.triangles;
  const rgb = new Uint8Array(3 * label.length);
  for (const { label: region, first, last } of partsOf(partition)) {
    const bytes = (colours[region] ?? hueOf(region)).map(srgbByte);
    for (let t = first; t < last; ++t) rgb.set(bytes, 3 * t);
  }
  const { vertices, corners } = partitionVertices(partition, mesh, [allOf(partition)]);
  const offset = Int32Array.from({ length: partition.triangles.label.length + 1 }, (_, t) => 3 * t);
  return ply(
    'Regions of a geodesic Voronoi diagram',
    plyColumns(partition.points.position, vertices, scale),
    { offset, points: corners },
    [
      { names: ['label'], type: 'int', values: label },
      { names: ['red', 'green', 'blue'], type: 'uchar', values: rgb },
    ],
  );
}

/**
 * Triangles alone, of one region or of all, which then cannot be told apart. A region without
 * triangles, as of a removed site, gives a file without any.
 */
export function partitionStl(
  partition: Partition,
  options?: PartitionStlOptions,
): Uint8Array<ArrayBuffer> {
  const { points, triangles, regions } = toPartition(partition);
  const { region, scale } = toFileOptions(options, { region: undefined });
  if (region !== undefined) requireAllowed('region', region, integers(-1, regions.area.length - 1));
  const part =
    region === undefined
      ? allOf(partition)
      : partsOf(partition).find(({ label }) => label === region);
  const corners = triangles.points.subarray(3 * (part?.first ?? 0), 3 * (part?.last ?? 0));
  const what = region === undefined ? 'Regions' : nameOf(region);
  return stl(`${what} of a geodesic Voronoi diagram`, points.position, corners, scale);
}

/** A table of the regions' measures and topology, a row each. */
export function partitionCsv(partition: Partition, options?: FileOptions): string {
  const { regions } = toPartition(partition);
  const { scale } = toFileOptions(options, {});
  const [x, y, z] = [0, 1, 2].map((k) => column(regions.centroid, 3, k).map((c) => scale * c));
  return csv({
    label: [...regions.area.keys()],
    area: regions.area.map((a) => scale * scale * a),
    perimeter: regions.perimeter.map((p) => scale * p),
    boundaryLength: regions.boundaryLength.map((b) => scale * b),
    centroid_x: x,
    centroid_y: y,
    centroid_z: z,
    components: regions.components,
    loops: regions.loops,
    genus: regions.genus,
  });
}

function allOf({ triangles }: Partition): TriangleRun {
  return { first: 0, last: triangles.label.length };
}

/** The runs of triangles of one label. */
function partsOf({ triangles, regions }: Partition): (TriangleRun & { label: number })[] {
  const { triangleOffset } = regions;
  const parts = Array.from(regions.area, (_, label) => ({
    label,
    first: triangleOffset[label],
    last: triangleOffset[label + 1],
  }));
  parts.push({ label: -1, first: parts.at(-1)?.last ?? 0, last: triangles.label.length });
  return parts.filter(({ first, last }) => first < last);
}

function nameOf(label: number): string {
  return label < 0 ? 'unreachable' : `region ${label}`;
}

/** A hue as linear RGB: steps of the golden ratio keep the first few hues far apart. */
function hueOf(label: number): number[] {
  if (label < 0) return [0.2, 0.2, 0.2];
  const hue = (label * 0.618033988749895) % 1;
  return [5, 3, 1].map((n) => {
    const k = (n + 6 * hue) % 6;
    return 0.85 * (1 - 0.6 * Math.max(0, Math.min(k, 4 - k, 1)));
  });
}

/** A channel of linear RGB as files without a colour space have it: a byte of sRGB. */
function srgbByte(linear: number): number {
  const encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;
  return Math.round(255 * encoded);
}

function material(name: string, baseColorFactor: number[]): object {
  return {
    name,
    pbrMetallicRoughness: { baseColorFactor, metallicFactor: 0, roughnessFactor: 0.8 },
    doubleSided: true,
  };
}

function requireColours(colours: RegionColours): void {
  if (!Array.isArray(colours)) throw invalidArgument(`colours is ${show(colours)}, not a list`);
  for (const [i, colour] of colours.entries()) {
    if (colour === undefined) continue;
    const name = `colours[${i}]`;
    if (!Array.isArray(colour)) throw invalidArgument(`${name} is ${show(colour)}, not a list`);
    if (colour.length !== 3)
      throw invalidArgument(`${name} has ${counted(colour.length, 'number')}, not three`);
    for (const [k, x] of colour.entries()) requireAllowed(`${name}[${k}]`, x, share);
  }
}

function toPartition(partition: Partition): Partition {
  return toResult('partition', partition, 'points', 'triangles', 'regions');
}
