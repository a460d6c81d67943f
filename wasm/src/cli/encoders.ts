// SPDX-License-Identifier: MIT
//
// Files of the results, by the ending of the output.

import { extname } from 'node:path';
import { column, csv } from '../output/csv.js';
import { diagramGlb, diagramJson, diagramObj } from '../output/diagram_formats.js';
import {
  distancesGlb,
  distancesJson,
  distancesPly,
  pathsJson,
  pathsObj,
} from '../output/distance_formats.js';
import { lengthsJson, placedPointsJson, pointsJson } from '../output/json_forms.js';
import {
  partitionCsv,
  partitionGlb,
  partitionJson,
  partitionObj,
  partitionPly,
  partitionStl,
} from '../output/partition_formats.js';
import {
  polygonGlb,
  polygonJson,
  polygonObj,
  polygonPly,
  polygonStl,
} from '../output/polygon_formats.js';
import { ply } from '../output/ply.js';
import { textOf } from '../output/text.js';
import type {
  Distances,
  Located,
  Partition,
  PolygonMesh,
  RemeshQuality,
  SurfacePath,
  SurfacePoints,
  Violation,
} from '../api/results.js';
import type { Diagram, Mesh } from '../api/types.js';
import { standard, type Values } from './options.js';
import { UsageError, type Lengths } from './values.js';

/** Where the result goes, and its format if the name of the file does not decide. */
export type Target = Pick<Values, 'output' | 'json'> & Partial<Pick<Values<'diagram'>, 'format'>>;

/** Makes a file of a result. */
type Encoder<Result> = (result: Result, lengths: Lengths) => string | Uint8Array;
/** By the endings of files. */
type Encoders<Result> = Readonly<Record<string, Encoder<Result>>>;

/**
 * The ending of files of the format: of the one that is asked for, or else of the output's own; of
 * standard output and of names without an ending, such as /dev/stdout, that of JSON.
 */
export function endingOf({ output, json, format }: Target): string {
  if (json && format !== undefined)
    throw new UsageError('--json is a format as --format is: give one of them');
  if (format !== undefined) return `.${format}`;
  return json || output === standard ? '.json' : extname(output).toLowerCase() || '.json';
}

/** The one of the encoders that makes the format that is asked for. */
export function encoderOf<Result>(encoders: Encoders<Result>, target: Target): Encoder<Result> {
  const ending = endingOf(target);
  if (Object.hasOwn(encoders, ending)) return encoders[ending];
  const known = Object.keys(encoders);
  throw target.format === undefined
    ? unknownEnding(target, known)
    : new UsageError(
        `--format is '${target.format}', not one of ${known.map((name) => name.slice(1)).join(', ')}`,
      );
}

function unknownEnding({ output }: Target, known: string[]): UsageError {
  return new UsageError(`the ending of '${output}' is not one of ${known.join(', ')}`);
}

/** Whether a report on meshes is JSON, and not text for people. */
export function isJsonReport(target: Target): boolean {
  const ending = extname(target.output).toLowerCase();
  if (target.json || ending === '.json') return true;
  if (ending === '' || ending === '.txt') return false;
  throw unknownEnding(target, ['.json', '.txt']);
}

const text = (json: object): string => textOf(() => `${JSON.stringify(json)}\n`);

/** What tells later that sites or points of a file are not those of another mesh. */
const ofMesh = ({ info }: Mesh) => ({ mesh: { faces: info.inputFaces } });

export const locatedEncoders: Encoders<Located & { mesh: Mesh }> = {
  '.json': ({ mesh, label, distance }, lengths) =>
    text({
      ...ofMesh(mesh),
      ...lengthsJson(lengths),
      label: Array.from(label),
      // JSON has no infinity: what no site reaches is null.
      distance: Array.from(distance, (d) => (d === Infinity ? null : lengths.scale * d)),
    }),
  '.csv': ({ label, distance }, { scale }) =>
    csv({ label, distance: distance.map((d) => scale * d) }),
};

interface SitesResult {
  mesh: Mesh;
  sites: SurfacePoints;
  /** Of the sites, x, y, z each. */
  position: Float64Array<ArrayBuffer>;
  /** Of a tessellation, before and after each iteration. */
  energy: number[];
}

