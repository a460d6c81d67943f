// SPDX-License-Identifier: MIT
//
// The command line's one table: what can be given, to which command, what it means, and what the help
// says of it.

import { parseArgs } from 'node:util';
import { maxCount, maxDetail, maxLimit } from '../input.js';
import { partitionLayouts } from '../partition_formats.js';
import { cvtMethods, metrics, orientations, samplings, worstRegions } from '../results.js';
import { gltfLimitNames } from '../types.js';
import {
  assignments,
  integer,
  listed,
  number,
  numberOrPath,
  oneOf,
  path,
  scale,
  units,
  UsageError,
  type Parser,
} from './values.js';

/** Standard input or output, where a file is asked for. */
export const standard = '-';

/** One with a value, or a switch. */
interface OptionSpec {
  short?: string;
  /** What the help calls its value. */
  value?: string;
  parse?: Parser<unknown>;
  /** What counts if it is not given; without this, it has to be, unless it is optional. */
  default?: string;
  optional?: true;
  help: string;
}

/** In the order of the help. */
const options = {
  sites: {
    value: 'N|FILE',
    parse: numberOrPath(1, maxCount),
    optional: true,
    help: 'Number of sites to sample, or a JSON file of them',
  },
  radius: {
    value: 'R',
    parse: number((r) => r > 0 && r < Infinity, 'a positive number'),
    optional: true,
    help: 'Instead of --sites: sample as many as it takes until no vertex is farther from one than this',
  },
  sampling: {
    value: 'METHOD',
    parse: oneOf([...samplings, ...worstRegions]),
    optional: true,
    help: `How to sample: ${listed(samplings)}; size, distortion: always in the region where that is worst (default: random, with --radius farthest)`,
  },
  'per-component': {
    value: 'N',
    parse: integer(0, maxCount),
    default: '0',
    help: 'How many of the sites that are sampled are at least on each component',
  },
  seed: {
    value: 'S',
    parse: integer(0),
    default: '1',
    help: 'Seed of the sampling; the same gives the same sites',
  },
  points: { value: 'FILE', parse: path, help: 'JSON file of the points to locate' },
  from: { value: 'FILE', parse: path, help: 'JSON file of the points at which paths start' },
  to: {
    value: 'FILE',
    parse: path,
    help: 'JSON file of the points at which they end: as many, or one for all',
  },
  iterations: {
    value: 'N',
    parse: integer(0, maxCount),
    default: '50',
    help: 'How many iterations at most',
  },
  method: {
    value: 'METHOD',
    parse: oneOf(cvtMethods),
    default: 'lbfgs',
    help: 'lbfgs: quasi-Newton, converges faster; lloyd',
  },
  density: {
    value: 'FILE|attribute|curvature',
    parse: path,
    optional: true,
    help: 'Sites are closer where it is higher: a JSON list of a density per vertex; attribute: that of the mesh file (_DENSITY of a glTF, density of a PLY); or by curvature',
  },
  fixed: {
    value: 'FILE',
    parse: path,
    optional: true,
    help: 'JSON list of the indices of sites that stay where they are',
  },
  layout: {
    value: 'LAYOUT',
    parse: oneOf(partitionLayouts),
    default: 'regions',
    help: 'Of a .glb: regions: a node with a primitive for each; features: one mesh with region ids (EXT_mesh_features)',
  },
  holes: {
    help: 'Leave holes where regions tie on whole triangles, instead of giving these to the lowest',
  },
  repair: { help: 'Add sites until the dual is valid' },
  primal: { help: 'The regions as polygons, instead of the dual' },
  metric: {
    value: 'METRIC',
    parse: oneOf(metrics),
    default: metrics[0],
    help: 'exact: polyhedral distance; dgpc: approximate, quicker',
  },
  detail: {
    value: 'N',
    parse: integer(0, maxDetail),
    default: '0',
    help: 'Split triangles of several regions in four, N times',
  },
  units: {
    value: 'UNIT|FACTOR',
    parse: scale,
    default: 'm',
    help: `Unit of lengths in the output and of --radius, of a model in metres as glTF has it: ${listed(units)}; or the factor to multiply with`,
  },
  weld: {
    value: 'SHARE',
    parse: number((share) => share >= 0 && share <= 1, 'a number from 0 to 1'),
    default: '0',
    help: "Weld vertices no farther apart than this share of the bounding box's diagonal",
  },
  orientation: {
    value: 'RULE',
    parse: oneOf(orientations),
    default: orientations[0],
    help: 'unify: turn triangles over to agree with their neighbours; keep: cut the surface where they do not',
  },
  'min-component': {
    value: 'N',
    parse: integer(0, maxCount),
    default: '0',
    help: 'Drop components of fewer triangles',
  },
  limits: {
    value: 'NAME=N,…',
    parse: assignments(gltfLimitNames, maxLimit),
    default: '',
    help: `What a file may ask for, where more is wanted: ${listed(gltfLimitNames)}`,
  },
  output: {
    short: 'o',
    value: 'FILE',
    parse: path,
    default: standard,
    help: 'Where to write, - for standard output',
  },
  json: { help: 'Write JSON, whatever FILE is called' },
  progress: { help: 'Show progress even if standard error is no terminal' },
  quiet: { short: 'q', help: 'Write nothing to standard error but errors' },
  help: { short: 'h', help: 'Show this help' },
} as const satisfies Record<string, OptionSpec>;

