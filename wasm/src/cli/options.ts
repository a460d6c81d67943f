// SPDX-License-Identifier: MIT
//
// The command line's one table: what can be given, to which command, what it means, and what the
// help says of it.

import {
  diagramDefaults,
  limitRule,
  maxCount,
  maxDetail,
  meshDefaults,
  repairDefaults,
  rules,
  samplingDefaults,
  tessellationDefaults,
} from '../library/arguments.js';
import { integers, oneOf } from '../base/rules.js';
import { type PartitionLayout, partitionLayouts } from '../output/file_options.js';
import {
  type CvtMethod,
  type Metric,
  type Orientation,
  type Sampling,
  samplings,
} from '../api/results.js';
import { type GltfLimitName, gltfLimitNames } from '../api/options.js';
import {
  assignments,
  choice,
  number,
  numberOrPath,
  path,
  lengths,
  units,
  type Parser,
} from './values.js';

/** Standard input or output, where a file is asked for. */
export const standard = '-';

/** An option with a value, or a switch. */
export interface OptionSpec {
  short?: string;
  /** What the help calls its value. */
  value?: string;
  parse?: Parser<unknown>;
  /** The default; an option without one has to be given, unless it is optional. */
  default?: string;
  optional?: true;
  help: string;
}

/** In the order of the help. */
export const options = {
  sites: {
    value: 'N|FILE',
    parse: numberOrPath(rules.count),
    optional: true,
    help: 'Number of sites to sample, or a file of them: JSON (or that itself), on the surface or by coordinates; or a PLY or a table of numbers, by coordinates',
  },
  radius: {
    value: 'LENGTH',
    parse: number(rules.radius),
    optional: true,
    help: 'Instead of --sites: sample as many as it takes until no vertex is farther from one than this',
  },
  sampling: {
    value: 'METHOD',
    parse: choice<Sampling>(rules.sampling),
    optional: true,
    help: `How to sample: ${samplings.join(', ')}; size, distortion: one site after the other, in the largest region or the most distorted one (default: random, with --radius farthest)`,
  },
  'per-component': {
    value: 'N',
    parse: number(rules.perComponent),
    default: String(samplingDefaults.perComponent),
    help: 'The least number of sites on each component',
  },
  seed: {
    value: 'S',
    parse: number(rules.seed),
    default: String(samplingDefaults.seed),
    help: 'Seed of the sampling; the same gives the same sites',
  },
  points: {
    value: 'FILE',
    parse: path,
    help: 'The points to locate: a file as of --sites, or JSON itself',
  },
  from: {
    value: 'FILE',
    parse: path,
    help: 'The points at which paths start: a file of points (see geodesic-voronoi --help), or JSON itself',
  },
  to: {
    value: 'FILE',
    parse: path,
    help: 'The points at which they end, likewise: as many, or one of either for all',
  },
  iterations: {
    value: 'N',
    parse: number(rules.iterations),
    default: String(tessellationDefaults.iterations),
    help: 'How many iterations at most; of remesh, in each of up to three rounds',
  },
  method: {
    value: 'METHOD',
    parse: choice<CvtMethod>(rules.method),
    default: tessellationDefaults.method,
    help: 'lbfgs: quasi-Newton, converges faster; lloyd',
  },
  density: {
    value: 'FILE|attribute|curvature',
    parse: path,
    optional: true,
    help: 'Sites are closer where it is higher, random ones from the beginning, others through iterations: a file with a density per vertex, as JSON list or one per line; attribute: that of the mesh file (_DENSITY of a glTF, density of a PLY); or by curvature',
  },
  'fixed-sites': {
    value: 'FILE',
    parse: path,
    optional: true,
    help: 'Indices of sites that stay where they are: a file with a JSON list or one per line, or JSON itself, as [0, 1]',
  },
  'energy-tolerance': {
    value: 'SHARE',
    parse: number(rules.energyTolerance),
    default: String(tessellationDefaults.energyTolerance),
    help: 'End when an iteration lowers the energy by no more than this share',
  },
  'move-tolerance': {
    value: 'LENGTH',
    parse: number(rules.moveTolerance),
    default: String(tessellationDefaults.moveTolerance),
    help: 'End when no site moves farther than this',
  },
  layout: {
    value: 'LAYOUT',
    parse: choice<PartitionLayout>(oneOf(partitionLayouts)),
    optional: true,
    help: `Of a .glb: regions: a node with a primitive for each; features: one mesh with region ids, EXT_mesh_features (default: ${partitionLayouts[0]})`,
  },
  region: {
    value: 'N',
    parse: number(integers(-1, maxCount)),
    optional: true,
    help: 'Of an .stl: write only one region, by the index of its site; -1: what no site reaches (default: all)',
  },
  'leave-out-indifferent': {
    help: 'Leave holes where regions tie on whole triangles, instead of giving these to the lowest',
  },
  'leave-out-unreachable': { help: 'Leave out the components without a site' },
  repair: { help: 'Add sites until the dual is valid' },
  'max-added': {
    value: 'N',
    parse: number(rules.maxAdded),
    default: String(repairDefaults.maxAdded),
    help: 'How many sites may be added until the dual is valid',
  },
  check: { help: 'Write nothing and fail if the dual is not valid' },
  primal: { help: 'The regions as polygons, instead of the dual' },
  metric: {
    value: 'METRIC',
    parse: choice<Metric>(rules.metric),
    default: diagramDefaults.metric,
    help: 'exact: polyhedral distance; dgpc: approximate, quicker',
  },
  detail: {
    value: 'N',
    parse: number(rules.detail),
    default: String(diagramDefaults.detail),
    help: `Split triangles of several regions into parts about 2^N times shorter than the mean edge; at most ${maxDetail}`,
  },
  units: {
    value: 'UNIT|FACTOR',
    parse: lengths,
    default: '1',
    help: `Unit of lengths in the output, and of options that take a LENGTH, for a model in metres, the unit of glTF: ${units.join(', ')}; or the factor to multiply the model's own with. Coordinates in files of points are the model's own`,
  },
  'max-edge': {
    value: 'SHARE',
    parse: number(rules.maxEdge),
    default: String(meshDefaults.maxEdge),
    help: "Halve edges longer than this share of the bounding box's diagonal until none is; 0: leave them. Triangles are then numbered anew; sites that a result has for the whole mesh stay where they are",
  },
  weld: {
    value: 'SHARE',
    parse: number(rules.weld),
    default: String(meshDefaults.weld),
    help: "Weld vertices no farther apart than this share of the bounding box's diagonal, and join those as near to a side",
  },
  orientation: {
    value: 'RULE',
    parse: choice<Orientation>(rules.orientation),
    default: meshDefaults.orientation,
    help: 'unify: turn triangles over to agree with their neighbours; keep: cut the surface where they do not',
  },
  'min-component': {
    value: 'N',
    parse: number(rules.minComponent),
    default: String(meshDefaults.minComponent),
    help: 'Drop components of fewer triangles',
  },
  limits: {
    value: 'NAME=N,…',
    parse: assignments<GltfLimitName>(oneOf(gltfLimitNames), limitRule),
    default: '',
    help: `Higher limits on the demands of a file: ${gltfLimitNames.join(', ')}`,
  },
  output: {
    short: 'o',
    value: 'FILE',
    parse: path,
    default: standard,
    help: 'Where to write; - for standard output',
  },
  format: {
    value: 'FORMAT',
    parse: path,
    optional: true,
    help: 'Write this format, whatever FILE is called, also to standard output: an ending named below, such as json',
  },
  json: { help: 'Write JSON, whatever FILE is called' },
  progress: { help: 'Show progress even if standard error is no terminal' },
  quiet: { short: 'q', help: 'Write nothing to standard error but errors and warnings' },
  help: { short: 'h', help: 'Show this help' },
} as const satisfies Record<string, OptionSpec>;

