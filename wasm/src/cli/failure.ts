// SPDX-License-Identifier: MIT
//
// How the command fails.

import { UsageError } from './values.js';

/** Tells an error in one line, and how the command will end: 1 for bad input, 2 for a wrong command line. */
export function fail(error: Error): void {
  const line = error.message.replaceAll(/\s+/g, ' ').trim();
  process.stderr.write(`geodesic-voronoi: ${line}\n`);
  process.exitCode = error instanceof UsageError ? 2 : 1;
}
