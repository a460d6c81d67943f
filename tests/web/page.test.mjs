// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { beforeEach, suite, test } from 'node:test';
import { strToU8, zipSync } from 'fflate';
import { apart, glb, gltf, grid, octahedron, torn, withFlipped } from '../wasm/meshes.mjs';
import { torus } from '../../web/page/samples/shapes.mjs';
import { dracoGlb, meshBinaryStl, meshObj, meshoptGlb, meshPly } from '../wasm/model_files.mjs';
import { firstTriangles, browserForTests } from './browser.mjs';

const browser = await browserForTests();

/** Turns the model that is shown, and chooses samples one right after the other. */
const chooseSamplesWithUpZ = (viewer, ...samples) =>
  viewer.evaluate(async (viewer, samples) => {
    const menu = document.getElementById('samples');
    viewer.setAttribute('up', 'z');
    for (const value of samples) {
      menu.value = value;
      menu.dispatchEvent(new Event('change'));
      await new Promise((resolve) => setTimeout(resolve));
    }
  }, samples);

const text = (viewer, selector) => viewer.page.locator(selector).textContent();
/** What is read out waits a moment for the last of several changes. */
const status = (viewer, pattern) =>
  viewer.page.locator('#status').filter({ hasText: pattern }).waitFor();
const group = (viewer, title) => viewer.page.getByRole('heading', { name: title, exact: true });

