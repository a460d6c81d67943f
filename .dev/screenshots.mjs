// SPDX-License-Identifier: MIT
//
// node .dev/screenshots.mjs [name …]: pictures of the page in all its states, for people to look at, in
// build/screenshots, or only of the states, widths and schemes named; `poster` makes web/page/poster.webp.

import { mkdirSync, writeFileSync } from 'node:fs';
import { startBrowser } from '../tests/web/browser.mjs';
import { at, main } from './tasks.mjs';

const folder = at('build', 'screenshots');
const sizes = [
  { width: 390, height: 844 },
  { width: 1280, height: 720 },
  { width: 1440, height: 900 },
];
const schemes = ['light', 'dark'];

const click = (selector) => (viewer) => viewer.page.click(selector);
const evaluate = (f) => async (viewer) => {
  await viewer.evaluate(f);
  await viewer.settled();
};
const isSheetOpen = async ({ page }) =>
  (await page.getAttribute('#sheet', 'aria-expanded')) === 'true';
const openSheet = async (viewer) => {
  if (!(await isSheetOpen(viewer))) await viewer.page.click('#sheet');
};
/** Where there is one: beside the view, the controls stay. */
const closeSheet = async (viewer) => {
  if (await viewer.page.isVisible('#sheet')) await viewer.page.click('#sheet');
};
const toggleLayer = ({ page }, name) => page.click(`#layers label:has-text("${name}")`);

/** What is done to the page, by the name of the picture. */
const states = {
  even: () => {},
  random: (viewer) => viewer.after('diagram', () => viewer.page.click('#undo')),
  controls: openSheet,
  'all-controls': async (viewer) => {
    await openSheet(viewer);
    await viewer.page.evaluate(() => {
      for (const group of document.querySelectorAll('#panel details')) group.open = true;
    });
  },
  chosen: evaluate((viewer) => {
    viewer.selected = 12;
  }),
  layers: async (viewer) => {
    await openSheet(viewer);
    for (const name of ['Voronoi points', 'Wireframe']) await toggleLayer(viewer, name);
    await viewer.after('dual', () => toggleLayer(viewer, 'Dual'));
    await closeSheet(viewer);
  },
  distances: async (viewer) => {
    await openSheet(viewer);
    for (const name of ['Bisectors', 'Distances']) await toggleLayer(viewer, name);
    await viewer.page.waitForFunction(() => {
      const { shadowRoot } = document.querySelector('geodesic-voronoi');
      return !shadowRoot.querySelector('.distances').hidden;
    });
    await closeSheet(viewer);
  },
  exploded: (viewer) => viewer.after('exploded', () => viewer.evaluate((v) => (v.exploded = 0.6))),
  note: async (viewer) => {
    await states.exploded(viewer);
    await viewer.page.click('#view', { position: { x: 200, y: 300 } });
  },
  hover: async (viewer) => {
    const { x, y } = await viewer.freePlace();
    await viewer.page.mouse.move(x, y);
    await viewer.page.waitForSelector('#readout:not([hidden])');
  },
  drop: ({ page }) =>
    page.evaluate(() => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([''], 'model.glb'));
      dispatchEvent(new DragEvent('dragover', { dataTransfer }));
    }),
  download: click('#download-button'),
  share: click('#share-button'),
  help: click('#help-button'),
  error: (viewer) => viewer.after('error', () => viewer.choose({ 'a.txt': 'a' })),
};

/** Opens as it does for everybody, and waits until the regions are even. */
async function opened(browser, context) {
  const viewer = await browser.visit({ hash: '', reducedMotion: 'no-preference', ...context });
  await viewer.page.locator('#cvt-state', { hasText: 'Finished' }).waitFor({ state: 'attached' });
  await viewer.settled();
  return viewer;
}

/** Those of a list that were asked for; all of them if none was. */
const chosen = (all, names) => {
  const those = all.filter((each) => names.includes(each));
  return those.length > 0 ? those : all;
};

async function takeAll(browser, names) {
  mkdirSync(folder, { recursive: true });
  const widths = chosen(
    sizes.map(({ width }) => String(width)),
    names,
  );
  for (const viewport of sizes.filter(({ width }) => widths.includes(String(width)))) {
    for (const colorScheme of chosen(schemes, names)) {
      for (const name of chosen(Object.keys(states), names)) {
        const viewer = await opened(browser, {
          viewport,
          colorScheme,
          hasTouch: viewport.width < 500,
        });
        await states[name](viewer);
        await viewer.page.waitForTimeout(400); // the status line waits a moment
        const path = `${folder}/${name}-${viewport.width}-${colorScheme}.png`;
        await viewer.page.screenshot({ path });
        await viewer.close();
        console.log(path);
      }
    }
  }
}

/** What is seen first, as small as it may be, without its background and the room for the caption. */
async function makePoster(browser) {
  const viewer = await browser.open({
    viewport: { width: 480 + 320, height: 480 + 52 },
    hash: '#v=1&sites=60&seed=4',
  });
  const address = await viewer.evaluate(async (viewer) => {
    viewer.style.cssText = 'width: 480px; height: 480px; padding: 0';
    await new Promise((resolve) => setTimeout(resolve, 500));
    const blob = await viewer.toBlob('image/webp', 0.45);
    return new Promise((resolve) => {
      const reader = new FileReader();
      reader.onload = () => resolve(reader.result);
      reader.readAsDataURL(blob);
    });
  });
  const bytes = Buffer.from(address.split(',')[1], 'base64');
  writeFileSync(at('web', 'page', 'poster.webp'), bytes);
  console.log(`web/page/poster.webp: ${bytes.length} bytes`);
  await viewer.close();
}

await main(async () => {
  const names = process.argv.slice(2);
  const browser = await startBrowser({}, { antialias: true });
  try {
    if (names.includes('poster')) await makePoster(browser);
    else await takeAll(browser, names);
  } finally {
    await browser.stop();
  }
});
