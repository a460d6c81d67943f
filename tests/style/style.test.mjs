// SPDX-License-Identifier: MIT
//
// How the sources are written: what the formatters, the linters and a few rules of our own find.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));
const read = (path) => readFileSync(join(root, path), 'utf8');

function run(command, ...args) {
  const { status, stdout, stderr } = spawnSync(command, args, { cwd: root, encoding: 'utf8' });
  return { status, text: stdout + stderr };
}

/** The files of the repository, those that are new included. */
const listing = run('git', 'ls-files', '--cached', '--others', '--exclude-standard');
assert.equal(listing.status, 0, listing.text);
const files = listing.text.split('\n').filter((path) => path && existsSync(join(root, path)));
const matching = (pattern) => files.filter((path) => pattern.test(path));

test('C++ is formatted by clang-format', () => {
  const { status, text } = run('clang-format', '--dry-run', '-Werror', ...matching(/\.(cpp|h)$/));
  assert.equal(status, 0, text);
});

test('TypeScript and JavaScript are formatted, and have no lint: biome', () => {
  const biome = join(root, 'node_modules/.bin/biome');
  const { status, text } = run(biome, 'ci', '--error-on-warnings', '--max-diagnostics=50');
  assert.equal(status, 0, text);
});

test('no source is longer than 450 lines', () => {
  const sources = matching(/^(\.dev|core|wasm|web)\/.*\.(cpp|h|ts|mjs|css|html)$/);
  const long = sources.filter((path) => read(path).split('\n').length > 451);
  assert.deepEqual(long, []);
});

test('every source says what its licence is', () => {
  // Examples are there to be copied.
  const examples = 'web/docs/examples/';
  const sources = matching(/\.(cpp|h|ts|mjs)$|CMakeLists\.txt$/).filter(
    (path) => !path.startsWith(examples),
  );
  const silent = sources.filter((path) => {
    const [first, second] = read(path).split('\n');
    const line = first.startsWith('#!') ? second : first;
    return !/^(\/\/|#) SPDX-License-Identifier: MIT$/.test(line);
  });
  assert.deepEqual(silent, []);
});

test('folders use only those before them, in the order that CONTRIBUTING gives', () => {
  const contributing = read('.github/CONTRIBUTING.md');
  for (const root of ['core/src', 'wasm/src', 'web/viewer']) {
    const row = new RegExp(
      `^\\| \`${root}/\` \\|.*each folder uses those before it: (.*) \\|$`,
      'm',
    );
    const order = contributing.match(row)[1].match(/(?<=`)\w+(?=`)/g);
    const wrong = matching(new RegExp(`^${root}/\\w+/.*\\.(ts|h|cpp)$`)).flatMap((path) => {
      const place = order.indexOf(path.slice(root.length + 1).split('/')[0]);
      assert.ok(place >= 0, `${path} is in a folder that CONTRIBUTING has not`);
      const used = read(path).matchAll(/(?:'\.\.\/|^#include ")(\w+)\//gm);
      return Array.from(used, ([, folder]) => [path, folder]).filter(
        ([, folder]) => order.indexOf(folder) > place,
      );
    });
    assert.deepEqual(wrong, []);
  }
});

test('what users read in declarations points to no file of the core, which the package has not', () => {
  const sources = matching(/^(wasm\/src|web\/viewer)\/.*\.ts$/);
  assert.deepEqual(
    sources.filter((path) => /\bcore\/|\bgvd\/\w+\.h\b/.test(read(path))),
    [],
  );
});

test('the lock file names no host of a registry', () => {
  const hosts = read('package-lock.json').match(/"resolved": "https?:[^"]*"/g) ?? [];
  assert.deepEqual(hosts, []);
});

test('every package that is imported is declared', () => {
  const { name, ...declared } = JSON.parse(read('package.json'));
  const { dependencies, devDependencies, peerDependencies } = declared;
  const known = [
    name,
    ...Object.keys({ ...dependencies, ...devDependencies, ...peerDependencies }),
  ];
  for (const path of matching(/^(\.dev|tests|wasm|web)\/.*\.(ts|mjs)$/)) {
    const imports = read(path).matchAll(
      /^(?:import|export)\b(?:[\w\s{},*]*\bfrom)?\s*['"]([^.'"][^'"]*)['"];/gm,
    );
    for (const [, specifier] of imports) {
      const isKnown = known.some((entry) => `${specifier}/`.startsWith(`${entry}/`));
      assert.ok(isKnown || specifier.startsWith('node:'), `${path} imports ${specifier}`);
    }
  }
});