export type OptionName = keyof typeof options;

/** The parsed values of all options, given or by default. */
type AllValues = {
  [Name in OptionName]: (typeof options)[Name] extends { parse: Parser<infer Value> }
    ? (typeof options)[Name] extends { optional: true }
      ? Value | undefined
      : Value
    : boolean;
};

const ofSites = ['sites', 'radius', 'sampling', 'per-component', 'seed'] as const;
const ofTessellation = [
  ...ofSites,
  'iterations',
  'method',
  'density',
  'fixed-sites',
  'energy-tolerance',
  'move-tolerance',
  'metric',
  'progress',
] as const;
const ofMesh = ['max-edge', 'weld', 'orientation', 'min-component', 'limits'] as const;
const ofAll = [...ofMesh, 'units', 'output', 'json', 'quiet', 'help'] as const;

export interface CommandSpec {
  summary: string;
  /** The result that -o writes, for the help; where there is --format, by the endings of files. */
  result: string;
  /** Examples of arguments after the command's name. */
  examples: readonly string[];
  options: readonly OptionName[];
}

export const commands = {
  info: {
    summary: 'Counts, topology, measures and repairs of a mesh, or of several',
    result:
      'Text for people; with --json, or as .json, an object, of several meshes a list of these, each with its "mesh", and an "error" instead if it cannot be read.',
    examples: ['mesh.glb', 'mesh.glb --json --units cm', 'a.glb b.obj --weld 1e-6'],
    options: ofAll,
  },
  diagram: {
    summary: 'The geodesic Voronoi diagram of sites on a mesh',
    result: '.json (regions, bisectors, Voronoi points), .obj or .glb (the bisectors as lines).',
    examples: [
      'mesh.glb --sites 300 -o diagram.json',
      'mesh.glb --sites sites.json --detail 2 -o bisectors.obj',
    ],
    options: [...ofSites, 'metric', 'detail', 'progress', 'format', ...ofAll],
  },
  locate: {
    summary: 'The nearest site of points on a mesh, and its distance',
    result:
      '.json {"label": […], "distance": […]} (-1 and null for a point that no site reaches), .csv (the same as columns).',
    examples: ['mesh.glb --sites sites.json --points points.json -o labels.json'],
    options: [...ofSites, 'points', 'metric', 'progress', 'format', ...ofAll],
  },
  distances: {
    summary: 'The nearest site of every vertex of a mesh, its distance and direction',
    result:
      '.json {"label": […], "distance": […], "direction": […]} (-1 and null where no site reaches), .csv (the same as columns), .ply (properties of the vertices), .glb (attributes _LABEL and _DISTANCE, -1 where no site reaches).',
    examples: ['mesh.glb --sites sites.json -o distances.ply'],
    options: [...ofSites, 'metric', 'progress', 'format', ...ofAll],
  },
  path: {
    summary: 'Shortest paths between points on a mesh',
    result:
      '.json {"paths": [{"points", "length"}, …]} (no points and null where there is none), .obj (a polyline each).',
    examples: [
      'mesh.glb --from a.json --to b.json -o path.obj',
      `mesh.glb --from '{"vertex": 0}' --to '{"vertex": 40}'`,
    ],
    options: ['from', 'to', 'progress', 'format', ...ofAll],
  },
  cvt: {
    summary: 'Sites at the centroids of their regions: a centroidal Voronoi tessellation',
    result:
      '.json {"face": […], "bary": […], "position": […], "energy": […]} (the sites, and the energy of the first ones and after each iteration), .ply (the sites as points), .csv (their coordinates).',
    examples: [
      'mesh.glb --sites 300 -o sites.json',
      'mesh.glb --sites sites.json --fixed-sites fixed.json -o new.json',
      'mesh.glb --sites 300 --per-component 1 --density curvature -o sites.json',
      'mesh.glb --sites 300 --sampling poisson --iterations 0 -o sampled.json',
    ],
    options: [...ofTessellation, 'format', ...ofAll],
  },
  partition: {
    summary: 'The mesh cut into the regions of sites, which together are watertight where it was',
    result:
      '.glb, .obj (a group per region), .ply (a label and a colour per face), .stl (triangles alone), .json (triangles, and facts of each region), .csv (these facts as a table).',
    examples: [
      'mesh.glb --sites 300 -o parts.glb',
      'mesh.glb --sites sites.json --layout features -o parts.glb',
      'mesh.glb --sites 300 --format ply > parts.ply',
      'mesh.glb --sites sites.json --region 7 -o part-7.stl',
      'mesh.glb --sites sites.json -o regions.csv',
    ],
    options: [
      ...ofSites,
      'layout',
      'region',
      'leave-out-indifferent',
      'leave-out-unreachable',
      'metric',
      'detail',
      'progress',
      'format',
      ...ofAll,
    ],
  },
  dual: {
    summary: 'The polygonal base mesh of sites: a vertex each, a polygon per Voronoi point',
    result:
      '.obj or .ply (polygons), .glb or .stl (triangles), .json (polygons, sites, and what is wrong with the dual).',
    examples: ['mesh.glb --sites 300 --repair -o base.obj'],
    options: [
      ...ofSites,
      'repair',
      'max-added',
      'check',
      'primal',
      'metric',
      'detail',
      'progress',
      'format',
      ...ofAll,
    ],
  },
  remesh: {
    summary: 'An isotropic or adaptive remesh: the valid dual of a centroidal tessellation',
    result:
      '.obj or .ply (polygons), .glb or .stl (triangles), .json (polygons, sites and quality). Sites may be added until it is valid.',
    examples: [
      'mesh.glb --sites 1000 -o fine.obj',
      'mesh.glb --sites 1000 --density curvature -o adaptive.obj',
    ],
    options: [...ofTessellation, 'max-added', 'format', ...ofAll],
  },
} as const satisfies Record<string, CommandSpec>;

export type CommandName = keyof typeof commands;

/** The parsed values of a command's options. */
export type Values<Command extends CommandName = CommandName> = Pick<
  AllValues,
  (typeof commands)[Command]['options'][number]
>;

/**
 * What to do: each command with a mesh (info with any number) and the values of its own options.
 */
export type Invocation = {
  [Command in CommandName]: {
    command: Command;
    mesh: string;
    meshes: string[];
    values: Values<Command>;
  };
}[CommandName];

/** Whether sites that are sampled are random ones, which alone follow a density. */
export function areRandom({ radius, sampling }: Pick<AllValues, 'radius' | 'sampling'>): boolean {
  return radius === undefined && (sampling ?? 'random') === 'random';
}

export function isCommand(name: string): name is CommandName {
  return Object.hasOwn(commands, name);
}
