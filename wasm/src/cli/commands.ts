// SPDX-License-Identifier: MIT
//
// What each command does.

import { GeodesicVoronoiError } from '../api/errors.js';
import type { MeshInfo, PolygonMesh, Violation } from '../api/results.js';
import { integers, length, type Rule } from '../base/rules.js';
import { counted, integer } from '../base/sentences.js';
import { rules } from '../library/arguments.js';
import type { CvtOptions } from '../api/options.js';
import type { CvtState, Diagram, Mesh } from '../api/types.js';
import { noteCoarseTessellation, openDiagram } from './diagrams.js';
import {
  diagramEncoders,
  distancesEncoders,
  encoderOf,
  isJsonReport,
  locatedEncoders,
  partitionEncoders,
  pathsEncoders,
  polygonEncoders,
  requireOwnFormat,
  sitesEncoders,
} from './encoders.js';
import { fail } from './failure.js';
import { FileError, Output } from './files.js';
import { meshReport } from './mesh_report.js';
import type { CommandName, Invocation, Values } from './options.js';
import { pathsBetween } from './paths.js';
import { readNumbers, readPoints } from './points.js';
import { withProgress } from './progress.js';
import {
  allOnSurface,
  countOf,
  lengthsOf,
  meshNotes,
  openMesh,
  openWithSites,
  writeNotes,
} from './sites.js';
import type { Lengths } from './values.js';

type Request<Command extends CommandName> = Extract<Invocation, { command: Command }>;

const commands: { [Name in CommandName]: (request: Request<Name>) => Promise<void> } = {
  info,
  diagram,
  locate,
  distances,
  path,
  cvt,
  partition,
  dual,
  remesh,
};

export function execute<Name extends CommandName>(request: Request<Name>): Promise<void> {
  return commands[request.command](request);
}

/** A mesh that fails does not keep the others from being reported, unless the report would replace it. */
async function info({ meshes, values }: Request<'info'>): Promise<void> {
  const isJson = isJsonReport(values);
  const output = await Output.open(values);
  const isOnly = meshes.length === 1;
  const reports: string[] = [];
  const list: object[] = [];
  for (const path of meshes) {
    try {
      const facts = await factsOf(path, output, values);
      const isSubdivided = values['max-edge'] > 0;
      const report = meshReport(facts, { unit: facts.unit, isSubdivided });
      reports.push(isOnly ? report : `${path}\n${report}`);
      list.push({ ...(!isOnly && { mesh: path }), ...facts });
    } catch (error) {
      if (isOnly) throw error;
      // If this was the reason, there is no place for a report.
      output.requireNoModel();
      fail(error as Error);
      list.push({ mesh: path, error: (error as Error).message });
    }
  }
  if (reports.length === 0 && !isJson) return;
  await output.write(
    isJson ? `${JSON.stringify(isOnly ? list[0] : list, null, 2)}\n` : reports.join('\n'),
  );
}

async function factsOf(
  path: string,
  output: Output,
  values: Values<'info'>,
): Promise<MeshInfo & Pick<Mesh, 'parts'> & Lengths> {
  const mesh = await openMesh(path, output, values);
  const { info, parts } = mesh;
  const { scale, unit } = lengthsOf(mesh, values);
  return {
    scale,
    unit,
    ...info,
    area: scale * scale * info.area,
    boundingDiagonal: scale * info.boundingDiagonal,
    repairs: { ...info.repairs, mollification: scale * info.repairs.mollification },
    parts,
  };
}

async function diagram({ mesh: path, values }: Request<'diagram'>): Promise<void> {
  const encode = encoderOf(diagramEncoders, values);
  const output = await Output.open(values);
  const { mesh, diagram } = await openDiagram(path, output, values);
  await output.write(encode(diagram, lengthsOf(mesh, values)));

  const { arcs, voronoiPoints } = diagram.data;
  output.summarise(
    [
      counted(countOf(diagram.sites), 'region'),
      counted(arcs.offset.length - 1, 'bisector arc'),
      counted(voronoiPoints.point.length, 'Voronoi point'),
    ].join(', '),
  );
}

async function locate({ mesh: path, values }: Request<'locate'>): Promise<void> {
  const encode = encoderOf(locatedEncoders, values);
  const output = await Output.open(values);
  const points = await readPoints(values.points);
  const { mesh, diagram } = await openDiagram(path, output, values);
  const located = await diagram.locate(await allOnSurface(mesh, points, values));
  await output.write(encode({ mesh, ...located }, lengthsOf(mesh, values)));
}

