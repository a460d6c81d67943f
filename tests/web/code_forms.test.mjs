// SPDX-License-Identifier: MIT
//
// The code that the page gives: it makes the diagram that is shown, and runs whatever a file is called.

import assert from 'node:assert/strict';
import { suite, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { transformSync } from 'esbuild';
import { runnerImport } from 'vite';
import {
  diagramDefaults,
  meshDefaults,
  samplingDefaults,
  tessellationDefaults,
} from '../../dist/library/arguments.js';
import { attributeDefaults } from '../../dist/viewer/attributes/attribute_defaults.js';

const path = fileURLToPath(new URL('../../web/page/menus/code_forms.ts', import.meta.url));
const { codeOf, watchOrigin } = (await runnerImport(path, { configFile: false, logLevel: 'error' }))
  .module;

/** As much of the viewer as the code depends on. */
function viewerWith(attributes, more = {}) {
  const viewer = new EventTarget();
  viewer.getAttribute = (name) => attributes[name] ?? null;
  return Object.assign(viewer, { cameraOrbit: '0deg 75deg 100%', ...more });
}

suite('code', () => {
  const ofPage = { sites: '60', seed: '4', 'cvt-iterations': '30', 'cvt-method': 'lloyd' };
  const model = { name: 'a.obj' };

  test('repeats a tessellation by the same method, to the same iteration', () => {
    const code = (form) => codeOf(viewerWith(ofPage), model, 'even', form);
    assert.match(code('script'), /\{ iterations: 30, metric: 'exact', method: 'lloyd' \}/);
    assert.match(code('element'), / cvt-iterations="30" cvt-method="lloyd"\n/);
    assert.match(code('command'), /--iterations 30 --method lloyd -o/);
  });

  test('leaves out what is so without it', () => {
    const viewer = viewerWith({ sites: '60' });
    assert.match(
      codeOf(viewer, model, 'even', 'script'),
      /\{ iterations: 50, metric: 'exact' \}/,
      'as the element does without the attribute',
    );
    for (const form of ['element', 'command'])
      assert.doesNotMatch(codeOf(viewer, model, 'even', form), /cvt-|--method/);
    assert.doesNotMatch(codeOf(viewerWith(ofPage), model, 'edited', 'element'), /cvt-/);
  });

  test('may leave out the defaults of attributes: the library has the same', () => {
    const { method, iterations, energyTolerance } = tessellationDefaults;
    const ofLibrary = {
      ...{ ...meshDefaults, ...samplingDefaults, ...diagramDefaults },
      ...{ cvtMethod: method, cvtIterations: iterations, cvtTolerance: energyTolerance },
    };
    const attribute = (name) => name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
    const compared = Object.entries(ofLibrary).filter(
      ([name]) => attributeDefaults[attribute(name)] !== undefined,
    );
    assert.equal(compared.length, 11);
    for (const [name, value] of compared)
      assert.equal(attributeDefaults[attribute(name)], String(value), name);
  });

  test('of the element shows the same view', () => {
    const viewer = viewerWith({ ...ofPage, up: 'z', layers: '', exploded: '0.5' });
    const view = / up="z" layers="" exploded="0.5" camera-orbit="0deg 75deg 100%"><\/geodesic/;
    assert.match(codeOf(viewer, model, 'sampled', 'element'), view);
    assert.doesNotMatch(codeOf(viewer, model, 'sampled', 'script'), /up|layers|orbit/);
  });

  test('holds attributes with any characters', () => {
    const viewer = viewerWith({ ...ofPage, layers: '"><script>&' });
    const code = codeOf(viewer, model, 'sampled', 'element');
    assert.match(code, / layers="&quot;><script>&amp;" camera-orbit/);
  });

  test('no name of a file ends the comment that tells of it', () => {
    const odd = { name: 'a --> b --!> c.obj' };
    const [comment, ...rest] = codeOf(viewerWith(ofPage), odd, 'edited', 'element').split('\n');
    assert.match(comment, /^<!-- Needs in its folder: [^>]* -->$/);
    assert.match(rest[0], /^<geodesic-voronoi src=/);
  });

  test('holds names of files with any characters', () => {
    const odd = { name: `O'Neil & "Sons" <1>.obj` };
    const viewer = viewerWith(ofPage);
    for (const origin of ['sampled', 'even', 'edited']) {
      const script = codeOf(viewer, odd, origin, 'script');
      transformSync(script, { format: 'esm' }); // throws if it is no code
      const [, address] = /fetch\('([^']*)'\)/.exec(script);
      assert.equal(decodeURIComponent(address), odd.name);
      const [, src] = /<geodesic-voronoi src="([^"]*)" sites/.exec(
        codeOf(viewer, odd, origin, 'element'),
      );
      assert.equal(src, address);
      assert.doesNotMatch(src, /[&<>']/);
    }
  });
});

suite('the origin of sites', () => {
  const sampled = { face: Int32Array.of(3), bary: Float64Array.of(1, 0, 0) };
  const moved = { face: Int32Array.of(3), bary: Float64Array.of(0, 1, 0) };
  const attributes = { sites: '1', seed: '1', 'cvt-iterations': '2' };

  test('is found when it is asked for', async () => {
    let samplings = 0;
    const sampleSites = async () => {
      ++samplings;
      return sampled;
    };
    const viewer = viewerWith(attributes, {
      mesh: { sampleSites },
      sites: sampled,
      cvtStatus: 'idle',
    });
    const originOf = watchOrigin(viewer);
    assert.equal(await originOf(), 'sampled');
    const iterate = (iteration, sites) => {
      Object.assign(viewer, { sites, cvtStatus: 'paused' });
      viewer.dispatchEvent(new CustomEvent('cvt-iteration', { detail: { iteration } }));
    };
    iterate(0, sampled);
    iterate(1, moved);
    assert.equal(samplings, 1, 'not for a tessellation that nobody asks about');
    assert.equal(await originOf(), 'edited', 'the code would go further');
    iterate(2, moved);
    assert.equal(await originOf(), 'even');
    attributes['cvt-method'] = 'lloyd';
    assert.equal(await originOf(), 'edited', 'the code would move sites by another method');
    delete attributes['cvt-method'];
    viewer.cvtStatus = 'idle';
    assert.equal(await originOf(), 'edited');
    iterate(0, moved);
    iterate(2, moved);
    assert.equal(await originOf(), 'edited', 'it began with others');
  });
});