type OptionName = keyof typeof options;

/** What all options mean, given or not. */
type AllValues = {
  [Name in OptionName]: (typeof options)[Name] extends { parse: Parser<infer Value> }
    ? (typeof options)[Name] extends { optional: true }
      ? Value | undefined
      : Value
    : boolean;
};

const ofSites = ['sites', 'radius', 'sampling', 'per-component', 'seed'] as const;
const ofMesh = ['weld', 'orientation', 'min-component', 'limits'] as const;
const ofAll = [...ofMesh, 'units', 'output', 'json', 'quiet', 'help'] as const;

interface CommandSpec {
  summary: string;
  /** What -o writes, for the help. */
  result: string;
  /** How it is called, after the command's name. */
  examples: readonly string[];
  options: readonly OptionName[];
}

export const commands = {
  info: {
    summary: 'Counts, topology, measures and repairs of a mesh, or of several',
    result:
      'Text for people; with --json an object, of several meshes a list of these, each with its "mesh", and an "error" instead if it cannot be read.',
    examples: ['mesh.glb', 'mesh.glb --json --units cm', 'a.glb b.obj --weld 1e-6'],
    options: ofAll,
  },
  diagram: {
    summary: 'The geodesic Voronoi diagram of sites on a mesh',
    result: `By FILE's ending: .json (regions, bisectors, Voronoi points), .obj or .glb (the bisectors as lines).`,
    examples: [
      'mesh.glb --sites 300 -o diagram.json',
      'mesh.glb --sites sites.json --detail 2 -o bisectors.obj',
    ],
    options: [...ofSites, 'metric', 'detail', 'progress', ...ofAll],
  },
  locate: {
    summary: 'The nearest site of points on a mesh, and its distance',
    result: '{"label": […], "distance": […]}; -1 and null for a point that no site reaches.',
    examples: ['mesh.glb --sites sites.json --points points.json -o labels.json'],
    options: [...ofSites, 'points', 'metric', 'progress', ...ofAll],
  },
  distances: {
    summary: 'The nearest site of every vertex of a mesh, its distance and direction',
    result: `By FILE's ending: .json {"label": […], "distance": […], "direction": […]} (-1 and null where no site reaches), .ply (properties of the vertices), .glb (attributes _LABEL and _DISTANCE, -1 where no site reaches).`,
    examples: ['mesh.glb --sites sites.json -o distances.ply'],
    options: [...ofSites, 'metric', 'progress', ...ofAll],
  },
  path: {
    summary: 'Shortest paths between points on a mesh',
    result: `By FILE's ending: .json {"paths": [{"points", "length"}, …]} (no points and null where there is none), .obj (a polyline each).`,
    examples: ['mesh.glb --from a.json --to b.json -o path.obj'],
    options: ['from', 'to', 'progress', ...ofAll],
  },
  cvt: {
    summary: 'Sites at the centroids of their regions: a centroidal Voronoi tessellation',
    result:
      '{"face": […], "bary": […], "energy": […]}: the sites, and the energy of the first ones and after each iteration.',
    examples: [
      'mesh.glb --sites 300 -o sites.json',
      'mesh.glb --sites sites.json --fixed fixed.json --density density.json -o moved.json',
      'mesh.glb --sites 300 --per-component 1 --density curvature -o sites.json',
    ],
    options: [
      ...ofSites,
      'iterations',
      'method',
      'density',
      'fixed',
      'metric',
      'progress',
      ...ofAll,
    ],
  },
  partition: {
    summary: 'The mesh cut into the regions of sites, watertight where it was',
    result: `By FILE's ending: .glb, .obj (a group per region), .ply (a label per face), .json (triangles, and facts of each region).`,
    examples: [
      'mesh.glb --sites 300 -o parts.glb',
      'mesh.glb --sites sites.json --layout features -o parts.glb',
    ],
    options: [...ofSites, 'layout', 'holes', 'metric', 'detail', 'progress', ...ofAll],
  },
  dual: {
    summary: 'The polygonal base mesh of sites: a vertex each, a polygon per Voronoi point',
    result: `By FILE's ending: .obj or .ply (polygons), .glb (triangles), .json (polygons, sites, and what is wrong with the dual).`,
    examples: ['mesh.glb --sites 300 --repair -o base.obj'],
    options: [...ofSites, 'repair', 'primal', 'metric', 'progress', ...ofAll],
  },
  remesh: {
    summary: 'An isotropic remesh: the valid dual of a centroidal tessellation',
    result: `By FILE's ending: .obj or .ply (polygons), .glb (triangles), .json (polygons, sites and quality). Sites may be added until it is valid.`,
    examples: ['mesh.glb --sites 1000 -o fine.obj'],
    options: [...ofSites, 'iterations', 'method', 'metric', 'progress', ...ofAll],
  },
} as const satisfies Record<string, CommandSpec>;

