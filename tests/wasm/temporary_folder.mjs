// SPDX-License-Identifier: MIT
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after } from 'node:test';

/** A folder of its own for the tests of a file, which goes after them. */
export function temporaryFolder() {
  const folder = mkdtempSync(join(tmpdir(), 'geodesic-voronoi-'));
  after(() => rmSync(folder, { recursive: true }));
  return folder;
}
