// SPDX-License-Identifier: MIT
//
// What scripts write into the documents is what they would write now: `npm run docs` mends it.

import assert from 'node:assert/strict';
import { readdirSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { suite, test } from 'node:test';
import { makeFigures } from '../../web/docs/make/figures.mjs';
import { plots, withTables } from '../../web/docs/make/measured.mjs';
import { root, textOf } from './documents.mjs';

const json = (name) => JSON.parse(textOf(`web/docs/${name}`));
const measured = json('bench.json');
const peers = json('peers.json');

/** Without the texts, of which a difference is too long to read. */
function assertWritten(path, text) {
  assert.ok(textOf(path) === text, `${path} is not what the script makes: npm run docs`);
}

test('the figures of how it works', async () => {
  const figures = await makeFigures();
  for (const [name, text] of Object.entries(figures))
    assertWritten(`web/docs/figures/${name}`, text);
  assert.deepEqual(readdirSync(join(root, 'web/docs/figures')).sort(), Object.keys(figures).sort());
});

suite('from one run of the benchmark', () => {
  test('the plots', () => {
    for (const [name, text] of Object.entries(plots(measured, peers))) {
      assertWritten(`web/docs/plots/${name}`, text);
    }
  });
  for (const path of ['README.md', 'web/docs/performance.md']) {
    test(`the tables of ${path}`, () =>
      assertWritten(path, withTables(textOf(path), measured, peers)));
  }
});

test('pictures are small', () => {
  const folder = join(root, 'web/docs/pictures');
  const large = ['hero.webp', 'stages.webp'];
  for (const name of readdirSync(folder)) {
    const most = large.includes(name) ? 150 : 20;
    assert.ok(statSync(join(folder, name)).size <= most * 1024, name);
  }
});