export type CommandName = keyof typeof commands;

/** What the options of a command mean. */
export type Values<Command extends CommandName = CommandName> = Pick<
  AllValues,
  (typeof commands)[Command]['options'][number]
>;

/** What to do: each command with a mesh (info with any number) and the values of its own options. */
export type Invocation = {
  [Command in CommandName]: {
    command: Command;
    mesh: string;
    meshes: string[];
    values: Values<Command>;
  };
}[CommandName];

/** Takes a command line apart. A text is what to print instead of doing anything. */
export function parseCommandLine(args: string[], version: string): Invocation | string {
  const [command, ...rest] = args;
  if (command === undefined)
    throw new UsageError('a command is missing: see geodesic-voronoi --help');
  if (command === '--help' || command === '-h') return overview();
  if (command === '--version') return `${version}\n`;
  if (!isCommand(command))
    throw new UsageError(`'${command}' is not one of ${listed(Object.keys(commands))}`);

  const { texts, positionals } = parseOptions(command, rest);
  if (texts.help) return commandHelp(command);
  if (positionals.length === 0) throw new UsageError('a mesh is missing');
  if (positionals.length > 1 && command !== 'info')
    throw new UsageError(`one mesh at a time: '${positionals[1]}' is one too many`);
  const { sites, points, from, to, density, fixed } = texts;
  const paths = [...positionals, sites, points, from, to, density, fixed];
  if (paths.filter((path) => path === standard).length > 1)
    throw new UsageError('only one file can be standard input');
  const names: readonly OptionName[] = commands[command].options;
  const values = Object.fromEntries(names.map((name) => [name, parsedValue(name, texts[name])]));
  if (names.includes('sites')) requireSites(values as Values<'diagram'>);
  return { command, mesh: positionals[0], meshes: positionals, values } as Invocation;
}

