// SPDX-License-Identifier: MIT
//
// What is dropped on the page and what is downloaded from it, besides models.

import assert from 'node:assert/strict';
import { after, before, suite, test } from 'node:test';
import { startBrowser } from './browser.mjs';

suite('files', () => {
  let browser;
  let viewer;
  before(async () => {
    browser = await startBrowser();
    viewer = await browser.open();
    await viewer.settled();
  });
  after(async () => {
    assert.deepEqual(viewer.complaints, []);
    await browser.stop();
  });

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

  async function download(row, format) {
    await viewer.page.click('#download-button');
    const [file] = await Promise.all([
      viewer.page.waitForEvent('download'),
      viewer.page.click(`#download-${row}-${format}`),
    ]);
    const chunks = [];
    for await (const chunk of await file.createReadStream()) chunks.push(chunk);
    return { name: file.suggestedFilename(), content: Buffer.concat(chunks) };
  }

  test('sites that were downloaded are dropped to bring them back, a step to undo', async () => {
    const { name, content } = await download('sites', 'json');
    assert.equal(name, 'bunny-sites.json');
    const sites = await viewer.sites();
    await viewer.after('diagram', () => viewer.evaluate((viewer) => viewer.removeSite(0)));
    await viewer.after('diagram', () => drop(name, content.toString()));
    assert.deepEqual(await viewer.sites(), sites);
    await viewer.after('diagram', () => viewer.page.click('#undo'));
    assert.equal(await viewer.siteCount(), 59);

    const wrong = {
      '{': 'is no JSON that can be read',
      '{"face": [1], "bary": [1, 0]}': 'is no list of sites',
      '{"face": [999999], "bary": [1, 0, 0]}':
        'belongs to another model: this one has 58784 triangles',
    };
    for (const [text, sentence] of Object.entries(wrong)) {
      await drop('wrong.json', text);
      await viewer.page.locator('#error-text', { hasText: `wrong.json ${sentence}` }).waitFor();
    }
    assert.equal(await viewer.siteCount(), 59);
    await viewer.page.click('#error-close');
  });

  test('outlines are what is seen of the bisectors', async () => {
    const { name, content } = await download('outlines', 'svg');
    assert.equal(name, 'bunny-outlines.svg');
    const svg = content.toString();
    const [, width, height] = svg.match(/viewBox="0 0 (\d+) (\d+)"/).map(Number);
    const drawn = svg.match(/[\d.]+ [\d.]+(?=[ML"])/g).map((place) => place.split(' ').map(Number));
    const { segments } = await viewer.evaluate(({ diagram }) => ({
      segments: diagram.data.segments.points.length / 2,
    }));
    const share = drawn.length / segments;
    assert.ok(share > 0.2 && share < 1.5, `${drawn.length} ends of ${segments} segments`);
    assert.ok(drawn.every(([x, y]) => x >= 0 && x <= width && y >= 0 && y <= height));
  });

  test('a picture is as large as was asked for', async () => {
    const [once, twice] = [await download('picture', '1x'), await download('picture', '2x')];
    const size = ({ content }) => [content.readUInt32BE(16), content.readUInt32BE(20)];
    assert.deepEqual(
      size(twice),
      size(once).map((pixels) => 2 * pixels),
    );
    assert.equal(twice.name, 'bunny-picture.png');
  });

  test('regions in a file have the colours and the numbers of the page', async () => {
    const { content } = await download('parts', 'glb');
    const json = JSON.parse(content.subarray(20, 20 + content.readUInt32LE(12)));
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

  test('every file of the menu can be had, also after a change', async () => {
    await viewer.after('diagram', () =>
      viewer.evaluate((viewer) => viewer.addSite({ face: 0, bary: [1, 0, 0] })),
    );
    const regions = await viewer.siteCount();
    const isGlb = (content) => content.subarray(0, 4).toString() === 'glTF';
    const isObj = (content) => /^v /m.test(content) && /^[fl] /m.test(content);
    const isPly = (content) => content.subarray(0, 3).toString() === 'ply';
    const isDiagram = (content) => JSON.parse(content).regions.length === regions;
    const isPng = (content) => content.subarray(1, 4).toString() === 'PNG';
    const files = [
      ['diagram', 'json', isDiagram],
      ['bisectors', 'glb', isGlb],
      ['bisectors', 'obj', isObj],
      ['picture', '1x', isPng],
    ];
    for (const row of ['parts', 'polygons', 'dual']) {
      files.push([row, 'glb', isGlb], [row, 'obj', isObj], [row, 'ply', isPly]);
    }
    for (const [row, format, isRight] of files) {
      const { name, content } = await download(row, format);
      assert.equal(name, `bunny-${row}.${row === 'picture' ? 'png' : format}`);
      assert.ok(isRight(content), name);
    }
  });
});
