// SPDX-License-Identifier: MIT
//
// npm test: sets up, builds, and runs all tests, the fastest first. Fails if any failed.

import { readdirSync } from 'node:fs';
import { buildNative, buildPackage, buildPage } from './build.mjs';
import { chromium, setUp } from './setup.mjs';
import { announce, at, exists, main, runShowing } from './tasks.mjs';

/** A way of running tests: its name, how to get ready, the command, and its closing line. */
const runners = [
  {
    name: 'core',
    prepare: () => buildNative('build/native', ['cmake']),
    command: () => ['ctest', ['--test-dir', 'build/native', '--output-on-failure']],
    closing: (text) => text.match(/^.*tests passed.*$/m)?.[0],
  },
  {
    name: 'wasm',
    prepare: buildPackage,
    command: () => ['node', ['--test', '--test-reporter=spec', ...testFiles('tests/wasm')]],
    closing: nodeTestClosing,
  },
  {
    name: 'web',
    prepare: buildPage,
    command: () => ['node', ['--test', '--test-reporter=spec', '--test-concurrency=1', ...testFiles('tests/web')]],
    closing: nodeTestClosing,
  },
];

function testFiles(folder) {
  if (!exists(at(folder))) return [];
  return readdirSync(at(folder), { recursive: true })
    .filter((name) => name.endsWith('.test.mjs'))
    .sort()
    .map((name) => `${folder}/${name}`);
}

/** node:test closes with a line per count. */
function nodeTestClosing(text) {
  const counts = ['tests', 'pass', 'fail', 'skipped'].map((name) => text.match(new RegExp(`^\\S+ ${name} \\d+$`, 'm'))?.[0]);
  return counts.every(Boolean) ? counts.map((count) => count.replace(/^\S+ /, '')).join(', ') : undefined;
}

await main(async () => {
  setUp('test');
  const results = [];
  for (const { name, prepare, command, closing } of runners) {
    announce(`Tests of ${name}`);
    await prepare();
    const { code, text } = await runShowing(...command(), {
      env: { ...process.env, CHROME_PATH: chromium() },
    });
    results.push({ name, code, line: closing(text) ?? 'no result' });
  }
  announce('Results');
  for (const { name, code, line } of results) console.log(`${code === 0 ? 'ok    ' : 'FAILED'}  ${name.padEnd(5)} ${line}`);
  if (results.some(({ code }) => code !== 0)) process.exitCode = 1;
});