async function distances({ mesh: path, values }: Request<'distances'>): Promise<void> {
  const { scale } = values.units;
  const encode = encoderOf(distancesEncoders, values);
  const output = await Output.open(values);
  const { mesh, sites } = await openWithSites(path, output, values);
  const { metric } = values;
  const distances = await withProgress(values, (onProgress) =>
    mesh.distances(sites, { metric, onProgress }),
  );
  await output.write(encode({ mesh, distances }, lengthsOf(mesh, values)));
  const reached = distances.distance.filter((d) => d < Infinity);
  const farthest = reached.reduce((most, d) => Math.max(most, d), 0);
  const onSurface = distances.label.length - mesh.info.repairs.isolatedVertices;
  output.summarise(
    `${integer(reached.length)} of ${counted(onSurface, 'vertex', 'vertices')} reached, ` +
      `the farthest at ${(scale * farthest).toPrecision(6)}`,
  );
}

async function path({ mesh: model, values }: Request<'path'>): Promise<void> {
  const { scale } = values.units;
  const encode = encoderOf(pathsEncoders, values);
  const output = await Output.open(values);
  const [from, to] = [await readPoints(values.from), await readPoints(values.to)];
  const mesh = await openMesh(model, output, values);
  writeNotes(meshNotes(mesh), values);
  const starts = await allOnSurface(mesh, from, values);
  const ends = await allOnSurface(mesh, to, values);
  const paths = await withProgress(values, (onProgress) =>
    pathsBetween(mesh, starts, ends, onProgress),
  );
  await output.write(encode(paths, lengthsOf(mesh, values)));
  const lengths = paths.map(({ length }) => scale * length).filter((length) => length < Infinity);
  const missing = paths.length - lengths.length;
  if (missing > 0)
    process.stderr.write(
      `warning: there is no path between ${counted(missing, 'pair')} of points: they are on different components of the surface (info tells where it is cut apart)\n`,
    );
  if (lengths.length === 0) return;
  const shortest = lengths.reduce((least, length) => Math.min(least, length));
  const longest = lengths.reduce((most, length) => Math.max(most, length));
  output.summarise(
    `${counted(lengths.length, 'path')}, of length ` +
      [...new Set([shortest, longest])].map((length) => length.toPrecision(6)).join(' to '),
  );
}

async function cvt({ mesh: path, values }: Request<'cvt'>): Promise<void> {
  const { scale } = values.units;
  const encode = encoderOf(sitesEncoders, values);
  const output = await Output.open(values);
  const settings = await cvtSettings(values);
  const { mesh, sites } = await openWithSites(path, output, values, {
    density: settings.density,
  });
  const energy: number[] = [];
  const { iteration, sites: last } = await withProgress(values, async (onProgress) => {
    let state: CvtState | undefined;
    for await (state of mesh.cvt(sites, { ...settings, onProgress })) energy.push(state.energy);
    return state!;
  });
  if (!values.quiet) {
    const diagram = await mesh.voronoi(last, { metric: settings.metric });
    await noteCoarseTessellation(diagram, values);
  }
  const position = await mesh.positionsOf(last);
  await output.write(encode({ mesh, sites: last, position, energy }, lengthsOf(mesh, values)));
  const shown = (e: number) => (scale ** 4 * e).toPrecision(6); // area times squared length
  output.summarise(
    `${counted(countOf(last), 'site')}, ${counted(iteration, 'iteration')}` +
      `${iteration > 0 && iteration === values.iterations ? ' (no more were allowed)' : ''}, ` +
      `energy ${[...new Set([shown(energy[0]), shown(energy.at(-1)!)])].join(' to ')}`,
  );
}

async function partition({ mesh: path, values }: Request<'partition'>): Promise<void> {
  requireOwnFormat(values);
  const encode = encoderOf(partitionEncoders, values);
  const output = await Output.open(values);
  const { mesh, diagram } = await openDiagram(path, output, values);
  const { sites } = diagram;
  const { layout, region } = values;
  const ofDiagram = integers(-1, sites.face.length - 1);
  if (region !== undefined && !ofDiagram.allows(region))
    throw new FileError(`--region is ${region}, not ${ofDiagram.words}`);
  const partition = await diagram.partition({
    leaveOutIndifferent: values['leave-out-indifferent'],
    leaveOutUnreachable: values['leave-out-unreachable'],
  });
  const { label } = partition.triangles;
  if (region !== undefined && !label.includes(region))
    throw new FileError(`--region is ${region}: the partition has no triangles of it`);
  await output.write(encode({ mesh, sites, partition, layout, region }, lengthsOf(mesh, values)));
  const { components, loops, eulerCharacteristic } = partition.regions;
  const disks = components.filter(
    (count, i) => count === 1 && loops[i] === 1 && eulerCharacteristic[i] === 1,
  );
  output.summarise(
    `${counted(countOf(sites), 'region')}, ${integer(disks.length)} of them ` +
      `${disks.length === 1 ? 'a disk' : 'disks'}, ` +
      (region === undefined
        ? counted(label.length, 'triangle')
        : `${counted(label.filter((each) => each === region).length, 'triangle')} written`),
  );
}

