// SPDX-License-Identifier: MIT
//
// npm test [-- RUNNER...]: sets up, builds, and runs all tests, or those of the runners named, the
// fastest first. Fails if any failed.

import { readdirSync, readFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { buildPackage, buildPage, buildWithCMake } from './build.mjs';
import { buildDocs } from './docs.mjs';
import { chromium, setUp } from './setup.mjs';
import { announce, at, main, runShowing } from './tasks.mjs';

/** A way of running tests: its name, how to get ready, the command, and its closing line. */
const runners = [
  {
    name: 'style',
    prepare: () => {},
    command: () => nodeTest('tests/style', 1),
    closing: nodeTestClosing,
  },
  {
    name: 'core',
    prepare: () => buildWithCMake('build/native'),
    command: () => ctest('build/native'),
    closing: (text) => ctestClosing('build/native', text),
  },
  {
    // Some of its tests repeat what the native build, which is there by now, computes.
    name: 'wasm',
    prepare: buildPackage,
    command: () => nodeTest('tests/wasm', availableParallelism()),
    closing: nodeTestClosing,
  },
  {
    name: 'package',
    prepare: buildPackage,
    command: () => nodeTest('tests/package', 1),
    closing: nodeTestClosing,
  },
  {
    // The C++ sources as they are compiled for WebAssembly, each by clang-tidy.
    name: 'lint',
    prepare: buildPackage,
    command: () => nodeTest('tests/lint', 1),
    closing: nodeTestClosing,
  },
  {
    name: 'web',
    prepare: buildPage,
    // One file at a time: each has a browser of its own.
    command: () => nodeTest('tests/web', 1),
    closing: nodeTestClosing,
  },
  {
    // Their code, their links, and what scripts wrote into them.
    name: 'docs',
    prepare: async () => {
      await buildPage();
      await buildDocs();
    },
    command: () => nodeTest('tests/docs', 1),
    closing: nodeTestClosing,
  },
  {
    // The tests of the core again, and inputs that libFuzzer makes up, watched by AddressSanitizer and
    // UBSan, with the assertions of Eigen and of the standard library. That takes several times as long:
    // fewer random cases and edits, and not those that measure accuracy.
    name: 'sanitized',
    prepare: () => buildWithCMake('build/sanitized', { options: sanitized }),
    command: () => ctest('build/sanitized'),
    closing: (text) => ctestClosing('build/sanitized', text),
  },
];

/** Several files are compiled as one, which takes half of the time. What is measured and shipped is not. */
const sanitized = [
  '-DCMAKE_BUILD_TYPE=Debug',
  '-DCMAKE_UNITY_BUILD=ON',
  '-DCMAKE_UNITY_BUILD_BATCH_SIZE=16',
  // libFuzzer is part of Clang.
  '-DCMAKE_CXX_COMPILER=clang++',
  '-DGVD_SANITIZE=address,undefined,float-cast-overflow,fuzzer-no-link',
  '-DGVD_PROPERTY_CASES=500',
];

function ctest(folder) {
  return ['ctest', ['--test-dir', folder, '--output-on-failure', '-j', availableParallelism()]];
}

/** ctest counts programs; what each of them passed is in its log. */
function ctestClosing(folder, text) {
  const programs = text.match(/^.*tests passed.*$/m)?.[0];
  if (!programs) return undefined;
  const log = readFileSync(at(folder, 'Testing/Temporary/LastTest.log'), 'utf8');
  const sum = (pattern) =>
    [...log.matchAll(pattern)].reduce((total, [, count]) => total + Number(count), 0);
  const tests = sum(/^\[ {2}PASSED {2}\] (\d+) tests?\./gm);
  const cases = sum(/^(\d+) cases passed$/gm);
  return `${programs}: in them ${tests} tests and ${cases} random cases passed`;
}

function nodeTest(folder, concurrency) {
  const files = readdirSync(at(folder)).filter((name) => name.endsWith('.test.mjs'));
  const paths = files.sort().map((name) => `${folder}/${name}`);
  const options = ['--test-reporter=spec', `--test-concurrency=${concurrency}`];
  return [process.execPath, ['--test', ...options, ...paths]];
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
  announce(`Tests: ${name}`);
  const start = performance.now();
  const outcome = await attempt(prepare, command, closing);
  return { name, seconds: Math.round((performance.now() - start) / 1000), ...outcome };
}

async function attempt(prepare, command, closing) {
  try {
    await prepare();
    const { code, text } = await runShowing(...command(), {
      env: { ...process.env, CHROME_PATH: chromium() },
    });
    return { failed: code !== 0, line: closing(text) ?? 'no result' };
  } catch (error) {
    return { failed: true, line: error.message };
  }
}

await main(async () => {
  const names = process.argv.slice(2);
  const known = runners.map(({ name }) => name);
  const unknown = names.find((name) => !known.includes(name));
  if (unknown) throw new Error(`'${unknown}' is none of ${known.join(', ')}`);
  setUp('test');
  const chosen = runners.filter(({ name }) => names.length === 0 || names.includes(name));
  const results = [];
  for (const runner of chosen) results.push(await result(runner));
  announce('Results');
  for (const { name, failed, seconds, line } of results) {
    const time = `${seconds} s`.padStart(6);
    console.log(`${failed ? 'FAILED' : 'ok    '}  ${name.padEnd(9)}  ${time}  ${line}`);
  }
  if (results.some(({ failed }) => failed)) process.exitCode = 1;
});
