// SPDX-License-Identifier: MIT
//
// npm run docs [-- pictures]: draws the figures and plots anew, writes the tables into the documents,
// and makes build/page/docs of them, with the reference of the API. With `pictures`, the page is
// photographed too, which takes a browser.

import { existsSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { buildPage } from './build.mjs';
import { setUp } from './setup.mjs';
import { announce, at, hasCommand, isScript, main, run, step } from './tasks.mjs';

const output = 'build/page/docs';
const make = (name) => import(`../web/docs/make/${name}.mjs`);

/** build/page/docs, when the page is there. */
export async function buildDocs() {
  const reference = '.dev/reference';
  await step(
    'Documents',
    {
      inputs: ['README.md', '.github', 'web/docs', reference, 'core/include', 'dist'],
      outputs: [`${output}/index.html`],
    },
    async () => {
      const typedoc = [`${reference}/node_modules`, 'node_modules']
        .map((modules) => at(modules, '.bin/typedoc'))
        .find(existsSync);
      if (!typedoc)
        throw new Error('TypeDoc is not there, which makes the reference: npm ci installs it');
      rmSync(at(output), { recursive: true, force: true });
      const hasDoxygen = hasCommand('doxygen');
      if (!hasDoxygen) {
        announce('doxygen is not there: the documents go without the reference of the C++ headers');
      }
      const { writePages } = await make('pages');
      writePages(at(output), (target) => hasDoxygen || !target.includes('cpp'));
      const options = [
        '--options',
        `${reference}/typedoc.json`,
        '--tsconfig',
        `${reference}/tsconfig.json`,
      ];
      run(typedoc, [...options, '--logLevel', 'Warn']);
      if (hasDoxygen) run('doxygen', [`${reference}/Doxyfile`]);
    },
  );
}

/** What is in the repository, and made by scripts: figures, plots and tables. */
async function writeMeasured() {
  const read = (name) => JSON.parse(readFileSync(at('web/docs', name), 'utf8'));
  const [measured, peers] = [read('bench.json'), read('peers.json')];
  const { plots, withTables } = await make('measured');
  for (const [name, text] of Object.entries(plots(measured, peers))) {
    writeFileSync(at('web/docs/plots', name), text);
  }
  for (const path of ['README.md', 'web/docs/performance.md']) {
    const text = readFileSync(at(path), 'utf8');
    writeFileSync(at(path), withTables(text, measured, peers));
  }
}

async function writeFigures() {
  const { makeFigures } = await make('figures');
  for (const [name, text] of Object.entries(await makeFigures())) {
    writeFileSync(at('web/docs/figures', name), text);
  }
}

if (isScript(import.meta.url)) {
  await main(async () => {
    setUp(process.argv.includes('pictures') ? 'test' : 'build');
    await buildPage();
    announce('Figures, plots and tables');
    await writeFigures();
    await writeMeasured();
    if (process.argv.includes('pictures')) {
      announce('Pictures');
      const { takePictures } = await make('pictures');
      await takePictures(at('web/docs/pictures'));
    }
    await buildDocs();
  });
}
