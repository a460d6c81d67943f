// SPDX-License-Identifier: MIT
//
// `npm start` answers a wrong command line at once, before it builds anything.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const script = fileURLToPath(new URL('../../.dev/start.mjs', import.meta.url));

/** What it wrote and its exit status. */
function start(...args) {
  const { status, stdout, stderr } = spawnSync(process.execPath, [script, ...args], {
    encoding: 'utf8',
    timeout: 20_000,
  });
  return { status, stdout, stderr };
}

test('npm start tells its options', () => {
  const { status, stdout, stderr } = start('--help');
  assert.deepEqual([status, stderr], [0, '']);
  assert.match(stdout, /^Usage: npm start .*--port N.*--host ADDRESS/s);
});

test('npm start refuses a port that is none', () => {
  for (const port of ['abc', '0', '80.5', '65536']) {
    const stderr = `--port is '${port}', not an integer from 1 to 65535\n`;
    assert.deepEqual(start('--port', port), { status: 1, stdout: '', stderr });
  }
});
