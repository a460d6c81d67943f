// SPDX-License-Identifier: MIT
//
// npm test: sets up, builds, and runs all tests, the fastest first. Fails if any failed.

import { readdirSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { buildPackage, buildPage, buildWithCMake } from './build.mjs';
import { chromium, setUp } from './setup.mjs';
import { announce, at, main, runShowing } from './tasks.mjs';

/** A way of running tests: its name, how to get ready, the command, and its closing line. */
const runners = [
  {
    name: 'core',
    prepare: () => buildWithCMake('build/native'),
    command: () => ctest('build/native'),
    closing: ctestClosing,
  },
  {
    // Some of its tests repeat what the native build, which is there by now, computes.
    name: 'wasm',
    prepare: buildPackage,
    command: () => nodeTest('tests/wasm'),
    closing: nodeTestClosing,
  },
  {
    name: 'web',
    prepare: buildPage,
    // One file at a time: each has a browser of its own.
    command: () => nodeTest('tests/web', '--test-concurrency=1'),
    closing: nodeTestClosing,
  },
];

/**
 * npm test -- --sanitized: the C++ tests only, watched by AddressSanitizer and UBSan. Several times
 * slower, hence fewer of the random cases.
 */
const sanitizedRunners = [
  {
    name: 'core, sanitized',
    prepare: () => buildWithCMake('build/sanitized', { options: sanitized }),
    command: () => ctest('build/sanitized'),
    closing: ctestClosing,
  },
];
const sanitized = [
  '-DCMAKE_BUILD_TYPE=Debug',
  '-DGVD_SANITIZE=address,undefined',
  '-DGVD_PROPERTY_CASES=1000',
];

function ctest(folder) {
  return ['ctest', ['--test-dir', folder, '--output-on-failure', '-j', availableParallelism()]];
}

function ctestClosing(text) {
  return text.match(/^.*tests passed.*$/m)?.[0];
}

function nodeTest(folder, ...options) {
  const files = readdirSync(at(folder)).filter((name) => name.endsWith('.test.mjs'));
  const paths = files.sort().map((name) => `${folder}/${name}`);
  return [process.execPath, ['--test', '--test-reporter=spec', ...options, ...paths]];
}

/** node:test closes with a line per count. */
function nodeTestClosing(text) {
  const counts = ['tests', 'pass', 'fail', 'skipped'].map(
    (name) => text.match(new RegExp(`^\\S+ ${name} \\d+$`, 'm'))?.[0],
  );
  return counts.every(Boolean)
    ? counts.map((count) => count.replace(/^\S+ /, '')).join(', ')
    : undefined;
}

/** Runs the tests of one runner; what goes wrong before they start counts as their failure. */
async function result({ name, prepare, command, closing }) {
  announce(`Tests of ${name}`);
  try {
    await prepare();
    const { code, text } = await runShowing(...command(), {
      env: { ...process.env, CHROME_PATH: chromium() },
    });
    return { name, failed: code !== 0, line: closing(text) ?? 'no result' };
  } catch (error) {
    return { name, failed: true, line: error.message };
  }
}

await main(async () => {
  setUp('test');
  const results = [];
  const chosen = process.argv.includes('--sanitized') ? sanitizedRunners : runners;
  for (const runner of chosen) results.push(await result(runner));
  announce('Results');
  for (const { name, failed, line } of results) {
    console.log(`${failed ? 'FAILED' : 'ok    '}  ${name.padEnd(15)}  ${line}`);
  }
  if (results.some(({ failed }) => failed)) process.exitCode = 1;
});
