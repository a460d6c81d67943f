// SPDX-License-Identifier: MIT
//
// What the values of the options mean.

import { extname } from 'node:path';
import { metrics } from '../core.js';
import { diagramGlb, diagramJson, diagramObj } from '../formats.js';
import { maxCount, maxDetail } from '../input.js';
import type { Diagram, Metric } from '../types.js';
import { listed, standard, UsageError, type Values } from './options.js';

/** What to compute; sites are a number or the path of a file. */
export interface DiagramTask {
  sites: number | string;
  seed: number;
  metric: Metric;
  detail: number;
}

export function toTask({
  sites,
  sampling = 'random',
  seed = '1',
  metric = 'dgpc',
  detail = '0',
}: Values): DiagramTask {
  if (sites === undefined) throw new UsageError('--sites is missing');
  const samplings = ['random'];
  if (!samplings.includes(sampling)) {
    throw new UsageError(`--sampling is '${sampling}', not one of ${listed(samplings)}`);
  }
  if (!metrics.includes(metric as Metric)) {
    throw new UsageError(`--metric is '${metric}', not one of ${listed(metrics)}`);
  }
  return {
    sites: isNumber(sites) ? toInteger('--sites', sites, 1, maxCount) : sites,
    seed: toInteger('--seed', seed, 0),
    metric: metric as Metric,
    detail: toInteger('--detail', detail, 0, maxDetail),
  };
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

type Encoder = (diagram: Diagram, scale: number) => string | Uint8Array;

const encoders: Record<string, Encoder> = {
  '.json': (diagram, scale) => `${JSON.stringify(diagramJson(diagram, scale))}\n`,
  '.obj': ({ data }, scale) => diagramObj(data, scale),
  '.glb': ({ data }, scale) => diagramGlb(data, scale),
};

export function toEncoder({ output = standard, json }: Values): Encoder {
  if (json || output === standard) return encoders['.json'];
  const ending = extname(output).toLowerCase();
  if (Object.hasOwn(encoders, ending)) return encoders[ending];
  throw new UsageError(`the ending of '${output}' is not one of ${listed(Object.keys(encoders))}`);
}
