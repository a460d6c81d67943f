// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { suite, test } from 'node:test';
import { Glide } from '../../dist/viewer/drawing/glide.js';

suite('a glide', () => {
  const [origin, x, y] = [
    [0, 0, 0],
    [1, 0, 0],
    [0, 1, 0],
  ].map((place) => Float32Array.from(place));
  const seen = (glide, now) => [...glide.at(now)];

  test('leads from where places were to where they are', () => {
    const glide = new Glide();
    glide.to(origin, 0, 0);
    glide.to(x, 100, 1000);
    assert.deepEqual(seen(glide, 1000), [0, 0, 0]);
    assert.deepEqual(seen(glide, 1050), [0.5, 0, 0]);
    assert.equal(glide.isOver(1099), false);
    assert.ok(seen(glide, 1099)[0] < 1);
    assert.equal(glide.isOver(1100), true);
    assert.deepEqual(seen(glide, 1100), [1, 0, 0]);
  });

  test('goes on from where places are seen when they move again', () => {
    const glide = new Glide();
    glide.to(origin, 0, 0);
    glide.to(x, 100, 0);
    glide.to(y, 100, 50);
    assert.deepEqual(seen(glide, 50), [0.5, 0, 0]);
    assert.deepEqual(seen(glide, 100), [0.25, 0.5, 0]);
    assert.deepEqual(seen(glide, 150), [0, 1, 0]);
  });

  test('is none in no time, and to other places than there were', () => {
    const glide = new Glide();
    glide.to(origin, 100, 0);
    assert.equal(glide.isOver(0), true);
    glide.to(x, 0, 0);
    assert.deepEqual(seen(glide, 0), [1, 0, 0]);
    const two = Float32Array.from([1, 2, 3, 4, 5, 6]);
    glide.to(two, 100, 0);
    assert.deepEqual(seen(glide, 0), [...two]);
  });
});
