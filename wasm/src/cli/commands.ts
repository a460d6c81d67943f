// SPDX-License-Identifier: MIT
import { load } from '../node.js';
import type { Diagram, Mesh, SurfacePointsInput } from '../types.js';
import { FileError, Output, readModel, readPoints } from './files.js';
import { meshReport } from './mesh_report.js';
import { standard, UsageError, type CommandName, type Values } from './options.js';
import { ProgressBar } from './progress.js';
import { toEncoder, toScale, toTask, type DiagramTask } from './values.js';

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
  { sites, seed, metric, detail }: DiagramTask,
): Promise<Diagram> {
  const given: SurfacePointsInput | undefined =
    typeof sites === 'string' ? await readPoints(sites) : undefined;
  const mesh = await openMesh(path);
  if (!values.quiet) for (const note of mesh.info.notes) process.stderr.write(`note: ${note}\n`);

  const bar =
    !values.quiet && (values.progress || process.stderr.isTTY) ? new ProgressBar() : undefined;
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
