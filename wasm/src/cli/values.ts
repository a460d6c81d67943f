// SPDX-License-Identifier: MIT
//
// What the values of the options mean.

import { extname } from 'node:path';
import { cvtMethods, metrics, samplings } from '../core.js';
import { diagramGlb, diagramJson, diagramObj, pointsJson } from '../formats.js';
import { maxCount, maxDetail } from '../input.js';
import {
  partitionGlb,
  partitionJson,
  partitionLayouts,
  partitionObj,
  partitionPly,
} from '../partition_formats.js';
import { polygonGlb, polygonJson, polygonObj, polygonPly } from '../polygon_formats.js';
import type {
  CvtMethod,
  Diagram,
  Mesh,
  Metric,
  Partition,
  PolygonMesh,
  RemeshQuality,
  Sampling,
  SurfacePoints,
  Violation,
} from '../types.js';
import { listed, standard, UsageError, type Values } from './options.js';

/** Where sites come from: as many as the number, or the file of that path. */
export interface SiteSource {
  sites: number | string;
  sampling: Sampling;
  seed: number;
}

/** What to compute. */
export interface DiagramTask extends SiteSource {
  metric: Metric;
  detail: number;
}

export interface CvtTask extends SiteSource {
  method: CvtMethod;
  metric: Metric;
  iterations: number;
}

function toSiteSource({ sites, sampling = 'random', seed = '1' }: Values): SiteSource {
  if (sites === undefined) throw new UsageError('--sites is missing');
  return {
    sites: isNumber(sites) ? toInteger('--sites', sites, 1, maxCount) : sites,
    sampling: toOneOf('--sampling', sampling, samplings),
    seed: toInteger('--seed', seed, 0),
  };
}

export function toTask(values: Values): DiagramTask {
  const { metric = 'dgpc', detail = '0' } = values;
  return {
    ...toSiteSource(values),
    metric: toOneOf('--metric', metric, metrics),
    detail: toInteger('--detail', detail, 0, maxDetail),
  };
}

export function toCvtTask(values: Values): CvtTask {
  const { method = 'lbfgs', metric = 'dgpc', iterations = '50' } = values;
  return {
    ...toSiteSource(values),
    method: toOneOf('--method', method, cvtMethods),
    metric: toOneOf('--metric', metric, metrics),
    iterations: toInteger('--iterations', iterations, 0, maxCount),
  };
}

function toOneOf<Name extends string>(option: string, text: string, names: readonly Name[]): Name {
  const name = names.find((known) => known === text);
  if (name !== undefined) return name;
  throw new UsageError(`${option} is '${text}', not one of ${listed(names)}`);
}

function isNumber(text: string): boolean {
  return text.trim() !== '' && !Number.isNaN(Number(text));
}

function toInteger(
  name: string,
  text: string,
  least: number,
  most = Number.MAX_SAFE_INTEGER,
): number {
  const value = Number(text);
  if (isNumber(text) && Number.isInteger(value) && value >= least && value <= most) return value;
  throw new UsageError(`${name} is '${text}', not an integer from ${least} to ${most}`);
}

/** Units per metre. */
const unitScale: Record<string, number> = {
  m: 1,
  cm: 100,
  mm: 1000,
  km: 0.001,
  in: 1 / 0.0254,
  ft: 1 / 0.3048,
};

export function toScale(units = 'm'): number {
  const scale = Object.hasOwn(unitScale, units) ? unitScale[units] : Number(units);
  if (scale > 0 && Number.isFinite(scale)) return scale;
  throw new UsageError(
    `--units is '${units}', neither a positive factor nor one of ${listed(Object.keys(unitScale))}`,
  );
}

/** Makes a file of a result; `scale` is the output's unit. */
type Encoder<Result> = (result: Result, scale: number) => string | Uint8Array;
/** By the endings of files. */
type Encoders<Result> = Record<string, Encoder<Result>>;

/** The encoder that the ending of the output asks for; of standard output, JSON. */
function encoderOf<Result>(
  encoders: Encoders<Result>,
  { output = standard, json }: Values,
): Encoder<Result> {
  if (json || output === standard) return encoders['.json'];
  const ending = extname(output).toLowerCase();
  if (Object.hasOwn(encoders, ending)) return encoders[ending];
  throw new UsageError(`the ending of '${output}' is not one of ${listed(Object.keys(encoders))}`);
}

const text = (json: object): string => `${JSON.stringify(json)}\n`;

export function toDiagramEncoder(values: Values): Encoder<Diagram> {
  return encoderOf(
    {
      '.json': (diagram, scale) => text(diagramJson(diagram, scale)),
      '.obj': ({ data }, scale) => diagramObj(data, scale),
      '.glb': ({ data }, scale) => diagramGlb(data, scale),
    },
    values,
  );
}

interface PartitionResult {
  mesh: Mesh;
  sites: SurfacePoints;
  partition: Partition;
}

export function toPartitionEncoder(values: Values): Encoder<PartitionResult> {
  const layout = toOneOf('--layout', values.layout ?? 'regions', partitionLayouts);
  return encoderOf(
    {
      '.json': ({ partition, sites }, scale) => text(partitionJson(partition, sites, scale)),
      '.glb': ({ partition, mesh }, scale) => partitionGlb(partition, { layout, mesh, scale }),
      '.obj': ({ partition, mesh }, scale) => partitionObj(partition, { mesh, scale }),
      '.ply': ({ partition, mesh }, scale) => partitionPly(partition, { mesh, scale }),
    },
    values,
  );
}

interface PolygonResult {
  mesh: Mesh;
  sites: SurfacePoints;
  polygons: PolygonMesh;
  violations?: Violation[];
  quality?: RemeshQuality;
}

export function toPolygonEncoder(values: Values): Encoder<PolygonResult> {
  return encoderOf(
    {
      '.json': ({ sites, polygons, violations, quality }, scale) =>
        text({
          sites: pointsJson(sites),
          ...polygonJson(polygons, scale),
          ...(violations && { violations }),
          ...(quality && { quality: { ...quality, hausdorff: scale * quality.hausdorff } }),
        }),
      '.obj': ({ polygons, mesh }, scale) => polygonObj(polygons, { mesh, scale }),
      '.ply': ({ polygons, mesh }, scale) => polygonPly(polygons, { mesh, scale }),
      '.glb': ({ polygons, mesh }, scale) => polygonGlb(polygons, { mesh, scale }),
    },
    values,
  );
}
