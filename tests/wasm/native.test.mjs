// SPDX-License-Identifier: MIT
//
// The WebAssembly build computes what the native one does: the same combinatorics, and numbers that
// agree to 1e-12. Not to the last bit: the native build adds up vectors in another order, two
// numbers at a time, and has another C library.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { load } from 'geodesic-voronoi';

const executable = fileURLToPath(
  new URL('../../build/native/tests/gvd_native_results', import.meta.url),
);
/** The meshes are all of a size around 1, and so is every number. */
const tolerance = 1e-12;

const gvd = await load();
const native = JSON.parse(execFileSync(executable, { maxBuffer: 2 ** 28 }));

/** Compares arrays, and objects of them; `expected` comes from JSON, where null is infinite. */
function same(actual, expected, name) {
  if (Array.isArray(expected)) {
    assert.equal(actual.length, expected.length, `the length of ${name}`);
    expected.forEach((number, i) => {
      const x = number ?? Infinity;
      const isSame = actual[i] === x || Math.abs(actual[i] - x) <= tolerance;
      if (!isSame) assert.fail(`${name}[${i}] is ${actual[i]}, natively ${x}`);
    });
  } else if (typeof expected === 'object') {
    assert.deepEqual(Object.keys(actual).sort(), Object.keys(expected).sort());
    for (const [key, part] of Object.entries(expected)) same(actual[key], part, `${name}.${key}`);
  } else {
    assert.equal(actual, expected, name);
  }
}

test('diagrams are those of the native build', async (t) => {
  for (const { name, positions, indices, siteSets } of native) {
    await t.test(name, async () => {
      const mesh = await gvd.mesh({ positions, indices });
      for (const [i, { sites, points, results }] of siteSets.entries()) {
        for (const { metric, detail, data, located } of results) {
          const diagram = await mesh.voronoi(sites, { metric, detail });
          const which = `set ${i} of sites, ${metric}, detail ${detail}`;
          same(diagram.data, data, `${which}: data`);
          same(await diagram.locate(points), located, `${which}: located`);
          diagram.dispose();
        }
      }
      mesh.dispose();
    });
  }
});