/** There is one source of sites; those of a file are where they are. */
function requireSites(values: Values<'diagram'>): void {
  const { sites, radius, sampling } = values;
  if (sites === undefined && radius === undefined) throw new UsageError('--sites is missing');
  if (sites !== undefined && radius !== undefined)
    throw new UsageError('--radius is instead of --sites: give one of them');
  if (radius !== undefined && sampling && sampling !== 'farthest' && sampling !== 'poisson')
    throw new UsageError(`--sampling ${sampling} takes a number of sites, not --radius`);
  if (typeof sites === 'string' && values['per-component'] > 0)
    throw new UsageError('--per-component is for sites that are sampled, not those of a file');
}

/** Options as they are given. */
type Texts = { [Name in OptionName]?: string | boolean };

function parseOptions(
  command: CommandName,
  args: string[],
): { texts: Texts; positionals: string[] } {
  const known = commands[command].options.map((name) => {
    const { short, value }: OptionSpec = options[name];
    return [name, { type: value ? 'string' : 'boolean', ...(short && { short }) }] as const;
  });
  try {
    const { values, positionals } = parseArgs({
      args,
      options: Object.fromEntries(known),
      allowPositionals: true,
    });
    return { texts: values as Texts, positionals };
  } catch (error) {
    if (!(error instanceof TypeError)) throw error;
    // Node's hint about '--' that follows the first sentence only confuses here.
    throw new UsageError(error.message.split(/\.\s/)[0]);
  }
}

function parsedValue(name: OptionName, given: string | boolean | undefined): unknown {
  const { parse, default: usual, optional }: OptionSpec = options[name];
  if (!parse) return given === true;
  const text = given ?? usual;
  if (text === undefined && optional) return undefined;
  if (typeof text !== 'string') throw new UsageError(`--${name} is missing`);
  return parse(text, `--${name}`);
}

function isCommand(name: string): name is CommandName {
  return Object.hasOwn(commands, name);
}

function overview(): string {
  return `Geodesic Voronoi diagrams on triangle meshes

Usage: geodesic-voronoi COMMAND MESH [OPTIONS]

${table(Object.entries(commands).map(([name, { summary }]) => [name, summary]))}

MESH is a glTF (.glb, or .gltf with its buffers in its folder; also with Draco or meshopt), an OBJ, a PLY
or an STL file, a .zip or a folder with one of them (of several: parts.zip#wheel.obj), or - for standard
input.
geodesic-voronoi COMMAND --help shows a command's options, geodesic-voronoi --version the version.

A file of sites or points is {"face": [i, …], "bary": [b0, b1, b2, …]} or {"vertex": [i, …]}; faces
count the mesh's triangles, vertices its positions, both in scene order.

Exit status: 0 done, 1 bad input, 2 a wrong command line.
`;
}

function commandHelp(command: CommandName): string {
  const { summary, result, examples, options: taken }: CommandSpec = commands[command];
  const names = Object.keys(options) as OptionName[];
  const rows = names
    .filter((name) => taken.includes(name))
    .map((name): [string, string] => {
      const { short, value, default: usual, help }: OptionSpec = options[name];
      return [
        `${short ? `-${short}, ` : '    '}--${name}${value ? ` ${value}` : ''}`,
        !usual ? help : `${help} (default: ${usual})`,
      ];
    });
  return `${summary}

Usage: geodesic-voronoi ${command} MESH${command === 'info' ? '...' : ''} [OPTIONS]

${table(rows)}

Output: ${result}

Examples:
${examples.map((example) => `  geodesic-voronoi ${command} ${example}`).join('\n')}

Exit status: 0 done, 1 bad input, 2 a wrong command line.
`;
}

function table(rows: [string, string][]): string {
  const width = Math.max(...rows.map(([name]) => name.length));
  return rows.map(([name, text]) => `  ${name.padEnd(width)}  ${text}`).join('\n');
}
