// SPDX-License-Identifier: MIT
//
// What is computed from a diagram or a mesh while it may be replaced: without a browser.

import assert from 'node:assert/strict';
import { suite, test } from 'node:test';
import { DerivedDrawings } from '../../dist/viewer/layers/derived_drawings.js';
import { fetchModelFiles } from '../../dist/viewer/session/model_files.js';
import { RestartableTask } from '../../dist/viewer/session/restartable_task.js';

const turn = () => new Promise((resolve) => setImmediate(resolve));
const milliseconds = (count) => new Promise((resolve) => setTimeout(resolve, count));

suite('derived drawings', () => {
  /** A place with a diagram that notes its calls, and answers none of them. */
  function place(answer = () => new Promise(() => {})) {
    const calls = [];
    const note = (name) => (options) => {
      calls.push({ name, signal: options.signal });
      return answer();
    };
    const diagram = Object.fromEntries(
      ['dualPaths', 'dual', 'violations'].map((name) => [name, note(name)]),
    );
    const session = { status: 'computing', isMoving: false, shown: { diagram } };
    const events = [];
    const drawings = new DerivedDrawings(
      {
        attributes: { layers: ['dual'], exploded: 0 },
        session,
        stage: { invalidate() {} },
        model: undefined,
      },
      (type, detail) => events.push([type, detail]),
    );
    const enter = async (changes) => {
      Object.assign(session, changes);
      drawings.update();
      await turn();
    };
    return { calls, diagram, events, enter, drawings };
  }

  test('are made once nothing else is under way, which ends them', async () => {
    const { calls, enter } = place();
    await enter({ status: 'computing' });
    assert.equal(calls.length, 0);
    await enter({ status: 'ready' });
    assert.equal(calls.length, 1);
    assert.equal(calls[0].signal.aborted, false);
    await enter({ status: 'computing' });
    assert.equal(calls[0].signal.aborted, true);
    await enter({ status: 'ready' });
    assert.equal(calls.length, 2, 'they are still wanted if the diagram is the same');
  });

  test('wait in a drag until it rests', async () => {
    const { calls, diagram, enter } = place();
    for (let i = 0; i < 3; ++i) {
      await enter({ status: 'computing', isMoving: true });
      await enter({ status: 'ready', shown: { diagram } });
      await milliseconds(20);
    }
    assert.equal(calls.length, 0);
    while (calls.length === 0) await milliseconds(20);
    assert.equal(calls[0].signal.aborted, false);
  });

  test('tell of a failure, unless nobody wants them any more', async () => {
    let cause = new Error('there is not enough memory for this');
    const { drawings, enter, events, diagram } = place(() => Promise.reject(cause));
    await enter({ status: 'ready' });
    const message = 'The dual cannot be made: there is not enough memory for this.';
    assert.deepEqual(events, [
      ['error', { type: 'computefailure', message, cause }],
      ['dual', null],
    ]);
    events.length = 0;
    cause = Object.assign(new Error('the diagram has been disposed'), { code: 'disposed' });
    await enter({ shown: { diagram } });
    assert.deepEqual(events, [['dual', null]]);
    events.length = 0;
    await enter({ shown: { diagram: { dualPaths: () => milliseconds(10) } } });
    drawings.dispose();
    await milliseconds(30);
    assert.deepEqual(events, [], 'nothing is told after the end');
  });
});

test('a task ends when it is asked for again, or at a cancel', async () => {
  const signals = [];
  const endless = (signal) =>
    new Promise((_, reject) => {
      signals.push(signal);
      signal.addEventListener('abort', () => reject(signal.reason));
    });
  const task = new RestartableTask();
  const results = [task.run(endless), task.run(endless)];
  assert.deepEqual(
    signals.map(({ aborted }) => aborted),
    [true, false],
  );
  task.cancel();
  assert.equal(task.isRunning, false);
  results.push(task.run(async () => {}));
  assert.equal(task.isRunning, true);
  assert.deepEqual(await Promise.all(results), [false, false, true]);
  assert.equal(task.isRunning, false);
  await assert.rejects(
    task.run(() => Promise.reject(new Error('of the work'))),
    { message: 'of the work' },
  );
  assert.equal(task.isRunning, false);
  assert.equal(await task.run(async () => task.cancel()), true, 'too late for it');
});

test('a connection that ends too early is told of with the name of the file', async (context) => {
  const { fetch } = globalThis;
  context.after(() => {
    globalThis.fetch = fetch;
    delete globalThis.document;
  });
  globalThis.document = { baseURI: 'http://page.example/' };
  globalThis.fetch = async () =>
    new Response(
      new ReadableStream({
        pull: (controller) => controller.error(new TypeError('network error')),
      }),
    );
  const how = { signal: new AbortController().signal, onProgress() {} };
  await assert.rejects(fetchModelFiles('a%20model.glb', how), {
    message: 'a model.glb cannot be fetched: the connection has ended.',
  });
});

test('the material of a model that is gone by the time is freed', async () => {
  const file = { name: 'a.ply', files: { 'a.ply': new TextEncoder().encode('ply\n') } };
  const numbers = { array: new Float32Array(9), normalized: false };
  const surface = { position: numbers, normal: numbers, color: numbers };
  let freed = 0;
  const place = {
    attributes: { layers: ['original'] },
    session: { status: 'loading' },
    model: {
      files: file,
      builder: { ask: async () => surface },
      drawing: { mesh: { frame: { scale: 1, centre: [0, 0, 0] } }, setOriginal() {} },
    },
    stage: {
      invalidate() {},
      async compile({ children: [part] }) {
        part.geometry.addEventListener('dispose', () => ++freed);
        drawings.dispose();
      },
    },
  };
  const events = [];
  const drawings = new DerivedDrawings(place, (type) => events.push(type));
  drawings.update();
  while (freed === 0) await milliseconds(20);
  await milliseconds(20);
  assert.equal(freed, 1);
  assert.deepEqual(events, []);
});
