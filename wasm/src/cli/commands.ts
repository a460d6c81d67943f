// SPDX-License-Identifier: MIT
import { load } from '../node.js';
import type { CvtState, Diagram, Mesh, SurfacePointsInput } from '../types.js';
import { FileError, Output, readModel, readPoints } from './files.js';
import { meshReport } from './mesh_report.js';
import { standard, UsageError, type CommandName, type Values } from './options.js';
import { ProgressBar } from './progress.js';
import {
  toCvtTask,
  toEncoder,
  toScale,
  toTask,
  type DiagramTask,
  type SiteSource,
} from './values.js';

export interface Request {
  mesh: string;
  values: Values;
}

export const run: Record<CommandName, (request: Request) => Promise<void>> = {
  info,
  diagram,
  locate,
  cvt,
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
  await output.write(values.json ? `${JSON.stringify(json, null, 2)}\n` : meshReport(facts));
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

async function cvt({ mesh: path, values }: Request): Promise<void> {
  const scale = toScale(values.units);
  const { method, iterations, ...source } = toCvtTask(values);
  const output = await Output.open(values.output ?? standard);
  const { mesh, sites } = await openWithSites(path, values, source);
  const energy: number[] = [];
  let last: CvtState | undefined;
  await withProgress(values, async (onProgress) => {
    for await (const state of mesh.cvt(sites, { method, iterations })) {
      energy.push(scale ** 4 * state.energy); // an area times a squared length
      last = state;
      onProgress(iterations > 0 ? state.iteration / iterations : 1);
    }
  });
  const { face, bary } = last!.sites;
  await output.write(`${JSON.stringify({ face: [...face], bary: [...bary], energy })}\n`);
  if (output.isFile && !values.quiet) {
    process.stderr.write(
      `${face.length} sites, ${last!.iteration} iterations, energy ` +
        `${energy[0].toPrecision(6)} to ${energy.at(-1)!.toPrecision(6)}\n`,
    );
  }
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

/** The diagram that the options ask for. */
async function compute(
  path: string,
  values: Values,
  { metric, detail, ...source }: DiagramTask,
): Promise<Diagram> {
  const { mesh, sites } = await openWithSites(path, values, source);
  return withProgress(values, (onProgress) =>
    mesh.voronoi(sites, { metric, detail, onProgress }),
  );
}

async function openWithSites(
  path: string,
  values: Values,
  { sites, sampling, seed }: SiteSource,
): Promise<{ mesh: Mesh; sites: SurfacePointsInput }> {
  const given = typeof sites === 'string' ? await readPoints(sites) : undefined;
  const mesh = await openMesh(path);
  if (!values.quiet) for (const note of mesh.info.notes) process.stderr.write(`note: ${note}\n`);
  return {
    mesh,
    sites: given ?? (await mesh.sampleSites(sites as number, { sampling, seed })),
  };
}

/** Shows how far the work is, where that is wanted. */
async function withProgress<Result>(
  values: Values,
  work: (onProgress: (share: number) => void) => Promise<Result>,
): Promise<Result> {
  const bar =
    !values.quiet && (values.progress || process.stderr.isTTY) ? new ProgressBar() : undefined;
  try {
    return await work((share) => bar?.update(share));
  } finally {
    bar?.clear();
  }
}
