// SPDX-License-Identifier: MIT
import { extname } from 'node:path';
import { metrics } from '../core.js';
import { diagramGlb, diagramJson, diagramObj } from '../formats.js';
import { load } from '../node.js';
import type { Diagram, Mesh, MeshInfo, MeshRepairs, Metric, SurfacePointsInput } from '../types.js';
import { FileError, Output, readModel, readPoints } from './files.js';
import { listed, standard, UsageError, type CommandName, type Values } from './options.js';
import { ProgressBar } from './progress.js';

export interface Request {
  mesh: string;
  values: Values;
}

export const run: Record<CommandName, (request: Request) => Promise<void>> = {
  info,
  diagram,
  locate,
};

async function info({ mesh: path, values }: Request): Promise<void> {
  const scale = toScale(values.units);
  const output = await Output.open(values.output ?? standard);
  const mesh = await openMesh(path);
  const facts = {
    ...mesh.info,
    area: scale * scale * mesh.info.area,
    diameter: scale * mesh.info.diameter,
  };
  const json = { ...facts, parts: mesh.parts };
  await output.write(values.json ? `${JSON.stringify(json, null, 2)}\n` : describe(facts));
}

async function diagram({ mesh: path, values }: Request): Promise<void> {
  const scale = toScale(values.units);
  const encode = toEncoder(values);
  const task = toTask(values);
  const output = await Output.open(values.output ?? standard);
  const diagram = await compute(path, values, task);
  await output.write(encode(diagram, scale));

  const { arcs, voronoiPoints } = diagram.data;
  if (output.isFile && !values.quiet) {
    process.stderr.write(
      `${diagram.regions.length} regions, ${arcs.offset.length - 1} bisector arcs, ` +
        `${voronoiPoints.point.length} Voronoi points\n`,
    );
  }
}

async function locate({ mesh: path, values }: Request): Promise<void> {
  if (values.points === undefined) throw new UsageError('--points is missing');
  const scale = toScale(values.units);
  const task = toTask(values);
  const output = await Output.open(values.output ?? standard);
  const points = await readPoints(values.points);
  const diagram = await compute(path, values, task);
  const { label, distance } = await diagram.locate(points);
  await output.write(
    `${JSON.stringify({
      label: [...label],
      // JSON has no infinity: what no site reaches is null.
      distance: Array.from(distance, (d) => (d === Infinity ? null : scale * d)),
    })}\n`,
  );
}

async function openMesh(path: string): Promise<Mesh> {
  const { bytes, resources } = await readModel(path);
  const gvd = await load();
  try {
    return await gvd.mesh(bytes, { resources });
  } catch (error) {
    throw new FileError(`${path}: ${(error as Error).message}`, { cause: error });
  }
}

interface DiagramTask {
  sites: number | string;
  seed: number;
  metric: Metric;
  detail: number;
}

/** The diagram that the options ask for. */
async function compute(
  path: string,
  values: Values,
  { sites, seed, metric, detail }: DiagramTask,
): Promise<Diagram> {
  const given: SurfacePointsInput | undefined =
    typeof sites === 'string' ? await readPoints(sites) : undefined;
  const mesh = await openMesh(path);
  if (!values.quiet) for (const note of mesh.info.notes) process.stderr.write(`note: ${note}\n`);

  const bar =
    values.progress || (process.stderr.isTTY && !values.quiet) ? new ProgressBar() : undefined;
  try {
    return await mesh.voronoi(given ?? (await mesh.sampleSites(sites as number, { seed })), {
      metric,
      detail,
      onProgress: (share) => bar?.update(share),
    });
  } finally {
    bar?.clear();
  }
}

function toTask({
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
    sites: isNumber(sites) ? toInteger('--sites', sites, 1) : sites,
    seed: toInteger('--seed', seed, 0),
    metric: metric as Metric,
    detail: toInteger('--detail', detail, 0),
  };
}

function isNumber(text: string): boolean {
  return text.trim() !== '' && !Number.isNaN(Number(text));
}

function toInteger(name: string, text: string, least: number): number {
  const value = Number(text);
  if (isNumber(text) && Number.isSafeInteger(value) && value >= least) return value;
  throw new UsageError(`${name} is '${text}', not an integer from ${least} on`);
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

function toScale(units = 'm'): number {
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

function toEncoder({ output = standard, json }: Values): Encoder {
  if (json || output === standard) return encoders['.json'];
  const ending = extname(output).toLowerCase();
  if (Object.hasOwn(encoders, ending)) return encoders[ending];
  throw new UsageError(`the ending of '${output}' is not one of ${listed(Object.keys(encoders))}`);
}

/** What each repair did, after its count. */
const repairTexts: Record<keyof MeshRepairs, string> = {
  weldedVertices: 'vertices welded to others at their place',
  isolatedVertices: 'vertices without a triangle',
  nonFiniteTriangles: 'triangles with a corner that is not finite, dropped',
  degenerateTriangles: 'triangles with two equal corners, dropped',
  duplicateTriangles: 'triangles given twice, dropped',
  nonManifoldEdges: 'edges of three or more triangles, cut apart',
  orientationCuts: 'edges cut because the surface has one side only',
  flippedTriangles: 'triangles turned over to agree with their neighbours',
  splitVertices: 'vertices split that joined separate fans of triangles',
};

function describe(facts: MeshInfo): string {
  const number = (x: number) => String(Number(x.toPrecision(6)));
  const rows: [string, string][] = [
    ['triangles', `${facts.faces} (${facts.inputFaces} in the file)`],
    ['vertices', `${facts.vertices} (${facts.inputVertices} in the file)`],
    ['edges', String(facts.edges)],
    ['components', String(facts.components)],
    ['boundary loops', String(facts.boundaryLoops)],
    ['genus', String(facts.genus)],
    ['Euler characteristic', String(facts.eulerCharacteristic)],
    ['area', number(facts.area)],
    ['diameter', number(facts.diameter)],
  ];
  const lines = rows.map(([name, value]) => `${name.padEnd(22)}${value}`);
  for (const [name, text] of Object.entries(repairTexts)) {
    const count = facts.repairs[name as keyof MeshRepairs];
    if (count > 0) lines.push(`repair: ${count} ${text}`);
  }
  for (const note of facts.notes) lines.push(`note: ${note}`);
  return `${lines.join('\n')}\n`;
}
