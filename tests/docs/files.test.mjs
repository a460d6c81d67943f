// SPDX-License-Identifier: MIT
//
// Tables of the documents against the program: the fields of its files, and the codes of its errors.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { suite, test } from 'node:test';
import { torus } from '../../web/page/samples/shapes.mjs';
import { glb } from '../wasm/meshes.mjs';
import { blocks, root, textOf } from './documents.mjs';
import { temporaryFolder } from '../wasm/temporary_folder.mjs';

const folder = temporaryFolder();
writeFileSync(join(folder, 'model.glb'), glb(torus(40, 20)));

/** The names of the first column of a section's table. */
function namesIn(path, section) {
  const [, text] = textOf(path).split(`\n## ${section}\n`);
  const rows = text.split('\n## ')[0].matchAll(/^\| (`[^|]*) \|/gm);
  const names = [...rows].flatMap(([, cell]) => [...cell.matchAll(/`([^`]+)`/g)]);
  return names.map(([, name]) => name).filter((name) => name !== 'code');
}

/** The fields of JSON: `a.b` of an object in an object, `a[].b` of objects in a list. */
function fieldsOf(value, name = '') {
  if (Array.isArray(value)) {
    const items = value.filter((item) => item !== null && typeof item === 'object');
    const objects = items.filter((item) => !Array.isArray(item));
    return objects.length > 0 ? objects.flatMap((item) => fieldsOf(item, `${name}[]`)) : [name];
  }
  if (value === null || typeof value !== 'object') return [name];
  const inside = name === '' ? '' : `${name}.`;
  return Object.entries(value).flatMap(([key, item]) => fieldsOf(item, inside + key));
}

function run(command, args) {
  const options = { cwd: folder, encoding: 'utf8', maxBuffer: 2 ** 28 };
  const { status, stdout, stderr } = spawnSync(command, args, options);
  assert.equal(status, 0, stdout + stderr);
  return stdout;
}

suite('the fields of files are those that the command writes', () => {
  const one = '{"vertex":[1]}';
  for (const [line, others = []] of [
    ['info model.glb --json'],
    ['cvt model.glb --sites 9 --iterations 1'],
    ['diagram model.glb --sites 5'],
    [`locate model.glb --sites 5 --points ${one}`],
    ['distances model.glb --sites 5'],
    [`path model.glb --from ${one} --to {"vertex":[90]}`],
    ['partition model.glb --sites 5'],
    ['dual model.glb --sites 4'],
    ['remesh model.glb --sites 60 --iterations 1', ['of dual']],
  ]) {
    test(line, () => {
      const args = [join(root, 'dist/cli/main.js'), ...line.split(' '), '--quiet'];
      const written = new Set(fieldsOf(JSON.parse(run(process.execPath, args))));
      const inEvery = ['scale', 'unit'];
      const known = [...inEvery, ...namesIn('web/docs/files.md', line.split(' ')[0]), ...others];
      if (known.includes('of dual')) {
        const ofDual = namesIn('web/docs/files.md', 'dual');
        known.splice(known.indexOf('of dual'), 1);
        known.push(...ofDual.filter((name) => !name.startsWith('violations')));
      }
      assert.deepEqual([...written].sort(), known.sort());
    });
  }
});

test('the codes of errors', () => {
  const [, codes] = readFileSync(join(root, 'wasm/src/api/errors.ts'), 'utf8').match(
    /type ErrorCode =(.*?);\n\n/s,
  );
  const inCode = [...codes.matchAll(/\| '([\w-]+)'/g)].map(([, code]) => code);
  assert.ok(inCode.length > 5);
  assert.deepEqual(namesIn('web/docs/guide.md', 'Errors'), inCode);
});

suite('the lines for CMake', () => {
  const project = (lines) => `cmake_minimum_required(VERSION 3.22)
project(app LANGUAGES CXX)
file(WRITE \${CMAKE_BINARY_DIR}/app.cpp "#include <gvd/gvd.h>\\nint main() {}\\n")
add_executable(app \${CMAKE_BINARY_DIR}/app.cpp)
${lines}`;
  const all = ['README.md', 'web/docs/guide.md'].flatMap((path) => blocks(path, 'cmake'));
  const installed = all.filter((lines) => lines.includes('find_package'));
  const added = new Set(all.filter((lines) => !lines.includes('find_package')));

  [...added].forEach((lines, i) => {
    test(lines.split('\n')[0], () => {
      if (i === 0) symlinkSync(root, join(folder, 'geodesic-voronoi'));
      writeFileSync(join(folder, 'CMakeLists.txt'), project(lines));
      run('cmake', ['-S', '.', '-B', `build${i}`, '-G', 'Ninja']);
      // Not the library, which takes minutes: what includes it.
      run('cmake', ['--build', `build${i}`, '--target', 'CMakeFiles/app.dir/app.cpp.o']);
    });
  });

  test('of an installed library: as in the example that is built with it', () => {
    const example = textOf('tests/core/installed/CMakeLists.txt').replace(/\bexample PR/, 'app PR');
    assert.equal(installed.length, 1);
    for (const line of installed[0].trim().split('\n')) assert.ok(example.includes(line), line);
  });
});
