// SPDX-License-Identifier: MIT
//
// The package as others get it: packed, and unpacked in an empty folder. What it wants beside it is
// linked there from this repository, so that no registry is asked.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, realpathSync, rmSync, symlinkSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));

/** The path of something that npm has installed for this repository. */
export const inModules = (...path) => join(root, 'node_modules', ...path);

/** Runs a command that has to succeed, and returns what it wrote. */
export function run(command, args, cwd) {
  const { status, stdout, stderr } = spawnSync(command, args, { cwd, encoding: 'utf8' });
  assert.equal(status, 0, `${command} ${args.join(' ')}\n${stdout}${stderr}`);
  return stdout;
}

/** Installs the package, which depends on none, with others beside it; `remove()` takes the folder away. */
export function install(...beside) {
  // Bundlers compare real paths, and a folder for temporary files may be a link.
  const folder = realpathSync(mkdtempSync(join(tmpdir(), 'geodesic-voronoi-')));
  const packageFolder = join(folder, 'node_modules', 'geodesic-voronoi');
  mkdirSync(packageFolder, { recursive: true });
  const options = ['--json', '--ignore-scripts', '--pack-destination', folder];
  const [{ filename, files }] = JSON.parse(run('npm', ['pack', ...options], root));
  const tarball = join(folder, filename);
  run('tar', ['-xf', tarball, '-C', packageFolder, '--strip-components=1']);
  for (const name of beside) {
    const link = join(folder, 'node_modules', name);
    mkdirSync(dirname(link), { recursive: true });
    symlinkSync(inModules(name), link);
  }
  return {
    folder,
    packageFolder,
    /** The paths of what is published. */
    files: files.map(({ path }) => path),
    tarball: readFileSync(tarball),
    remove: () => rmSync(folder, { recursive: true }),
  };
}
