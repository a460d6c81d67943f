// SPDX-License-Identifier: MIT
//
// The command line, taken apart by the table of commands and options.

import { parseArgs } from 'node:util';
import { nearestName } from '../base/checks.js';
import { commandHelp, help, overview } from './help.js';
import {
  areRandom,
  commands,
  isCommand,
  options,
  standard,
  type CommandName,
  type CommandSpec,
  type Invocation,
  type OptionName,
  type OptionSpec,
  type Values,
} from './options.js';
import { UsageError } from './values.js';

/** Takes a command line apart. A text is what to print instead of doing anything. */
export function parseCommandLine(args: string[], version: string): Invocation | string {
  const [command, ...rest] = args;
  if (command === undefined)
    throw new UsageError('a command is missing: see geodesic-voronoi --help');
  if (command === '--help' || command === '-h') return overview();
  if (command === 'help') return help(rest);
  if (command === '--version') return `${version}\n`;
  if (!isCommand(command))
    throw new UsageError(`'${command}' is not one of ${Object.keys(commands).join(', ')}`);

  const { texts, positionals } = parseOptions(command, rest);
  if (texts.help) return commandHelp(command);
  if (positionals.length === 0 || positionals.includes(''))
    throw new UsageError('a mesh is missing');
  if (positionals.length > 1 && command !== 'info')
    throw new UsageError(`one mesh at a time: '${positionals[1]}' is one too many`);
  const { sites, points, from, to, density, 'fixed-sites': fixedSites } = texts;
  const paths = [...positionals, sites, points, from, to, density, fixedSites];
  if (paths.filter((path) => path === standard).length > 1)
    throw new UsageError('only one file can be standard input');
  const names: readonly OptionName[] = commands[command].options;
  const values = Object.fromEntries(names.map((name) => [name, parsedValue(name, texts[name])]));
  if (names.includes('sites')) requireSites(values as Values<'cvt'>, texts);
  if (names.includes('repair') && texts['max-added'] !== undefined && !texts.repair)
    throw new UsageError('--max-added is about a repair: --repair is missing');
  return { command, mesh: positionals[0], meshes: positionals, values } as Invocation;
}

/** Requires exactly one source of sites, and no option of sampling that does not go with it. */
function requireSites(values: Values<'cvt'>, texts: Texts): void {
  const { sites, radius, sampling, density, iterations } = values;
  if (sites === undefined && radius === undefined)
    throw new UsageError('--sites N|FILE or --radius LENGTH is missing');
  if (sites !== undefined && radius !== undefined)
    throw new UsageError('--radius is instead of --sites: give one of them');
  if (radius !== undefined && sampling && sampling !== 'farthest' && sampling !== 'poisson')
    throw new UsageError(`--sampling ${sampling} takes a number of sites, not --radius`);
  const ofSampling = (['sampling', 'per-component', 'seed'] as const).find((name) => texts[name]);
  if (typeof sites === 'string' && ofSampling)
    throw new UsageError(`--${ofSampling} is for sites that are sampled, not those of a file`);
  if (density !== undefined && iterations === 0 && typeof sites !== 'string' && !areRandom(values))
    throw new UsageError(
      '--density spreads random sites and moves others in iterations: ' +
        `with --iterations 0, ${radius === undefined ? `--sampling ${sampling}` : '--radius'} does not follow it`,
    );
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
  const { values, positionals, tokens } = parseArgs({
    args,
    options: Object.fromEntries(known),
    allowPositionals: true,
    strict: false, // its own error messages are written for programmers
    tokens: true,
  });
  const given = new Set<string>();
  for (const token of tokens) {
    if (token.kind !== 'option') continue;
    requireKnown(command, token);
    if (given.has(token.name)) throw new UsageError(`${token.rawName} is given twice`);
    given.add(token.name);
  }
  return { texts: values as Texts, positionals };
}

/** An option as it stands on the command line. */
interface OptionToken {
  name: string;
  rawName: string;
  value?: string;
  inlineValue?: boolean;
}

/** The option is one of the command's, and has a value if it takes one. */
function requireKnown(
  command: CommandName,
  { name, rawName, value, inlineValue }: OptionToken,
): void {
  const taken: readonly string[] = commands[command].options;
  if (!taken.includes(name)) {
    throw new UsageError(
      `${command} has no option ${rawName.slice(0, 40)}: ${advice(command, name)}`,
    );
  }
  const takesValue = 'value' in options[name as OptionName];
  if (!takesValue && value !== undefined)
    throw new UsageError(`${rawName} is '${value}', and takes no value`);
  // One is empty where a variable of the shell is not set. What begins with a dash is an option, unless
  // it is a number or standard input.
  if (takesValue && (!value || (!inlineValue && /^-[^\d.]/.test(value))))
    throw new UsageError(`${rawName} needs a value`);
}

/** What to do about an option that a command does not have. */
function advice(command: CommandName, name: string): string {
  const nearest = nearestName(name.slice(0, 40), Object.keys(options));
  if (nearest === undefined) return `see geodesic-voronoi ${command} --help`;
  const takers = Object.entries<CommandSpec>(commands)
    .filter(([, { options: own }]) => own.some((option) => option === nearest))
    .map(([taker]) => taker);
  return takers.includes(command)
    ? `the nearest is --${nearest}`
    : `--${nearest} is an option of ${takers.join(', ')}`;
}

function parsedValue(name: OptionName, given: string | boolean | undefined): unknown {
  const { parse, default: otherwise, optional }: OptionSpec = options[name];
  if (!parse) return given === true;
  const text = given ?? otherwise;
  if (text === undefined && optional) return undefined;
  if (typeof text !== 'string') throw new UsageError(`--${name} is missing`);
  return parse(text, `--${name}`);
}