suite('the page', () => {
  let viewer;
  beforeEach(async () => {
    viewer = await browser.open();
  });

  const choose = (files) => viewer.choose(files);
  const openTorus = () => viewer.after('diagram', () => choose({ 'torus.glb': glb(torus()) }));
  const click = ({ x, y }) => viewer.page.mouse.click(x, y);
  const press = (key) => viewer.page.keyboard.press(key);
  const changedSince = async (picture) =>
    (await viewer.difference(picture, await viewer.picture())).count;
  async function drag(from, to) {
    await viewer.page.mouse.move(from.x, from.y);
    await viewer.page.mouse.down();
    for (const share of [0.25, 0.5, 0.75, 1]) {
      await viewer.page.mouse.move(
        from.x + share * (to.x - from.x),
        from.y + share * (to.y - from.y),
      );
    }
    await viewer.page.mouse.up();
  }

  test('opens with a sample model and its diagram', async () => {
    assert.equal(await viewer.regionCount(), 60);
    await status(viewer, /^60 regions, computed in /);
    const triangles = firstTriangles.toLocaleString('en');
    assert.match(
      await text(viewer, '#report'),
      new RegExp(`Triangles${triangles}.*Components1.*Boundary loops0.*Genus0`),
    );
    assert.match(await text(viewer, '#credit'), /Stanford/);
    assert.equal(await viewer.page.locator('#samples').inputValue(), 'bunny.ply');
    assert.equal(await viewer.page.locator('#error').isVisible(), false);

    const covered = await viewer.coverage(await viewer.picture());
    assert.ok(covered > 0.15, `${covered} of the view is the model's`);
  });

  test('a site is added, dragged, removed, and all of it undone', async () => {
    const opened = await openTorus();
    assert.equal(opened.regions, 60);
    assert.match(await text(viewer, '#report'), /Genus1/);
    const sites = await viewer.sites();
    const picture = await viewer.picture();

    const place = await viewer.freePlace();
    const added = await viewer.after('diagram', () => click(place));
    assert.equal(added.regions, 61);
    const change = await viewer.difference(picture, await viewer.picture(), place);
    assert.ok(change.there, 'the place of the new site has another colour');
    assert.ok(change.count > 100, `${change.count} pixels have another colour`);

    const from = await viewer.sitePosition(60);
    assert.ok(Math.hypot(from.x - place.x, from.y - place.y) < 1, 'it stands where the click was');
    const to = await viewer.freePlace();
    await viewer.after('diagram', () => drag(from, to));
    const moved = await viewer.sitePosition(60);
    assert.ok(Math.hypot(moved.x - to.x, moved.y - to.y) < 1, 'it stands where it was dropped');
    assert.equal(await viewer.regionCount(), 61);
    const dragged = await viewer.sites();

    const removed = await viewer.after('diagram', () => press('Delete'));
    assert.equal(removed.regions, 60);
    assert.deepEqual(await viewer.sites(), sites);

    await viewer.after('diagram', () => press('Control+z'));
    assert.deepEqual(await viewer.sites(), dragged);
    // One step for all of the drag.
    await viewer.after('diagram', () => press('Control+z'));
    const back = await viewer.sitePosition(60);
    assert.ok(Math.hypot(back.x - place.x, back.y - place.y) < 1, 'it is back where it was added');
    await viewer.after('diagram', () => viewer.page.click('#undo'));
    assert.deepEqual(await viewer.sites(), sites);
    assert.equal(await viewer.page.locator('#undo').isDisabled(), true);
    assert.equal(await changedSince(picture), 0);

    await viewer.after('diagram', () => press('Control+y'));
    assert.equal(await viewer.regionCount(), 61);
    await viewer.page.focus('#exploded'); // which has no use for the key
    await viewer.after('diagram', () => press('Control+z'));
    assert.deepEqual(await viewer.sites(), sites);
  });

  test('a right click on a site removes it', async () => {
    const place = await viewer.freePlace();
    await viewer.after('diagram', () => click(place));
    await viewer.after('diagram', () =>
      viewer.page.mouse.click(place.x, place.y, { button: 'right' }),
    );
    assert.equal(await viewer.siteCount(), 60);
  });

  test('removing a site and undoing it change the diagram in place', async () => {
    const at = 10;
    const before = await viewer.sites();
    const isSame = () => viewer.evaluate((viewer) => viewer.diagram === viewer.first);
    await viewer.evaluate((viewer) => {
      viewer.first = viewer.diagram;
    });
    const removed = await viewer.after('diagram', () =>
      viewer.evaluate((viewer, at) => viewer.removeSite(at), at),
    );
    assert.equal(removed.sites, 59);
    assert.equal(removed.regions, 59);
    assert.equal(await isSame(), true);
    const rest = await viewer.sites();
    assert.equal(rest.face[at], before.face[59], 'the last one takes its place');
    assert.deepEqual(
      [...rest.face.slice(0, at), ...rest.face.slice(at + 1)],
      [...before.face.slice(0, at), ...before.face.slice(at + 1, -1)],
    );
    const inPlace = await viewer.picture(['bisectors', 'voronoi-points']);

    await viewer.after('diagram', () => press('Control+z'));
    assert.equal(await isSame(), true);
    assert.deepEqual(await viewer.sites(), before);
    assert.equal(await viewer.regionCount(), 60);
    await viewer.after('diagram', () => viewer.set({ sites: rest }));
    assert.equal(await isSame(), false);
    const anew = await viewer.picture(['bisectors', 'voronoi-points']);
    assert.equal((await viewer.difference(inPlace, anew)).count, 0);
  });

  test('Escape puts a site that is being dragged back', async () => {
    const place = await viewer.freePlace();
    await viewer.after('diagram', () => click(place));
    const before = await viewer.sites();
    await viewer.page.mouse.move(place.x, place.y);
    await viewer.page.mouse.down();
    await viewer.after('diagram', () => viewer.page.mouse.move(place.x + 12, place.y + 9));
    assert.notDeepEqual(await viewer.sites(), before);
    await viewer.after('diagram', () => press('Escape'));
    await viewer.page.mouse.up();
    await viewer.settled();
    assert.deepEqual(await viewer.sites(), before);
  });

  test('a drag beside the sites turns the model and adds nothing', async () => {
    const before = await viewer.sites();
    const picture = await viewer.picture();
    const empty = await viewer.emptyPlace();
    await drag(empty, { x: empty.x + 5, y: empty.y });
    await drag(empty, { x: empty.x + 60, y: empty.y - 20 });
    const place = await viewer.freePlace();
    await drag(place, { x: place.x + 40, y: place.y });
    await click(empty);
    await viewer.settled();
    assert.deepEqual(await viewer.sites(), before);
    assert.ok((await changedSince(picture)) > 100, 'the model has turned');

    await press('f');
    assert.equal(await changedSince(picture), 0, 'F fits it into the view again');
  });

  test('everything works without a mouse', async () => {
    await viewer.page.locator('geodesic-voronoi canvas').focus();
    const before = await viewer.siteCount();
    await press('ArrowRight');
    await press('+');
    await viewer.after('diagram', () => press('Enter'));
    assert.equal(await viewer.siteCount(), before + 1);
    const { x, y } = await viewer.sitePosition(before);
    const box = await viewer.page.locator('geodesic-voronoi').boundingBox();
    assert.ok(Math.abs(x - box.x - box.width / 2) < 1 && Math.abs(y - box.y - box.height / 2) < 1);
    await press('Enter');
    assert.equal(await viewer.siteCount(), before + 1, 'it selects the site that is there');
    assert.equal(await viewer.evaluate(({ selected }) => selected), before);
    await press('n');
    assert.equal(await viewer.evaluate(({ selected }) => selected), 0);
    await viewer.after('diagram', () => press('Delete'));
    assert.equal(await viewer.siteCount(), before);
    await press('?');
    assert.equal(await viewer.page.locator('dialog').isVisible(), true);
  });

  test('a file that is no model is told of in a sentence, and the model stays', async () => {
    const before = await viewer.sites();
    const picture = await viewer.picture();
    const expectError = async (pattern, files) => {
      await viewer.after('error', () => choose(files));
      assert.match(await text(viewer, '#error-text'), pattern);
      assert.equal(await viewer.page.locator('#error').isVisible(), true);
    };
    const { json } = gltf(octahedron(), { uri: 'scene.bin' });
    await expectError(/^notes\.txt cannot be opened: .* none of the formats/, {
      'notes.txt': 'hello',
    });
    await expectError(/^scene\.gltf .* needs the file "scene\.bin"/, {
      'scene.gltf': JSON.stringify(json),
    });
    await expectError(/^broken\.glb cannot be opened: .+\.$/, { 'broken.glb': 'this is no GLB' });
    await expectError(/^a\.glb cannot be opened: /, { 'a.glb': '', 'b.glb': '' });

    assert.deepEqual(await viewer.sites(), before);
    assert.equal(await viewer.page.locator('#samples').inputValue(), 'bunny.ply');
    assert.equal(await changedSince(picture), 0);
    await viewer.page.click('#error-close');
    assert.equal(await viewer.page.locator('#error').isVisible(), false);
    const place = await viewer.freePlace();
    const added = await viewer.after('diagram', () => click(place));
    assert.equal(added.regions, 61);
    await expectError(/^more\.txt cannot/, { 'more.txt': 'hello' });
    assert.equal(await viewer.page.locator('#count').inputValue(), '61');
  });

  test('a .gltf is dropped together with its .bin', async () => {
    const { json, buffer } = gltf(grid(6), { uri: 'its%20data.bin' });
    const files = [
      { name: 'its data.bin', bytes: [...buffer] },
      { name: 'grid.gltf', bytes: [...Buffer.from(JSON.stringify(json))] },
    ];
    const drop = (types) =>
      viewer.evaluate(
        (_, { files, types }) => {
          const dataTransfer = new DataTransfer();
          for (const { name, bytes } of files) {
            dataTransfer.items.add(new File([new Uint8Array(bytes)], name));
          }
          for (const type of types) {
            document.body.dispatchEvent(
              new DragEvent(type, { bubbles: true, cancelable: true, dataTransfer }),
            );
          }
        },
        { files, types },
      );

    await viewer.choose({ 'grid.gltf': JSON.stringify(json) });
    const advice = 'which is missing. Open both together, or their folder.';
    await viewer.page.locator('#error-text', { hasText: advice }).waitFor();

    await drop(['dragover']);
    assert.equal(await viewer.page.locator('#drop').isVisible(), true);
    await viewer.after('diagram', () => drop(['drop']));
    assert.equal(await viewer.page.locator('#drop').isVisible(), false);
    assert.match(await text(viewer, '#report'), /Triangles72.*Boundary loops1/);
    assert.equal(await viewer.page.locator('#samples option:checked').textContent(), 'grid.gltf');
  });

  test('an STL opens with the third axis upwards, and keeps to another one that was chosen', async () => {
    const axis = () => viewer.page.getAttribute('#up', 'aria-label');
    const open = (files) => viewer.after('diagram', () => choose(files));
    await open({ 'a.stl': meshBinaryStl(octahedron()) });
    assert.equal(await axis(), 'Upward axis: Z');
    await viewer.page.click('#up');
    const weld = () => viewer.evaluate((element) => element.setAttribute('weld', '1e-6'));
    await viewer.after('diagram', weld);
    assert.equal(await axis(), 'Upward axis: X');
    await open({ 'a.obj': meshObj(octahedron()) });
    assert.equal(await axis(), 'Upward axis: Y');
  });

  test('models of other formats, compressed ones, zips and folders open', async () => {
    const opens = async (name, change) => {
      await viewer.after('diagram', change);
      assert.match(await text(viewer, '#report'), /Triangles8.*Components1/);
      assert.equal(await viewer.page.locator('#samples option:checked').textContent(), name);
    };
    const files = [
      ['draco.glb', await dracoGlb(octahedron())],
      ['meshopt.glb', await meshoptGlb(octahedron())],
      ['a.obj', meshObj(octahedron())],
      ['a.ply', meshPly(octahedron(), 'binary_big_endian')],
      ['a.stl', meshBinaryStl(octahedron())],
    ];
    for (const [name, content] of files) await opens(name, () => choose({ [name]: content }));
    const { json, buffer } = gltf(octahedron(), { uri: 'data/a.bin' });
    const scene = { 'data/a.bin': new Uint8Array(buffer), 'a.gltf': strToU8(JSON.stringify(json)) };
    await opens('a.gltf', () => choose({ 'model.zip': zipSync({ model: scene }) }));

    const folder = mkdtempSync(join(tmpdir(), 'geodesic-voronoi-'));
    try {
      mkdirSync(join(folder, 'data'));
      for (const [name, content] of Object.entries(scene))
        writeFileSync(join(folder, name), content);
      // Of another path, so another one than in the zip.
      await opens('a.gltf (2)', () => viewer.page.setInputFiles('#folder', folder));
    } finally {
      rmSync(folder, { recursive: true });
    }
  });

  test('of several models, each can be chosen', async () => {
    const menu = viewer.page.locator('#samples');
    const checked = () => viewer.page.locator('#samples option:checked').textContent();
    const choices = () => viewer.page.locator('#samples optgroup option').allTextContents();
    const is = async (name, triangles) => {
      assert.equal(await checked(), name);
      assert.match(await text(viewer, '#report'), new RegExp(`Triangles${triangles}\\D`));
    };
    const pick = (name) => viewer.after('diagram', () => menu.selectOption({ label: name }));
    const fine = meshObj(grid(3));

    await viewer.after('diagram', () =>
      choose({ 'grid 10.obj': fine, 'grid 2.obj': meshObj(octahedron()) }),
    );
    await is('grid 2.obj', 8);
    assert.match(await text(viewer, '#note-text'), /^This is one of 2 models: choose another /);
    await pick('grid 10.obj');
    await is('grid 10.obj', 18);
    const ofSeveral = viewer.page.locator('#note', { hasText: 'This is one of' });
    assert.equal(await ofSeveral.isVisible(), false);
    await pick('Bunny');
    await pick('grid 2.obj');
    await is('grid 2.obj', 8);

    // In a zip the first is broken: the others can be had all the same.
    const parts = { 'a/scene.obj': strToU8('v 0 0 0\nf 1 2 3\n'), 'b/scene.obj': fine };
    await viewer.after('error', () => choose({ 'both.zip': zipSync(parts) }));
    await is('grid 2.obj', 8);
    await pick('b/scene.obj');
    await is('b/scene.obj', 18);
    assert.equal(await viewer.page.locator('#error').isVisible(), false);
    const all = ['grid 2.obj', 'grid 10.obj', 'a/scene.obj', 'b/scene.obj'];
    assert.deepEqual(await choices(), all);

    // The same files again are no further choices.
    await viewer.after('diagram', () => choose({ 'grid 10.obj': fine }));
    await is('grid 10.obj', 18);
    assert.equal((await choices()).length, all.length);
    // Another one of the same name is.
    await viewer.after('diagram', () => choose({ 'grid 10.obj': meshObj(grid(4)) }));
    await is('grid 10.obj (2)', 32);
    await pick('grid 10.obj');
    await is('grid 10.obj', 18);
  });

  test('a folder of too many files is told of in a sentence, and can be chosen again', async () => {
    const left = await viewer.page.evaluate(() => {
      const list = new DataTransfer();
      for (let i = 0; i <= 10_000; ++i) list.items.add(new File([], `${i}.txt`));
      const folder = document.getElementById('folder');
      folder.files = list.files;
      folder.dispatchEvent(new Event('change'));
      return folder.files.length;
    });
    await viewer.page.locator('#error-text', { hasText: 'more than 10000 files' }).waitFor();
    assert.equal(left, 0);
  });

  test('a folder is dropped', async () => {
    const { json, buffer } = gltf(grid(3), { uri: 'data/a.bin' });
    const contents = [JSON.stringify(json), [...buffer]];
    await viewer.after('diagram', () =>
      viewer.evaluate((element, [scene, data]) => {
        // What a browser hands over for a folder, which no script can make.
        const fileEntry = (fullPath, content) => ({
          isFile: true,
          fullPath,
          file: (done) => done(new File([content], fullPath.split('/').pop())),
        });
        const folderEntry = (...entries) => {
          const parts = [entries.slice(0, 1), entries.slice(1), []];
          return {
            isDirectory: true,
            createReader: () => ({ readEntries: (done) => done(parts.shift()) }),
          };
        };
        const entry = folderEntry(
          folderEntry(fileEntry('/model/data/a.bin', new Uint8Array(data))),
          fileEntry('/model/a.gltf', scene),
        );
        const item = { kind: 'file', webkitGetAsEntry: () => entry, getAsFile: () => null };
        void element.loadDropped({ items: [item] });
      }, contents),
    );
    assert.match(await text(viewer, '#report'), /Triangles18/);

    const { message } = await viewer.after('error', () =>
      viewer.evaluate((element) => {
        const failing = { readEntries: (_done, fail) => fail(new Error('it is gone')) };
        const entry = { name: 'model', isDirectory: true, createReader: () => failing };
        const item = { kind: 'file', webkitGetAsEntry: () => entry, getAsFile: () => null };
        void document.createElement('geodesic-voronoi').loadDropped({ items: [item] });
        void element.loadDropped({ items: [item] });
      }),
    );
    assert.equal(message, 'The folder model cannot be read: it is gone.');
  });

  test('distances that are drawn go with their model, not later', async () => {
    await viewer.after('distances', () => viewer.set({ layers: ['regions', 'distances'] }));
    await viewer.evaluate((viewer) => {
      viewer.seen = [];
      const see = ({ type, detail }) => viewer.seen.push(type, type === 'load' || detail === null);
      for (const type of ['distances', 'load']) viewer.addEventListener(type, see);
    });
    await viewer.after('diagram', () => choose({ 'grid 3.obj': meshObj(grid(3)) }));
    const seen = await viewer.evaluate(({ seen }) => seen.slice(0, 4));
    assert.deepEqual(seen, ['distances', true, 'load', true]);
    await viewer.set({ layers: ['regions', 'sites', 'bisectors'] });
  });

  test('a vertex that is nowhere is told of, and nothing complains', async () => {
    const { positions, indices } = octahedron();
    const obj = meshObj({ positions: [...positions, NaN, 0, 0], indices: [...indices, 0, 1, 6] });
    await viewer.after('diagram', () => choose({ 'a.obj': obj }));
    assert.match(
      await text(viewer, '#repairs'),
      /1 triangle with a corner that is not finite, dropped/,
    );
    const covered = await viewer.coverage(await viewer.picture());
    assert.ok(covered > 0.05, `${covered} of the view is the model's`);
  });

  test('sites are sampled by number and seed, and cleared', async () => {
    const before = await viewer.sites();
    await viewer.page.fill('#count', '7');
    await viewer.page.fill('#seed', '3');
    const sampled = await viewer.after('diagram', () =>
      viewer.page.click('#sampling-form [type=submit]'),
    );
    assert.equal(sampled.sites, 7);
    const first = await viewer.sites();
    await viewer.after('diagram', () => viewer.page.click('#clear'));
    assert.equal(await viewer.siteCount(), 0);
    await status(viewer, /^No sites/);
    await viewer.after('diagram', () => viewer.page.click('#sampling-form [type=submit]'));
    assert.deepEqual(await viewer.sites(), first);
    for (const _ of [1, 2, 3]) await viewer.after('diagram', () => press('Control+z'));
    assert.deepEqual(await viewer.sites(), before);
    assert.equal(await viewer.page.inputValue('#count'), String(before.face.length));
  });

  test('sites and a density that are asked for once more are no step to undo', async () => {
    const steps = () =>
      viewer.evaluate(async (viewer) => {
        let count = 0;
        for (; !document.getElementById('undo').disabled; ++count) viewer.undo();
        return count;
      });
    await viewer.page.getByText('Smaller regions in places').click();
    for (const _ of [1, 2]) {
      await viewer.after('diagram', () => viewer.page.click('#sampling-form [type=submit]'));
      await viewer.after('density-change', () => viewer.page.click('#density-curvature'));
    }
    // The sites were sampled by the density the second time.
    assert.equal(await steps(), 2);
    await viewer.after('diagram', () => viewer.page.click('#sampling-form [type=submit]'));
    assert.equal(await steps(), 0);
  });

  test('what fails or is cancelled leaves its settings as they were', async () => {
    const attributes = () =>
      viewer.evaluate((viewer) =>
        ['sites', 'min-component', 'weld'].map((name) => viewer.getAttribute(name)),
      );
    const before = await attributes();
    const count = await viewer.siteCount();
    await viewer.evaluate((viewer) => {
      const failed = new Promise((resolve) =>
        viewer.addEventListener('error', resolve, { once: true }),
      );
      viewer.setAttribute('min-component', '10000000');
      return failed.then(() => undefined);
    });
    await viewer.page.waitForFunction(() => document.getElementById('min-component').value === '0');
    assert.deepEqual(await attributes(), before);
    assert.match(await text(viewer, '#error-text'), /no component has 10000000 triangles/);
    await viewer.page.click('#error-close');

    await viewer.evaluate(async (viewer) => {
      viewer.setAttribute('weld', '0.001');
      await new Promise((resolve) => requestAnimationFrame(resolve));
      viewer.cancel();
    });
    await viewer.page.waitForFunction(
      (weld) => document.querySelector('geodesic-voronoi').getAttribute('weld') === weld,
      before[2],
    );
    // As soon as it has begun: on a slow machine, a timer may come after the diagram.
    await viewer.evaluate((viewer) => {
      const cancel = () => setTimeout(() => viewer.cancel());
      viewer.addEventListener('status-change', cancel, { once: true });
    });
    await viewer.page.fill('#count', '20000');
    await viewer.page.click('#sampling-form [type=submit]');
    await viewer.page.waitForFunction(
      (sites) => document.getElementById('count').value === sites,
      before[0],
    );
    assert.deepEqual(await attributes(), before);
    assert.equal(await viewer.siteCount(), count);
  });

  test('a model that is asked for twice in a row is the one that the menu names', async () => {
    const models = await viewer.evaluate(async (viewer) => {
      const menu = document.getElementById('samples');
      for (const value of ['torus.glb', 'hand.glb', 'torus.glb']) {
        menu.value = value;
        menu.dispatchEvent(new Event('change'));
        await Promise.resolve(); // the page has begun to open it
      }
      await new Promise((resolve) => viewer.addEventListener('diagram', resolve, { once: true }));
      return [viewer.info.origin.file, menu.value];
    });
    assert.deepEqual(models, ['torus.glb', 'torus.glb']);
  });

  test('a model that is made otherwise while it is opened is the one that is opened', async () => {
    const result = await viewer.evaluate(async (viewer) => {
      const { sites } = viewer;
      const opened = viewer.load('./samples/torus.glb');
      viewer.setAttribute('weld', '1e-6');
      const isOpen = await opened;
      const isKept = String(viewer.sites.face) === String(sites.face);
      const rebuilt = new Promise((resolve) =>
        viewer.addEventListener('load', ({ detail }) => resolve(detail.name), { once: true }),
      );
      viewer.setAttribute('weld', '1e-5');
      return { isOpen, isKept, name: await rebuilt };
    });
    assert.deepEqual(result, { isOpen: true, isKept: false, name: 'torus.glb' });
  });

  test('what is edited while a model is made otherwise is kept: sites and density', async () => {
    const count = await viewer.siteCount();
    const kept = await viewer.evaluate(async (viewer) => {
      const loaded = new Promise((resolve) => viewer.addEventListener('load', resolve));
      const edit = ({ detail: { totalProgress } }) => {
        if (totalProgress < 1) return; // the sites have been put on the new mesh
        viewer.removeEventListener('progress', edit);
        viewer.addSite({ face: 5, bary: [0.3, 0.3, 0.4] });
        viewer.density = viewer.mesh.positions.filter((_, i) => i % 3 === 0).fill(100);
      };
      viewer.addEventListener('progress', edit);
      viewer.setAttribute('max-edge', '0.02');
      await loaded;
      return { sites: viewer.sites.face.length, densities: viewer.density?.map(Math.round) };
    });
    assert.equal(kept.sites, count + 1);
    assert.deepEqual(new Set(Object.values(kept.densities ?? {})), new Set([100]));
  });

  test('a model that is chosen again while another is opened keeps its settings', async () => {
    await chooseSamplesWithUpZ(viewer, 'torus.glb', 'bunny.ply');
    await viewer.settled();
    const model = await viewer.evaluate((viewer) => [
      viewer.info.origin.file,
      viewer.getAttribute('up'),
    ]);
    assert.deepEqual(model, ['bunny.ply', 'z']);
  });

  test('models that were given up leave the first, with its settings', async () => {
    await chooseSamplesWithUpZ(viewer, 'torus.glb', 'hand.glb');
    await viewer.evaluate((viewer) => viewer.cancel());
    await viewer.page.waitForFunction(
      () => document.getElementById('viewer').getAttribute('up') === 'z',
    );
    const name = await viewer.evaluate((viewer) => {
      viewer.setAttribute('weld', '1e-6');
      return new Promise((resolve) =>
        viewer.addEventListener('load', ({ detail }) => resolve(detail.name), { once: true }),
      );
    });
    assert.equal(name, 'bunny.ply');
  });

  test('how a model is made of its file is chosen, and told', async () => {
    const crumb = { ...grid(1), positions: grid(1).positions.map((x) => x / 10) };
    const bytes = glb(withFlipped(apart(torn(octahedron(), 1e-6), crumb), 0));
    await viewer.after('diagram', () => choose({ 'torn.glb': bytes }));
    await group(viewer, 'Model').click();
    await viewer.page.getByText('How the mesh is built').click();
    assert.match(await text(viewer, '#report'), /Components9/);
    assert.match(
      await text(viewer, '#bare-note'),
      /of 9 components, .* % of the area, ha(s|ve) no site/,
    );

    // Sites stay where they are, those placed by hand, too; so does the density.
    await viewer.evaluate((viewer) => {
      viewer.sites = { face: [0, 1, 4], bary: [0.2, 0.3, 0.5, 0.6, 0.3, 0.1, 0.4, 0.4, 0.2] };
      viewer.density = Float64Array.from({ length: 28 }, (_, v) => 1 + v);
    });
    const places = () =>
      viewer.evaluate(async ({ mesh, sites }) => [...(await mesh.positionsOf(sites))]);
    const before = await places();
    await viewer.after('diagram', () => viewer.page.selectOption('#weld', '1e-4'));
    (await places()).forEach((x, i) => assert.ok(Math.abs(x - before[i]) < 1e-6, `${i}: ${x}`));
    assert.ok(Math.abs((await viewer.evaluate(({ density }) => density[7])) - 8) < 1e-3);
    assert.ok(await viewer.page.locator('#undo').isDisabled(), 'they are those to begin with');
    assert.match(await text(viewer, '#report'), /Components2/);
    assert.match(await text(viewer, '#repairs'), /18 vertices welded.*1 triangle turned over/);
    await viewer.after('diagram', () => viewer.page.selectOption('#orientation', 'keep'));
    assert.match(await text(viewer, '#repairs'), /3 edges cut/);
    assert.match(
      await text(viewer, '#note-text'),
      /cut apart at 3 edges .*: no path leads across\./,
    );
    await viewer.after('diagram', async () => {
      await viewer.page.fill('#min-component', '3');
      await viewer.page.locator('#min-component').blur();
    });
    assert.match(
      await text(viewer, '#repairs'),
      /2 components with fewer triangles than asked for, dropped.*3 triangles of these/,
    );
    assert.match(await text(viewer, '#report'), /Components1/);
    assert.equal(await viewer.page.locator('#bare-note').isVisible(), false);
  });

  test('sites are put on every component, and where the surface bends', async () => {
    await viewer.after('diagram', () => choose({ 'two.glb': glb(apart(grid(6), octahedron())) }));
    await viewer.after('diagram', async () => {
      await viewer.page.fill('#count', '1');
      await viewer.page.click('#sampling-form [type="submit"]');
    });
    await viewer.page
      .locator('#bare-note')
      .filter({
        hasText: /^1 of 2 components, .* has no site\. “At least .* given enough sites\.$/,
      })
      .waitFor();
    await viewer.after('diagram', async () => {
      await viewer.page.fill('#count', '8');
      await viewer.page.fill('#per-component', '4');
      await viewer.page.selectOption('#sampling', 'distortion');
      await viewer.page.click('#sampling-form [type="submit"]');
    });
    const { face } = await viewer.sites();
    assert.equal([...face].filter((f) => f < 72).length, 4);
    await viewer.page.locator('#bare-note').waitFor({ state: 'hidden' });

    await viewer.page.getByText('Smaller regions in places').click();
    await viewer.after('density-change', () => viewer.page.click('#density-curvature'));
    const density = await viewer.evaluate((viewer) => [...viewer.density]);
    assert.ok(Math.max(...density.slice(0, 49)) < Math.min(...density.slice(49)));
  });

  test('layers are shown and hidden', async () => {
    const regions = await viewer.picture(['regions']);
    for (const layer of ['bisectors', 'sites', 'voronoi-points', 'wireframe']) {
      const changed = async () =>
        (await viewer.difference(regions, await viewer.picture(['regions', layer]))).count;
      let count = await changed();
      // A worker finds the edges of the wireframe.
      for (let tries = 0; count <= 20 && tries < 50; ++tries) count = await changed();
      assert.ok(count > 20, `${layer} change ${count} pixels`);
    }
    await viewer.page.getByText('Bisectors', { exact: true }).first().click();
    assert.equal(await viewer.evaluate(({ layers }) => layers.join(' ')), 'regions sites');
  });

  test('the distance is chosen; a choice that is cancelled is taken back', async () => {
    assert.equal(await viewer.page.locator('input[value="exact"]').isChecked(), true);
    assert.equal(await viewer.evaluate(({ diagram }) => diagram.metric), 'exact');
    await group(viewer, 'Diagram').click();
    const fast = await viewer.after('diagram', () => viewer.page.getByText('Fast').click());
    assert.equal(fast.metric, 'dgpc');
    assert.equal(fast.regions, 60);
    const finer = await viewer.after('diagram', () => viewer.page.selectOption('#detail', '2'));
    assert.equal(finer.detail, 2);
    assert.equal(finer.metric, 'dgpc');
    assert.ok(finer.segments > fast.segments, 'more segments, each shorter');

    await viewer.evaluate(async (viewer) => {
      viewer.setAttribute('metric', 'exact');
      await null; // Attributes take effect together, after the code that sets them.
      viewer.cancel();
    });
    await viewer.settled();
    assert.equal(await viewer.page.locator('input[value="dgpc"]').isChecked(), true);
    assert.equal(await viewer.evaluate(({ diagram }) => diagram.metric), 'dgpc');
  });

  test('the pointer reads region, area and distance', async () => {
    const [first] = await viewer.evaluate((viewer) =>
      [...viewer.sites.face.keys()].filter((i) => viewer.sitePosition(i)),
    );
    const { x, y } = await viewer.sitePosition(first);
    const hovered = await viewer.after('hover', () => viewer.page.mouse.move(x, y));
    assert.equal(hovered.region, first);
    assert.ok(
      hovered.distance < 0.1 * Math.sqrt(hovered.area),
      `${hovered.distance} from the site`,
    );
    assert.match(
      (await text(viewer, '#readout')).trim(),
      new RegExp(`^Region ${first} · area \\S+ · \\S+ from its site$`),
    );
    const hover = (detail) =>
      viewer.evaluate((viewer, detail) => {
        viewer.dispatchEvent(new CustomEvent('hover', { detail }));
      }, detail);
    // What is rounded off is no distance.
    await hover({ ...hovered, distance: 2e-5 * Math.sqrt(hovered.area) });
    assert.match(await text(viewer, '#readout'), / · 0 from its site/);
    // A region of a country, in metres.
    await hover({ ...hovered, area: 987_654_321, distance: 12_345.6 });
    assert.match(await text(viewer, '#readout'), / · area 988,000,000 · 12,300 from its site/);
  });

  test('the dual is drawn and repaired, regions in an exploded view, and both can be taken away', async () => {
    await viewer.after('diagram', () => viewer.evaluate((viewer) => viewer.sampleSites(3)));
    const shown = ['regions', 'bisectors', 'sites', 'dual'];
    const plain = await viewer.picture(shown.slice(0, 3));
    const dual = await viewer.after('dual', () => viewer.page.check('#layers [value=dual]'));
    assert.ok(dual.polygons > 0);
    assert.ok((await changedSince(plain)) > 0);
    assert.ok(dual.violations.length > 0);
    // The pictures were taken without the dual, which comes back now.
    const reason = /no valid mesh of the surface: regions 0, 1 and 2/;
    await viewer.page.locator('#dual-note:visible', { hasText: reason }).waitFor();
    await viewer.after('diagram', () =>
      viewer.evaluate((viewer) => {
        document.querySelector('#repair').click();
        viewer.sampleSites(2);
      }),
    );
    await viewer.page.locator('#repair:enabled').waitFor({ state: 'attached' });
    assert.equal(await viewer.page.locator('#error').isVisible(), false, 'its diagram is gone');
    await viewer.after('diagram', () => viewer.page.click('#undo'));
    await viewer.page.locator('#dual-note:visible', { hasText: reason }).waitFor();
    // The dual of the diagram that is there again may come after the click.
    await viewer.evaluate(
      (viewer) =>
        new Promise((resolve) => {
          viewer.addEventListener('dual', ({ detail }) => {
            if (detail?.violations.length === 0) resolve();
          });
          document.querySelector('#repair').click();
        }),
    );
    assert.ok((await viewer.siteCount()) > 3);
    assert.match(await text(viewer, '#dual-note'), /is a valid mesh/);
    assert.equal(await viewer.page.locator('#repair').isVisible(), false);

    const whole = await viewer.picture(shown);
    const together = await viewer.coverage(whole);
    const slide = (value) =>
      viewer.after('exploded', () => viewer.page.locator('#exploded').fill(String(value)));
    const apart = await slide(60);
    assert.equal(apart.regions, await viewer.siteCount());
    assert.ok(apart.triangles > firstTriangles);
    const moved = await viewer.difference(whole, await viewer.picture(shown));
    assert.ok(moved.count > 1000, `${moved.count} pixels differ`);
    const { x, y } = await viewer.evaluate((viewer) => {
      const box = viewer.getBoundingClientRect();
      return { x: box.left + box.width / 2, y: box.top + box.height / 2 };
    });
    const count = await viewer.siteCount();
    await drag({ x, y }, { x: x + 40, y });
    assert.equal(await viewer.page.locator('#note').isVisible(), false, 'turning is no click');
    await viewer.evaluate((viewer) => viewer.refit());
    await click({ x, y });
    assert.equal(await viewer.siteCount(), count, 'there is nothing to edit');
    assert.match(await text(viewer, '#note-text'), /in the exploded view/);
    await slide(0);
    const again = await viewer.coverage(await viewer.picture(shown));
    assert.ok(Math.abs(again - together) < 0.01 * together);
  });

  test('a lost context is told of, and the picture returns with it', async () => {
    const picture = await viewer.picture();
    const message = viewer.page.locator('geodesic-voronoi [role=alert]');
    const lost = await viewer.after('error', () =>
      viewer.evaluate((viewer) => {
        viewer.loss = window.contexts[0].getExtension('WEBGL_lose_context');
        viewer.loss.loseContext();
      }),
    );
    assert.equal(lost.type, 'webglcontextlost');
    assert.equal(await message.isVisible(), true);
    // Said once, where it goes by itself.
    assert.equal(await viewer.page.locator('#error').isVisible(), false);
    await viewer.evaluate((viewer) => viewer.loss.restoreContext());
    await message.waitFor({ state: 'hidden' });
    assert.equal(await changedSince(picture), 0);
  });

  test('a viewer whose context is lost is taken out without a word', async () => {
    await viewer.after('error', () =>
      viewer.evaluate(() => window.contexts[0].getExtension('WEBGL_lose_context').loseContext()),
    );
    await viewer.evaluate((viewer) => viewer.remove());
    await viewer.drawn(); // the console is checked after each test
  });

  test('a viewer that is taken out ends its workers, and starts anew when it returns', async () => {
    // One for diagrams, one for how they are drawn.
    const workers = viewer.page.workers();
    assert.equal(workers.length, 2);
    await Promise.all([
      ...workers.map((worker) => worker.waitForEvent('close')),
      viewer.evaluate((viewer) => {
        window.taken = viewer;
        viewer.remove();
      }),
    ]);
    await viewer.page.evaluate(() => document.querySelector('#view').append(window.taken));
    await viewer.settled();
    assert.equal(await viewer.regionCount(), 60);
    assert.equal(viewer.page.workers().length, 2);
  });
});

