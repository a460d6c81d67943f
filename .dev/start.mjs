// SPDX-License-Identifier: MIT
//
// npm start [-- OPTIONS]: builds what has changed and serves the page; --help tells the options.

import { parseArgs } from 'node:util';
import { buildPage } from './build.mjs';
import { buildDocs } from './docs.mjs';
import { setUp } from './setup.mjs';
import { at, main } from './tasks.mjs';

const usage = `Usage: npm start [-- OPTIONS]

Builds what has changed, serves the page and prints its address.

  --port N        where to serve it, or at the next port that is free (default: 4173)
  --host ADDRESS  who can reach it: 0.0.0.0 for other devices, too (default: localhost)`;

await main(async () => {
  const { values } = parseArgs({
    options: {
      port: { type: 'string', default: '4173' },
      host: { type: 'string', default: 'localhost' },
      help: { type: 'boolean' },
    },
  });
  if (values.help) {
    console.log(usage);
    return;
  }
  const port = Number(values.port);
  if (!Number.isInteger(port) || port < 1 || port > 65535)
    throw new Error(`--port is '${values.port}', not an integer from 1 to 65535`);
  setUp('build');
  await buildPage();
  await buildDocs();

  const { preview } = await import('vite');
  const server = await preview({
    root: at('web/page'),
    appType: 'mpa', // an address where there is nothing is an error, not the page again
    preview: { port, host: values.host },
  });
  console.log('\nThe page is at');
  server.printUrls();
});