export const sitesEncoders: Encoders<SitesResult> = {
  '.json': ({ mesh, sites, position, energy }, lengths) =>
    text({
      ...ofMesh(mesh),
      ...lengthsJson(lengths),
      ...placedPointsJson({ ...sites, position }, lengths.scale),
      energy: energy.map((e) => lengths.scale ** 4 * e), // area times squared length
    }),
  // In the model's own unit, as `--sites` reads them; removed sites are nowhere.
  '.ply': ({ position }) => {
    const values = position.filter(Number.isFinite);
    const columns = [{ names: ['x', 'y', 'z'], type: 'double' as const, values }];
    return ply('Sites', columns, { offset: [0], points: [] }, []);
  },
  '.csv': ({ position }) => {
    const places = position.filter(Number.isFinite);
    const [x, y, z] = [0, 1, 2].map((k) => column(places, 3, k));
    return csv({ x, y, z });
  },
};

export const diagramEncoders: Encoders<Diagram> = {
  '.json': (diagram, lengths) => text(diagramJson(diagram, lengths)),
  '.obj': ({ data }, { scale }) => diagramObj(data, { scale }),
  '.glb': ({ data }, { scale }) => diagramGlb(data, { scale }),
};

interface DistancesResult {
  mesh: Mesh;
  distances: Distances;
}

export const distancesEncoders: Encoders<DistancesResult> = {
  '.json': ({ mesh, distances }, lengths) =>
    text({ ...ofMesh(mesh), ...distancesJson(distances, lengths) }),
  '.csv': ({ distances: { label, distance, direction } }, { scale }) =>
    csv({
      label,
      distance: distance.map((d) => scale * d),
      direction_x: column(direction, 2, 0),
      direction_y: column(direction, 2, 1),
    }),
  '.ply': ({ mesh, distances }, { scale }) => distancesPly(distances, { mesh, scale }),
  '.glb': ({ mesh, distances }, { scale }) => distancesGlb(distances, { mesh, scale }),
};

export const pathsEncoders: Encoders<SurfacePath[]> = {
  '.json': (paths, lengths) => text(pathsJson(paths, lengths)),
  '.obj': (paths, { scale }) => pathsObj(paths, { scale }),
};

interface PartitionResult extends Pick<Values<'partition'>, 'layout' | 'region'> {
  mesh: Mesh;
  sites: SurfacePoints;
  partition: Partition;
}

export const partitionEncoders: Encoders<PartitionResult> = {
  '.json': ({ mesh, partition, sites }, lengths) =>
    text({ ...ofMesh(mesh), ...partitionJson(partition, { sites, ...lengths }) }),
  '.glb': ({ partition, mesh, layout }, { scale }) =>
    partitionGlb(partition, { layout, mesh, scale }),
  '.obj': ({ partition, mesh }, { scale }) => partitionObj(partition, { mesh, scale }),
  '.ply': ({ partition, mesh }, { scale }) => partitionPly(partition, { mesh, scale }),
  '.stl': ({ partition, region }, { scale }) => partitionStl(partition, { region, scale }),
  '.csv': ({ partition }, { scale }) => partitionCsv(partition, { scale }),
};

/** Options about the files of one ending. */
const ofOneFormat = [
  ['layout', '.glb'],
  ['region', '.stl'],
] as const;

/** Refuses options that are not about the files of the format that is asked for. */
export function requireOwnFormat(target: Values<'partition'>): void {
  for (const [option, ending] of ofOneFormat) {
    if (target[option] === undefined || endingOf(target) === ending) continue;
    const { format, json, output } = target;
    const other = format !== undefined ? `--format ${format}` : json ? '--json' : `'${output}'`;
    throw new UsageError(`--${option} is about ${ending} files: ${other} has none`);
  }
}

interface PolygonResult {
  mesh: Mesh;
  sites: SurfacePoints;
  polygons: PolygonMesh;
  violations?: Violation[];
  quality?: RemeshQuality;
}

export const polygonEncoders: Encoders<PolygonResult> = {
  '.json': ({ mesh, sites, polygons, violations, quality }, lengths) =>
    text({
      ...ofMesh(mesh),
      sites: pointsJson(sites),
      ...polygonJson(polygons, lengths),
      ...(violations && { violations }),
      ...(quality && { quality: { ...quality, hausdorff: lengths.scale * quality.hausdorff } }),
    }),
  '.obj': ({ polygons, mesh }, { scale }) => polygonObj(polygons, { mesh, scale }),
  '.ply': ({ polygons, mesh }, { scale }) => polygonPly(polygons, { mesh, scale }),
  '.stl': ({ polygons }, { scale }) => polygonStl(polygons, { scale }),
  '.glb': ({ polygons, mesh }, { scale }) => polygonGlb(polygons, { mesh, scale }),
};