async function dual({ mesh: path, values }: Request<'dual'>): Promise<void> {
  const encode = encoderOf(polygonEncoders, values);
  const output = await Output.open(values);
  const { repair: addsSites } = values;
  const { mesh, diagram: given } = await openDiagram(path, output, values, { addsSites });
  const diagram = values.repair
    ? await withProgress(values, (onProgress) =>
        explained(mesh, () => given.repair({ maxAdded: values['max-added'], onProgress })),
      )
    : given;
  const polygons = await diagram.dual({ primal: values.primal });
  const violations = await diagram.violations();
  if (values.check && violations.length > 0) throw new FileError(faultsOf(violations));
  await output.write(
    encode({ mesh, sites: diagram.sites, polygons, violations }, lengthsOf(mesh, values)),
  );
  output.summarise(polygonSummary(countOf(given.sites), diagram, polygons));
  if (violations.length === 0) return;
  if (values.quiet) {
    process.stderr.write(`warning: ${faultsOf(violations)}\n`);
    return;
  }
  for (const { message } of violations) process.stderr.write(`not valid: ${message}\n`);
  writeNotes(['--repair adds sites until it is valid'], values);
}

/** One line about a dual that is not valid. */
function faultsOf([first, ...more]: Violation[]): string {
  return (
    `the dual is not valid: ${first.message}` +
    (more.length > 0 ? `, and ${more.length} more` : '') +
    ' (--repair adds sites until it is)'
  );
}

async function remesh({ mesh: path, values }: Request<'remesh'>): Promise<void> {
  const { scale } = values.units;
  const encode = encoderOf(polygonEncoders, values);
  const output = await Output.open(values);
  const settings = await cvtSettings(values);
  const { mesh, sites } = await openWithSites(path, output, values, {
    density: settings.density,
    addsSites: true,
  });
  const diagram = await withProgress(values, (onProgress) =>
    explained(mesh, () =>
      mesh.remesh(sites, { ...settings, maxAdded: values['max-added'], onProgress }),
    ),
  );
  await noteCoarseTessellation(diagram, values);
  const polygons = await diagram.dual();
  const quality = await diagram.remeshQuality();
  await output.write(
    encode({ mesh, sites: diagram.sites, polygons, quality }, lengthsOf(mesh, values)),
  );
  const number = (x: number) => String(Number(x.toPrecision(4)));
  output.summarise(
    `${polygonSummary(countOf(sites), diagram, polygons)}\n` +
      `${counted(quality.triangles, 'triangle')}: least angle ${number(quality.minAngle)}°, ` +
      `mean of the least ones ${number(quality.meanMinAngle)}°; ` +
      `valence ${quality.minValence} to ${quality.maxValence}, ` +
      `${number(100 * quality.regularShare)} % have 6; ` +
      `Hausdorff distance ${number(scale * quality.hausdorff)} ` +
      `(${number((100 * quality.hausdorff) / mesh.info.boundingDiagonal)} % of the bounding diagonal)`,
  );
}

/** The options of a tessellation, by those of the command line. */
async function cvtSettings(values: Values<'cvt'>): Promise<CvtOptions> {
  const { method, metric, iterations, 'energy-tolerance': energyTolerance } = values;
  const moveTolerance = values['move-tolerance'] / values.units.scale;
  const numbers = (file: string | undefined, rule: Rule) =>
    file === undefined ? undefined : readNumbers(file, rule);
  const named = (['attribute', 'curvature'] as const).find((name) => name === values.density);
  const density = named ?? (await numbers(values.density, length));
  const fixedSites = await numbers(values['fixed-sites'], rules.label);
  return { method, metric, iterations, energyTolerance, moveTolerance, density, fixedSites };
}

/** Carries a repair out; if as many sites as may be added are too few, says what may help. */
async function explained<Result>(mesh: Mesh, repair: () => Promise<Result>): Promise<Result> {
  try {
    return await repair();
  } catch (error) {
    if (!(error instanceof GeodesicVoronoiError) || error.code !== 'too-few-sites') throw error;
    const { components } = mesh.info;
    const advice =
      components === 1
        ? '--max-edge 0.05 makes triangles shorter, --max-added allows more sites'
        : `the mesh has ${components} components: --min-component drops small ones, ` +
          '--per-component 3 begins with sites on each';
    throw new FileError(`${error.message} (${advice})`, { cause: error });
  }
}

function polygonSummary(first: number, diagram: Diagram, { topology }: PolygonMesh): string {
  const sites = countOf(diagram.sites);
  const added = sites - first;
  const { vertices, faces, eulerCharacteristic, genus, boundaryLoops, isManifold } = topology;
  return (
    `${counted(sites, 'site')}${added > 0 ? ` (${integer(added)} added)` : ''}, ` +
    `${counted(vertices, 'vertex', 'vertices')}, ${counted(faces, 'polygon')}, ` +
    (isManifold
      ? `Euler characteristic ${eulerCharacteristic}, genus ${genus}, ${counted(boundaryLoops, 'boundary loop')}`
      : 'no manifold')
  );
}
