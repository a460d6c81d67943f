// SPDX-License-Identifier: MIT
//
// The first script to run: fetches what the page will need while the large one arrives, and shows how much
// of it has come.

import core from 'geodesic-voronoi/core.wasm?url';
import gltf from 'geodesic-voronoi/gltf.wasm?url';
import { byId } from './dom.js';
import { modelOf } from './first_model.js';

/** Of what is fetched here, before compression; the build knows. */
declare const firstBytes: number;

const bar = byId('progress-bar', HTMLProgressElement);
let received = 0;

async function fetchModule(address: string): Promise<Response> {
  const response = await fetch(address);
  count(response.clone()).catch(() => {});
  return response;
}

/** Reads it to the end. */
async function count({ body }: Response): Promise<void> {
  const reader = body?.getReader();
  for (let part = await reader?.read(); part?.value; part = await reader?.read()) {
    received += part.value.length;
    bar.value = Math.max(bar.value, Math.min(0.95, received / firstBytes));
  }
}

// What fails is asked for again, and told of, where it is needed.
const modules = Promise.all([core, gltf].map(fetchModule)).then(([wasm, gltfWasm]) => ({
  wasm,
  gltfWasm,
}));
modules.catch(() => {});
// For the cache: the viewer asks for it again.
fetch(modelOf(location.hash))
  .then(count)
  .catch(() => {});

void import('./main.js').then(({ setUpPage }) => setUpPage(modules));
