// SPDX-License-Identifier: MIT
//
// What clang-tidy finds in the C++ sources, by the checks in .clang-tidy: a test per folder, since most of
// the time goes into the headers that all of its files include. They are read as Emscripten compiles them,
// the core as well as the bindings.

import assert from 'node:assert/strict';
import { execFile, execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { dirname, relative } from 'node:path';
import { describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));
const commands = JSON.parse(readFileSync(`${root}/build/wasm/compile_commands.json`, 'utf8'));

/** The files of each folder, and what their commands define. */
const folders = {};
for (const { file, command } of commands) {
  folders[relative(root, dirname(file))] ??= { files: new Set(), definitions: new Set() };
  const { files, definitions } = folders[relative(root, dirname(file))];
  files.add(file);
  for (const [definition] of command.matchAll(/-D\w+=\S+/g))
    definitions.add(definition.replaceAll('\\', ''));
}

/** The target and the headers of Emscripten, which its compiler adds to each command. */
const emscripten = execFileSync('em++', ['--cflags'], { encoding: 'utf8' }).trim().split(/\s+/);
const added = emscripten.map((flag) => `--extra-arg-before=${flag}`);

function findings({ files: [first, ...others], definitions }) {
  const included = others.flatMap((file) => ['-include', file]);
  const extra = [...definitions, ...included].map((arg) => `--extra-arg=${arg}`);
  return new Promise((resolve) => {
    const options = ['-p', 'build/wasm', '--quiet', ...added, ...extra];
    execFile('clang-tidy', [...options, first], { cwd: root }, (error, found, log) =>
      resolve(error ? found + log : ''),
    );
  });
}

describe('clang-tidy', { concurrency: availableParallelism() }, () => {
  for (const [name, folder] of Object.entries(folders))
    test(name, async () => {
      const found = await findings(folder);
      assert.ok(!found, found);
    });
});
