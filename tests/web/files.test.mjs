// SPDX-License-Identifier: MIT
//
// What is dropped on the page and what is downloaded from it, besides models.

import assert from 'node:assert/strict';
import { suite, test } from 'node:test';
import { unzipSync } from 'fflate';
import { jsonOf } from '../wasm/files.mjs';
import { glb, grid, octahedron, torn } from '../wasm/meshes.mjs';
import { browserForTests, changedScript, firstTriangles } from './browser.mjs';

const browser = await browserForTests();
const viewer = await browser.open();
/** Another page, of tests that open a model of their own. */
const own = await browser.open();

suite('files', () => {
  /** A file, as a person drags it in from elsewhere. */
  const drop = (name, content) =>
    viewer.evaluate(
      (_, { name, content }) => {
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File([content], name));
        for (const type of ['dragover', 'drop']) {
          document.body.dispatchEvent(
            new DragEvent(type, { bubbles: true, cancelable: true, dataTransfer }),
          );
        }
      },
      { name, content },
    );

  test('sites that were downloaded are dropped to bring them back, a step to undo', async () => {
    const { name, content } = await viewer.download('sites', 'json');
    assert.equal(name, 'bunny-sites.json');
    assert.deepEqual(JSON.parse(content).mesh, { faces: firstTriangles });
    const sites = await viewer.sites();
    await viewer.after('diagram', () => viewer.evaluate((viewer) => viewer.removeSite(0)));
    await viewer.after('diagram', () => drop(name, content.toString()));
    assert.deepEqual(await viewer.sites(), sites);
    await viewer.after('diagram', () => viewer.page.click('#undo'));
    assert.equal(await viewer.siteCount(), 59);

    const wrong = {
      '{': 'cannot be opened as sites: it is no JSON that can be read: ',
      '{"position": null}': 'cannot be opened as sites: points.position is null, ',
      '{"face": [1]}': 'cannot be opened as sites: there are no points: ',
      '{"face": [1], "bary": [1, 0]}':
        'cannot be opened as sites: points.bary has 2 numbers, not 3: ',
      '{"face": [999999], "bary": [1, 0, 0]}':
        'cannot be opened as sites: point 0: there is no triangle 999999.',
      '{"mesh": {"faces": 12}, "face": [1], "bary": [1, 0, 0]}': `cannot be opened as sites: the points belong to another mesh, of another file or made with other options: to one with 12 triangles, not ${firstTriangles.toLocaleString('en')}.`,
    };
    for (const [text, sentence] of Object.entries(wrong)) {
      await drop('wrong.json', text);
      await viewer.page.locator('#error-text', { hasText: `wrong.json ${sentence}` }).waitFor();
    }
    assert.equal(await viewer.siteCount(), 59);
    // The next file that can be opened takes the error away.
    await viewer.after('diagram', () => drop('vertices.json', '{"vertex": [0, 900, 1700]}'));
    assert.equal(await viewer.siteCount(), 3);
    assert.equal(await viewer.page.locator('#error').isVisible(), false);
  });

  test('a note on sites stays while one is selected, and ends when they change', async () => {
    const count = await viewer.siteCount();
    await drop('two.json', '{"face":[1,2],"bary":[1,0,0,1,0,0]}');
    const note = viewer.page.locator('#note', { hasText: 'have been replaced by the 2 points' });
    await note.waitFor();
    await viewer.settled();
    await viewer.set({ selected: 1 });
    assert.equal(await note.isVisible(), true);
    await viewer.after('diagram', () => viewer.page.click('#note-action'));
    assert.equal(await note.isVisible(), false);
    assert.equal(await viewer.siteCount(), count);
  });

  test('coordinates of sites are a table, which brings them back', async () => {
    const { name, content } = await viewer.download('sites', 'csv');
    assert.equal(name, 'bunny-sites.csv');
    const places = () =>
      viewer.evaluate(async ({ mesh, sites }) => [...(await mesh.positionsOf(sites))]);
    const before = await places();
    assert.deepEqual(
      content
        .toString()
        .match(/-?\d[\d.e-]*/g)
        .map(Number),
      before,
    );
    await viewer.after('diagram', () => drop(name, content.toString()));
    (await places()).forEach((x, i) => assert.ok(Math.abs(x - before[i]) < 1e-6, `${i}: ${x}`));
    await viewer.after('diagram', () => viewer.page.click('#undo'));
  });

  test('a model that is chosen together with its sites opens with them', async () => {
    const sites = { face: [2, 7], bary: [1 / 2, 1 / 4, 1 / 4, 1, 0, 0] };
    await own.choose({ 'sites.json': JSON.stringify(sites), 'mine.glb': glb(octahedron()) });
    await own.haveSites(2);
    assert.deepEqual(await own.sites(), sites);
  });

  test('sites in space and those of a diagram are sites, too', async () => {
    const places = await viewer.evaluate(async ({ mesh, sites }) => [
      ...(await mesh.positionsOf(sites)),
    ]);
    await viewer.after('diagram', () => drop('p.json', JSON.stringify({ position: places })));
    assert.equal(await viewer.siteCount(), places.length / 3);
    const before = await viewer.sites();
    const removed = { face: [-1, ...before.face], bary: [0, 0, 0, ...before.bary] };
    await viewer.after('diagram', () => drop('d.json', JSON.stringify({ sites: removed })));
    const now = JSON.stringify(await viewer.sites()); // which knows no -0
    assert.equal(now, JSON.stringify(before), 'labels without a site are left out');
    const markup = ['# columns = x,y,z', places.slice(0, 3)].join('\n'); // of 3D Slicer
    await viewer.after('diagram', () => drop('one.fcsv', markup));
    assert.equal(await viewer.siteCount(), 1);
    const table = ['x,y,z', places.slice(0, 3), places.slice(3, 6)].join('\n');
    await viewer.after('diagram', () => drop('two.csv', table));
    assert.equal(await viewer.siteCount(), 2);
    await drop('wrong.xyz', '1 2');
    const error = viewer.page.locator('#error-text', {
      hasText: /^wrong\.xyz cannot .* line 1: z /,
    });
    await error.waitFor();
    await drop('empty.csv', 'x,y,z\n');
    await viewer.page.locator('#error-text', { hasText: 'empty.csv cannot' }).waitFor();
    assert.equal(await viewer.siteCount(), 2);
    const note = viewer.page.locator('#note');
    const scaled = ['x,y,z', places.slice(0, 3).map((x) => 1000 * x)].join('\n');
    await viewer.after('diagram', () => drop('mm.csv', scaled));
    assert.match(
      await note.textContent(),
      /replaced by the 1 point of the file, .* away from the surface/,
    );
    await viewer.after('diagram', () => viewer.page.click('#undo'));
    assert.equal(await note.isVisible(), false);
    await viewer.after('diagram', () => viewer.page.click('#undo'));
  });

  test('a .ply without triangles has sites; too many are a scan, which is no surface', async () => {
    const before = await viewer.sites();
    const ply = (count, rows) =>
      [
        ...['ply', 'format ascii 1.0', `element vertex ${count}`],
        ...['x', 'y', 'z'].map((name) => `property float ${name}`),
        ...['end_header', ...rows, ''],
      ].join('\n');
    await viewer.after('diagram', () => drop('two.ply', ply(2, ['0 0 0', '0 1 0'])));
    assert.equal(await viewer.siteCount(), 2);
    const note = viewer.page.locator('#note');
    assert.match(
      await note.textContent(),
      /two\.ply has no triangles: .* replaced by the 2 points of the file\./,
    );
    await viewer.after('diagram', () => note.getByText('Undo').click());
    assert.deepEqual(await viewer.sites(), before);
    await drop('scan.ply', ply(20_001, Array(20_001).fill('0 0 0')));
    const error = viewer.page.locator('#error-text', {
      hasText: 'it has 20,001 points without triangles, more than 20,000.',
    });
    await error.waitFor();
    await viewer.page.click('#error-close');

    await own.choose({
      'a.ply': ply(3, ['0 0 1', '0 1 0', '1 0 0']),
      'mine.glb': glb(octahedron()),
    });
    await own.haveSites(3);
    assert.match(await own.page.locator('#samples').inputValue(), /^mine\.glb /);
  });

  test('joining is offered where triangles touch without being joined', async () => {
    const components = () => own.evaluate(({ info }) => info.components);
    await own.after('load', () => own.choose({ 'torn.glb': glb(torn(octahedron(), 1e-7)) }));
    assert.equal(await components(), 8);
    await own.after('load', () => own.page.getByText('Join them').click());
    assert.equal(await components(), 1);
    assert.equal(await own.page.locator('#weld').inputValue(), '1e-6');
    assert.equal(await own.page.locator('#note').getByText('touch without').isVisible(), false);
  });

  test('joining is not offered again where sheets overlap that it cannot join', async () => {
    const overlapping = {
      positions: [
        0, 0, 0, 2, 0, 0, 1, 0, 1, -1, 0, 0, 3, 0, 0, 1, 0, -1, 1, 0, 0, 0.5, 1, 0, 1.5, 1, 0,
      ],
      indices: [0, 1, 2, 3, 4, 5, 6, 7, 8],
    };
    await own.evaluate((viewer) => viewer.setAttribute('weld', '0'));
    await own.after('load', () => own.choose({ 'sheets.glb': glb(overlapping) }));
    await own.after('load', () => own.page.getByText('Join them').click());
    assert.equal(await own.evaluate(({ info }) => info.hasTJunctions), true);
    assert.equal(await own.page.getByText('Join them').isVisible(), false);
    assert.match(await own.page.locator('#note').innerText(), /cut apart/);
  });

  test('finer triangles are offered where regions are wrong', async () => {
    const plate = {
      positions: [0, 0.02].flatMap((z) => [0, 0, z, 1, 0, z, 1, 1, z, 0, 1, z]),
      indices: [
        ...[0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4],
        ...[1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7],
      ],
    };
    await own.after('diagram', () => own.evaluate((viewer) => viewer.setAttribute('sites', 4)));
    await own.choose({ 'mine.glb': glb(plate) });
    const note = own.page
      .locator('#note')
      .filter({ hasText: /about \d0 % .* in the wrong region/ });
    await note.waitFor();
    const placed = (count) =>
      own.after('diagram', () => own.evaluate((v, count) => v.setAttribute('sites', count), count));
    await placed(1);
    await note.waitFor({ state: 'hidden' });
    await placed(5);
    await note.waitFor(); // also of a later diagram
    await own.after('diagram', () => own.page.getByText('Finer triangles').click());
    assert.ok((await own.evaluate(({ info }) => info.faces)) > 100);
    assert.match(await own.page.locator('#repairs').textContent(), /12 triangles became/);
    assert.ok(Number(await own.page.locator('#max-edge').inputValue()) > 0);
    assert.equal(await note.isVisible(), false);
    await own.evaluate((element) => {
      element.density = new Float64Array(element.info.inputVertices).fill(10);
    });
    await own.after('diagram', () => own.evaluate((e) => e.setAttribute('max-edge', '0.05')));
    const densities = await own.evaluate(({ density }) => [...density]);
    assert.ok(densities.length > 500 && densities.every((rho) => Math.abs(rho - 10) < 1e-3));
    assert.ok(await own.page.locator('#undo').isDisabled(), 'the density is no step to undo');
  });

  test('a site that is dragged while a file replaces it is not moved any more', async () => {
    const place = await viewer.freePlace();
    await viewer.after('diagram', () => viewer.page.mouse.click(place.x, place.y));
    await viewer.page.mouse.move(place.x, place.y);
    await viewer.page.mouse.down();
    await viewer.after('diagram', () => viewer.page.mouse.move(place.x + 8, place.y + 8));
    const dragged = await viewer.sites();
    await viewer.after('diagram', () => drop('two.json', '{"vertex": [0, 900]}'));
    await viewer.page.mouse.move(place.x + 16, place.y + 16);
    await viewer.page.mouse.up();
    assert.equal(await viewer.siteCount(), 2);
    await viewer.after('diagram', () => viewer.page.click('#undo'));
    assert.deepEqual(await viewer.sites(), dragged, 'nothing but the file is to be undone');
  });

  test('a dual that is no valid mesh is told of when it is downloaded, with its repair', async () => {
    const five = '{"vertex": [1258, 1169, 1502, 445, 688]}';
    await viewer.after('diagram', () => drop('five.json', five));
    const note = viewer.page.locator('#note-text');
    const leftOut = 'The file leaves out 1 region of fewer than three corners';
    for (const [row, what] of [
      [
        'polygons',
        new RegExp(
          `^The polygons in the file are no valid mesh of the surface: .+\\. ${leftOut}\\.$`,
        ),
      ],
      ['dual', /^The dual in the file is no valid mesh of the surface: .+\.$/],
    ]) {
      await viewer.download(row, 'obj');
      await note.filter({ hasText: what }).waitFor();
    }
    await viewer.after('diagram', () => viewer.page.click('#note-action'));
    assert.ok((await viewer.siteCount()) > 5);
    assert.equal(await note.isVisible(), false);
    await viewer.download('dual', 'obj');
    assert.equal(await note.isVisible(), false);
  });

  test('a file that would be empty is not written, and a note goes with its file', async () => {
    await viewer.after('diagram', () => drop('three.json', '{"vertex": [0, 900, 1700]}'));
    await viewer.download('dual', 'obj');
    await viewer.page.locator('#note').waitFor();
    await viewer.download('sites', 'json');
    assert.equal(await viewer.page.locator('#note').isVisible(), false);

    await viewer.after('diagram', () => drop('one.json', '{"vertex": [900]}'));
    const menu = viewer.page.locator('#download');
    for (const [id, why] of [
      ['bisectors-glb', 'there are no bisectors'],
      ['bisectors-obj', 'there are no bisectors'],
      ['outlines-svg', 'no outline of a region is seen in this view'],
      ['dual-glb', 'the dual has no polygons'],
      ['polygons-obj', 'the regions have no polygons'],
    ]) {
      await viewer.page.click('#download-button');
      await viewer.page.click(`#download-${id}`);
      const error = viewer.page.locator('#error-text', { hasText: `cannot be made: ${why}.` });
      await error.waitFor();
      await menu.waitFor({ state: 'hidden' });
      assert.equal(await viewer.page.evaluate(() => document.activeElement.id), 'download-button');
      await viewer.page.click('#error-close');
    }
    // Whoever goes on meanwhile, as while a large file is made, is not called back.
    await viewer.page.click('#download-button');
    await viewer.page.evaluate(() => {
      const button = document.querySelector('#download-bisectors-glb');
      button.focus();
      button.click();
      document.querySelector('#count').focus();
    });
    await viewer.page.locator('#error').waitFor();
    await menu.waitFor({ state: 'hidden' });
    assert.equal(await viewer.page.evaluate(() => document.activeElement.id), 'count');
    await viewer.page.click('#error-close');
    // A press on the model closes a menu, and adds no site.
    const place = await viewer.freePlace();
    await viewer.page.click('#download-button');
    await menu.waitFor();
    await viewer.page.mouse.click(place.x, place.y);
    await menu.waitFor({ state: 'hidden' });
    assert.equal(await viewer.siteCount(), 1);
    for (let step = 0; step < 2; ++step)
      await viewer.after('diagram', () => viewer.page.click('#undo'));
  });

  test('sites count the triangles of the file, also of a mesh that was repaired', async () => {
    const { positions, indices } = octahedron();
    const model = glb({ positions, indices: [0, 0, 1, ...indices] });
    await own.after('diagram', () => own.choose({ 'own.glb': model }));
    assert.equal(await own.evaluate(({ info }) => info.faces), 8);
    const sites = { mesh: { faces: 9 }, face: [8, 1], bary: [1, 0, 0, 0, 1, 0] };
    await own.after('diagram', () => own.choose({ 's.json': JSON.stringify(sites) }));
    assert.deepEqual((await own.sites()).face, [8, 1]);
    const note = own.page.locator('#note-text');
    assert.equal(
      await note.textContent(),
      'The sites have been replaced by the 2 points of the file.',
    );
    await own.choose({ 's.json': JSON.stringify(sites) });
    await note.filter({ hasText: /^s\.json has the sites that are shown\.$/ }).waitFor();
  });

  test('a file that cannot be made without the server is told of in a sentence', async () => {
    const offline = await browser.open({
      complaint: /ERR_FAILED/,
      prepare: (page) => page.route(/\/exports-/, (route) => route.abort()),
    });
    await offline.page.click('#download-button');
    await offline.page.click('#download-sites-json');
    const error = offline.page.locator('#error-text');
    await error
      .filter({
        hasText:
          /^The file cannot be made: A part of this page cannot be fetched: try again when the server answers\.$/,
      })
      .waitFor();
    await offline.page.keyboard.press('Escape');
    assert.equal(await error.isVisible(), false, 'Escape closes it');
    await offline.close();
  });

  test('a file that its worker cannot receive or send is told of in a sentence', async () => {
    const receivesNone = (page) =>
      page.route(/encoding_worker/, (route) =>
        changedScript(route, () => {
          globalThis.onmessage = () => globalThis.onmessageerror(new MessageEvent('messageerror'));
        }),
      );
    const sendsNone = (page) =>
      page.addInitScript(() => {
        window.Worker = class extends Worker {
          postMessage(message, transfer) {
            if (message.encoding) this.dispatchEvent(new MessageEvent('messageerror'));
            else super.postMessage(message, transfer);
          }
        };
      });
    for (const [prepare, why] of [
      [receivesNone, 'its worker cannot receive it'],
      [sendsNone, 'what its worker has made cannot be received'],
    ]) {
      const { page } = await browser.open({ prepare });
      await page.click('#download-button');
      await page.click('#download-parts-obj');
      const error = page.locator('#error-text');
      await error.filter({ hasText: `The file cannot be made: ${why}.` }).waitFor();
    }
  });

  test('menus that could not be fetched come with the next model', async () => {
    const menus = /\/menus-/;
    const own = await browser.visit({
      complaint: /ERR_FAILED/,
      prepare: (page) => page.route(menus, (route) => route.abort()),
    });
    const { page } = own;
    const sentence = 'Downloads and links cannot be loaded: A part of this page cannot be fetched';
    await page.locator('#error-text', { hasText: sentence }).waitFor();
    await own.settled();
    await page.unroute(menus);
    await own.after('diagram', () => page.selectOption('#samples', 'torus.glb'));
    assert.match((await own.download('sites', 'csv')).content.toString(), /^x,y,z\n/);
  });

  test('outlines are what is seen of the bisectors', async () => {
    const { name, content } = await viewer.download('outlines', 'svg');
    assert.equal(name, 'bunny-outlines.svg');
    const svg = content.toString();
    const [, width, height] = svg.match(/viewBox="0 0 (\d+) (\d+)"/).map(Number);
    const drawn = svg.match(/[\d.]+ [\d.]+(?=[ML"])/g).map((place) => place.split(' ').map(Number));
    const { segments, arcs } = await viewer.evaluate(({ diagram: { data } }) => ({
      segments: data.segments.points.length / 2,
      arcs: data.arcs.offset.length - 1,
    }));
    const lines = svg.match(/M/g).length;
    assert.ok(lines < 1.5 * arcs, `${lines} lines for ${arcs} arcs`);
    const share = drawn.length / segments;
    assert.ok(share > 0.2 && share < 1.5, `${drawn.length} ends of ${segments} segments`);
    assert.ok(drawn.every(([x, y]) => x >= 0 && x <= width && y >= 0 && y <= height));
  });

  test('outlines are of one view: there are none if it changes meanwhile', async () => {
    const own = await browser.open();
    await own.evaluate((viewer) => {
      const { project } = viewer;
      viewer.project = (positions) => {
        viewer.cameraOrbit = '90deg 30deg 60%';
        const end = performance.now() + 13; // longer than a slice
        while (performance.now() < end);
        return project.call(viewer, positions);
      };
    });
    await own.page.click('#download-button');
    await own.page.click('#download-outlines-svg');
    await own.page.locator('#error-text', { hasText: 'the view has changed meanwhile' }).waitFor();
  });

  test('outlines end at the boundary of the mesh, which is among them', async () => {
    await own.after('load', () => own.choose({ 'grid.glb': glb(grid(4)) }));
    await own.after('diagram', () =>
      own.set({ sites: { face: [0, 31], bary: [1, 0, 0, 0, 1, 0] } }),
    );
    const lengthOf = (svg) =>
      [...svg.matchAll(/M([^M"]+)/g)].reduce((sum, [, chain]) => {
        const places = chain.split('L').map((place) => place.split(' ').map(Number));
        const pieces = places
          .slice(1)
          .map(([x, y], i) => Math.hypot(x - places[i][0], y - places[i][1]));
        return pieces.reduce((a, b) => a + b, sum);
      }, 0);
    const corners = await own.evaluate((viewer) =>
      viewer.project([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]),
    );
    const around = corners.reduce((sum, { x, y }, i) => {
      const next = corners[(i + 1) % 4];
      return sum + Math.hypot(next.x - x, next.y - y);
    }, 0);
    const diagonal = Math.hypot(corners[3].x - corners[1].x, corners[3].y - corners[1].y);
    const { content } = await own.download('outlines', 'svg');
    const length = lengthOf(content.toString());
    assert.ok(
      Math.abs(length / (around + diagonal) - 1) < 0.05,
      `${length} of ${around + diagonal}`,
    );
  });

  test('a picture is as large as was asked for', async () => {
    const [once, twice] = [
      await viewer.download('picture', '1x'),
      await viewer.download('picture', '2x'),
    ];
    const size = ({ content }) => [content.readUInt32BE(16), content.readUInt32BE(20)];
    assert.deepEqual(
      size(twice),
      size(once).map((pixels) => 2 * pixels),
    );
    assert.equal(once.name, 'bunny-picture.png');
    assert.equal(twice.name, 'bunny-picture@2x.png');
  });

  test('regions in a file have the colours and the numbers of the page', async () => {
    const { content } = await viewer.download('parts', 'glb');
    const json = jsonOf(content);
    const colours = await viewer.evaluate((viewer) =>
      [...viewer.sites.face.keys()].map((i) => viewer.regionColour(i)),
    );
    const hex = (linear) =>
      linear
        .slice(0, 3)
        .map((c) => (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055))
        .map((c) =>
          Math.round(255 * c)
            .toString(16)
            .padStart(2, '0'),
        )
        .join('');
    json.materials.forEach(({ name, pbrMetallicRoughness }) => {
      const label = Number(name.match(/\d+/)[0]);
      assert.equal(`#${hex(pbrMetallicRoughness.baseColorFactor)}`, colours[label]);
    });
  });

  test('regions in a file have the colours that they had when it was asked for', async () => {
    const own = await browser.open();
    const colours = () =>
      own.evaluate((viewer) => [...viewer.regionAreas.keys()].map((i) => viewer.regionColour(i)));
    const before = await colours();
    await own.evaluate((viewer) => {
      const { diagram } = viewer;
      const { partition } = diagram;
      diagram.partition = async () => {
        const parts = await partition.call(diagram);
        const drawn = new Promise((resolve) => viewer.addEventListener('diagram', resolve));
        viewer.sites = { face: [0, 100], bary: [1, 0, 0, 1, 0, 0] };
        await drawn;
        return parts;
      };
    });
    const { materials } = jsonOf((await own.download('parts', 'glb')).content);
    assert.equal(
      new Set(materials.map((m) => String(m.pbrMetallicRoughness?.baseColorFactor))).size,
      new Set(before).size,
    );
    assert.notEqual((await colours()).length, before.length);
  });

  test('a file has the diagram that is asked for, and that of a tessellation pauses it', async () => {
    const [coarse, fine] = ['0', '2'];
    const sizeOf = async (prepare, argument) => {
      const [file] = await Promise.all([
        viewer.page.waitForEvent('download'),
        viewer.evaluate(
          `(viewer, argument) => {
            (${prepare})(viewer, argument);
            setTimeout(() => document.getElementById('download-diagram-json').click());
          }`,
          argument,
        ),
      ]);
      let size = 0;
      for await (const chunk of await file.createReadStream()) size += chunk.length;
      await viewer.settled();
      return size;
    };
    const detail = (viewer, detail) => viewer.setAttribute('detail', detail);
    const large = await sizeOf(detail, fine);
    assert.ok(large > 1.2 * (await sizeOf(detail, coarse)));
    await sizeOf((viewer) => viewer.playCvt());
    assert.equal(await viewer.evaluate((viewer) => viewer.cvtStatus), 'paused');
    assert.equal(await viewer.page.locator('#error').isVisible(), false);
    await viewer.after('diagram', () => viewer.evaluate((viewer) => viewer.resetCvt()));
  });

  test('a file is called after its model, and told of if that is gone before it is made', async () => {
    const own = await browser.open();
    await own.evaluate((viewer) => {
      const { toBlob } = viewer;
      viewer.toBlob = async (...format) => {
        const blob = await toBlob.apply(viewer, format);
        await viewer.load('samples/torus.glb');
        return blob;
      };
    });
    assert.equal((await own.download('picture', '1x')).name, 'bunny-picture.png');
    await own.settled();
    await own.evaluate(({ diagram }) => {
      const { partition } = diagram;
      diagram.partition = () => {
        diagram.dispose();
        return partition.apply(diagram);
      };
    });
    await own.page.click('#download-button');
    await own.page.click('#download-parts-obj');
    const error = own.page.locator('#error-text');
    await error.filter({ hasText: 'its diagram has been replaced by another one' }).waitFor();
  });

  test('every file of the menu can be had, also after a change', async () => {
    await viewer.after('diagram', () =>
      viewer.evaluate((viewer) => viewer.addSite({ face: 0, bary: [1, 0, 0] })),
    );
    const regions = await viewer.siteCount();
    const isGlb = (content) => content.subarray(0, 4).toString() === 'glTF';
    const isObj = (content) => /^v /m.test(content) && /^[fl] /m.test(content);
    const isPly = (content) => content.subarray(0, 3).toString() === 'ply';
    const isStl = (content) => content.length === 84 + 50 * content.readUint32LE(80);
    const isDiagram = (content) => JSON.parse(content).regions.length === regions;
    const isTable = (content) => content.toString().trim().split('\n').length === regions + 1;
    const isPng = (content) => content.subarray(1, 4).toString() === 'PNG';
    const files = [
      ['diagram', 'json', isDiagram],
      ['regions', 'csv', isTable],
      ['bisectors', 'glb', isGlb],
      ['bisectors', 'obj', isObj],
      ['picture', '1x', isPng],
    ];
    for (const row of ['parts', 'polygons', 'dual']) {
      files.push([row, 'glb', isGlb], [row, 'obj', isObj], [row, 'ply', isPly]);
      if (row !== 'parts') files.push([row, 'stl', isStl]);
    }
    for (const [row, format, isRight] of files) {
      const { name, content } = await viewer.download(row, format);
      assert.equal(name, `bunny-${row}.${row === 'picture' ? 'png' : format}`);
      assert.ok(isRight(content), name);
    }
    const { name, content } = await viewer.download('parts', 'stl');
    assert.equal(name, 'bunny-parts.zip');
    const parts = Object.entries(unzipSync(content));
    const digits = String(regions - 1).length;
    assert.deepEqual(
      parts.map(([part]) => part).sort(),
      Array.from({ length: regions }, (_, i) => `region-${String(i).padStart(digits, '0')}.stl`),
    );
    for (const [part, stl] of parts) assert.ok(isStl(Buffer.from(stl)) && stl.length > 84, part);
  });
});
