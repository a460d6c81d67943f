// SPDX-License-Identifier: MIT
//
// npm start [-- --port N --host ADDRESS]: builds what has changed and serves the page.

import { parseArgs } from 'node:util';
import { buildPage } from './build.mjs';
import { buildDocs } from './docs.mjs';
import { setUp } from './setup.mjs';
import { at, main } from './tasks.mjs';

await main(async () => {
  const { values } = parseArgs({
    options: {
      port: { type: 'string', default: '4173' },
      host: { type: 'string', default: 'localhost' },
    },
  });
  setUp('build');
  await buildPage();
  await buildDocs();

  const { preview } = await import('vite');
  const server = await preview({
    root: at('web/page'),
    appType: 'mpa', // an address where there is nothing is an error, not the page again
    preview: { port: Number(values.port), host: values.host },
  });
  console.log('\nThe page is at');
  server.printUrls();
});