test('on a phone the controls are a sheet that taps and swipes open', async () => {
  const viewer = await browser.open({ viewport: { width: 390, height: 640 }, hasTouch: true });
  const isOpen = () => viewer.page.locator('#panel').isVisible();
  const box = await viewer.page.locator('geodesic-voronoi').boundingBox();
  assert.ok(box.width === 390 && box.height > 300, 'the view has the width and most of the height');
  assert.equal(await isOpen(), false);
  await viewer.page.tap('#sheet');
  assert.equal(await isOpen(), true);

  const { x, y, width } = await viewer.page.locator('#sheet').boundingBox();
  const swipe = async (from, to) => {
    await viewer.page.mouse.move(x + width / 2, from);
    await viewer.page.mouse.down();
    await viewer.page.mouse.move(x + width / 2, to, { steps: 3 });
    await viewer.page.mouse.up();
  };
  await swipe(y + 20, y + 90);
  assert.equal(await isOpen(), false);
  const closed = await viewer.page.locator('#sheet').boundingBox();
  await swipe(closed.y + 20, closed.y - 60);
  assert.equal(await isOpen(), true);
  await viewer.page.tap('#sheet');

  const place = await viewer.freePlace();
  const added = await viewer.after('diagram', () => viewer.page.touchscreen.tap(place.x, place.y));
  assert.equal(added.regions, 61);
});
