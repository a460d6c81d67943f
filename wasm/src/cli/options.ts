// SPDX-License-Identifier: MIT
//
// The command line's one table: what can be given, to which command, and what its help says.

import { parseArgs } from 'node:util';

/** The command line is wrong, not what it names: exit status 2. */
export class UsageError extends Error {}

/** Standard input or output, where a file is asked for. */
export const standard = '-';

interface OptionSpec {
  type: 'string' | 'boolean';
  short?: string;
  /** What the help calls its value. */
  value?: string;
  help: string;
}

const options = {
  sites: {
    type: 'string',
    value: 'N|FILE',
    help: 'Number of sites to sample, or a JSON file of them',
  },
  sampling: {
    type: 'string',
    value: 'METHOD',
    help: 'How to sample N sites: random (the default), farthest, poisson',
  },
  seed: {
    type: 'string',
    value: 'S',
    help: 'Seed of the sampling (default 1); the same gives the same sites',
  },
  points: { type: 'string', value: 'FILE', help: 'JSON file of the points to locate' },
  metric: { type: 'string', value: 'METRIC', help: 'dgpc: approximate, fast (the default); exact' },
  detail: {
    type: 'string',
    value: 'N',
    help: 'Split triangles of several regions in four, N times (default 0)',
  },
  iterations: { type: 'string', value: 'N', help: 'How many iterations at most (default 50)' },
  method: {
    type: 'string',
    value: 'METHOD',
    help: 'lbfgs: quasi-Newton, converges faster (the default); lloyd',
  },
  layout: {
    type: 'string',
    value: 'LAYOUT',
    help: 'Of a .glb: regions: a node with a primitive for each (the default); features: one mesh with region ids (EXT_mesh_features)',
  },
  holes: {
    type: 'boolean',
    help: 'Leave holes where regions tie on whole triangles, instead of giving these to the lowest; with --metric exact',
  },
  repair: { type: 'boolean', help: 'Add sites until the dual is valid' },
  primal: { type: 'boolean', help: 'The regions as polygons, instead of the dual' },
  units: {
    type: 'string',
    value: 'UNIT|FACTOR',
    help: 'Unit of lengths in the output, of a model in metres as glTF has it: m (the default), cm, mm, km, in, ft; or the factor to multiply with',
  },
  output: {
    type: 'string',
    short: 'o',
    value: 'FILE',
    help: 'Where to write, - for standard output (the default)',
  },
  json: { type: 'boolean', help: 'Write JSON, whatever FILE is called' },
  progress: { type: 'boolean', help: 'Show progress even if standard error is no terminal' },
  quiet: { type: 'boolean', short: 'q', help: 'Write nothing to standard error but errors' },
  help: { type: 'boolean', short: 'h', help: 'Show this help' },
} as const satisfies Record<string, OptionSpec>;

type OptionName = keyof typeof options;
export type Values = {
  [Name in OptionName]?: (typeof options)[Name]['type'] extends 'string' ? string : boolean;
};

interface CommandSpec {
  summary: string;
  /** What -o writes, for the help. */
  result: string;
  options: OptionName[];
}

export const commands = {
  info: {
    summary: 'Counts, topology, measures and repairs of a mesh',
    result: 'Text for people; with --json an object.',
    options: ['json', 'units', 'output', 'quiet', 'help'],
  },
  diagram: {
    summary: 'The geodesic Voronoi diagram of sites on a mesh',
    result: `By FILE's ending: .json (regions, bisectors, Voronoi points), .obj or .glb (the bisectors as lines).`,
    options: [
      'sites',
      'sampling',
      'seed',
      'metric',
      'detail',
      'units',
      'output',
      'json',
      'progress',
      'quiet',
      'help',
    ],
  },
  locate: {
    summary: 'The nearest site of points on a mesh, and its distance',
    result: '{"label": […], "distance": […]}; -1 and null for a point that no site reaches.',
    options: [
      'sites',
      'points',
      'sampling',
      'seed',
      'metric',
      'units',
      'output',
      'json',
      'progress',
      'quiet',
      'help',
    ],
  },
  cvt: {
    summary: 'Sites at the centroids of their regions: a centroidal Voronoi tessellation',
    result:
      '{"face": […], "bary": […], "energy": […]}: the sites, and the energy of the first ones and after each iteration.',
    options: [
      'sites',
      'iterations',
      'method',
      'metric',
      'sampling',
      'seed',
      'units',
      'output',
      'json',
      'progress',
      'quiet',
      'help',
    ],
  },
  partition: {
    summary: 'The mesh cut into the regions of sites, watertight where it was',
    result: `By FILE's ending: .glb, .obj (a group per region), .ply (a label per face), .json (triangles, and facts of each region).`,
    options: [
      'sites',
      'layout',
      'holes',
      'sampling',
      'seed',
      'metric',
      'detail',
      'units',
      'output',
      'json',
      'progress',
      'quiet',
      'help',
    ],
  },
  dual: {
    summary: 'The polygonal base mesh of sites: a vertex each, a polygon per Voronoi point',
    result: `By FILE's ending: .obj or .ply (polygons), .glb (triangles), .json (polygons, sites, and what is wrong with the dual).`,
    options: [
      'sites',
      'repair',
      'primal',
      'sampling',
      'seed',
      'metric',
      'units',
      'output',
      'json',
      'progress',
      'quiet',
      'help',
    ],
  },
  remesh: {
    summary: 'An isotropic remesh: the valid dual of a centroidal tessellation',
    result: `By FILE's ending: .obj or .ply (polygons), .glb (triangles), .json (polygons, sites and quality). Sites may be added until it is valid.`,
    options: [
      'sites',
      'iterations',
      'method',
      'metric',
      'sampling',
      'seed',
      'units',
      'output',
      'json',
      'progress',
      'quiet',
      'help',
    ],
  },
} as const satisfies Record<string, CommandSpec>;

