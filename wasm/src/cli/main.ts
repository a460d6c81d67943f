#!/usr/bin/env node
// SPDX-License-Identifier: MIT
//
// The command geodesic-voronoi. Exit status: 0 done, 1 bad input, 2 a wrong command line.

import { readFile } from 'node:fs/promises';
import { execute } from './commands.js';
import { fail } from './failure.js';
import { writeStandardOutput } from './files.js';
import { parseCommandLine } from './command_line.js';

async function main(args: string[]): Promise<void> {
  const packageFile = new URL('../../package.json', import.meta.url);
  const { version } = JSON.parse(await readFile(packageFile, 'utf8'));
  const invocation = parseCommandLine(args, version);
  if (typeof invocation === 'string') await writeStandardOutput(invocation);
  else await execute(invocation);
}

// A reader that closes the pipe early, for example head, is no failure.
process.stdout.on('error', () => {});
// Nor is it one if standard error is closed.
process.stderr.on('error', () => {});

main(process.argv.slice(2)).catch(fail);
