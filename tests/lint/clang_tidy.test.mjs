// SPDX-License-Identifier: MIT
//
// What clang-tidy finds in the C++ sources, by the checks in .clang-tidy: a test per file. They are read as
// Emscripten compiles them, the core as well as the bindings.

import assert from 'node:assert/strict';
import { execFile, execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { relative } from 'node:path';
import { describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));
const commands = JSON.parse(readFileSync(`${root}/build/wasm/compile_commands.json`, 'utf8'));
const paths = [...new Set(commands.map(({ file }) => relative(root, file)))].sort();

/** The target and the headers of Emscripten, which its compiler adds to each command. */
const emscripten = execFileSync('em++', ['--cflags'], { encoding: 'utf8' }).trim().split(/\s+/);
const added = emscripten.map((flag) => `--extra-arg-before=${flag}`);

function findings(path) {
  const options = ['-p', 'build/wasm', '--quiet', ...added];
  return new Promise((resolve) => {
    execFile('clang-tidy', [...options, path], { cwd: root }, (error, found, log) =>
      resolve(error ? found + log : ''),
    );
  });
}

describe('clang-tidy', { concurrency: availableParallelism() }, () => {
  for (const path of paths)
    test(path, async () => {
      const found = await findings(path);
      assert.ok(!found, found);
    });
});