export type CommandName = keyof typeof commands;

export interface Invocation {
  command: CommandName;
  mesh: string;
  values: Values;
}

/** Takes a command line apart. A text is what to print instead of doing anything. */
export function parseCommandLine(args: string[], version: string): Invocation | string {
  const [command, ...rest] = args;
  if (command === undefined)
    throw new UsageError('a command is missing: see geodesic-voronoi --help');
  if (command === '--help' || command === '-h') return overview();
  if (command === '--version') return `${version}\n`;
  if (!isCommand(command))
    throw new UsageError(`'${command}' is not one of ${listed(Object.keys(commands))}`);

  const { values, positionals } = parseOptions(command, rest);
  if (values.help) return commandHelp(command);
  if (positionals.length !== 1) {
    throw new UsageError(
      positionals.length === 0
        ? 'a mesh is missing'
        : `one mesh at a time: '${positionals[1]}' is one too many`,
    );
  }
  const [mesh] = positionals;
  if ([mesh, values.sites, values.points].filter((path) => path === standard).length > 1) {
    throw new UsageError('only one file can be standard input');
  }
  return { command, mesh, values };
}

function parseOptions(
  command: CommandName,
  args: string[],
): { values: Values; positionals: string[] } {
  const known = Object.fromEntries(commands[command].options.map((name) => [name, options[name]]));
  try {
    return parseArgs({ args, options: known, allowPositionals: true });
  } catch (error) {
    if (!(error instanceof TypeError)) throw error;
    // Node's hint about '--' that follows the first sentence only confuses here.
    throw new UsageError(error.message.split(/\.\s/)[0]);
  }
}

export function listed(names: readonly string[]): string {
  return names.join(', ');
}

function isCommand(name: string): name is CommandName {
  return Object.hasOwn(commands, name);
}

function overview(): string {
  return `Geodesic Voronoi diagrams on triangle meshes

Usage: geodesic-voronoi COMMAND MESH [OPTIONS]

${table(Object.entries(commands).map(([name, { summary }]) => [name, summary]))}

MESH is a glTF file (.glb, or .gltf with its buffers in its folder), - for standard input.
geodesic-voronoi COMMAND --help shows a command's options, geodesic-voronoi --version the version.

A file of sites or points is {"face": [i, …], "bary": [b0, b1, b2, …]} or {"vertex": [i, …]}; faces
count the mesh's triangles, vertices its positions, both in scene order.

Exit status: 0 done, 1 bad input, 2 a wrong command line.
`;
}

function commandHelp(command: CommandName): string {
  const { summary, result, options: names } = commands[command];
  const rows = names.map((name): [string, string] => {
    const { short, value, help }: OptionSpec = options[name];
    return [`${short ? `-${short}, ` : '    '}--${name}${value ? ` ${value}` : ''}`, help];
  });
  return `${summary}

Usage: geodesic-voronoi ${command} MESH [OPTIONS]

${table(rows)}

Output: ${result}
`;
}

function table(rows: [string, string][]): string {
  const width = Math.max(...rows.map(([name]) => name.length));
  return rows.map(([name, text]) => `  ${name.padEnd(width)}  ${text}`).join('\n');
}
