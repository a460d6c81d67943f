// SPDX-License-Identifier: MIT
//
// Serves a folder as if npm had installed this package and its peers in it.

import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const root = new URL('../../../', import.meta.url);
const mediaTypes = {
  '.glb': 'model/gltf-binary',
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.wasm': 'application/wasm',
};

/** Resolves to the `address`; `close()` ends it. */
export async function servePackages(folder) {
  const installed = '/node_modules/geodesic-voronoi/';
  const fileOf = (path) => {
    if (path.startsWith(installed)) return new URL(path.slice(installed.length), root);
    if (path.startsWith('/node_modules/')) return new URL(`.${path}`, root);
    return new URL(`.${path === '/' ? '/index.html' : path}`, pathToFileURL(`${folder}/`));
  };
  const server = createServer(async (request, response) => {
    const file = fileOf(decodeURIComponent(new URL(request.url, 'http://page').pathname));
    try {
      const content = await readFile(fileURLToPath(file));
      const type = mediaTypes[extname(file.pathname)] ?? 'application/octet-stream';
      response.writeHead(200, { 'Content-Type': type }).end(content);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return { address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}
