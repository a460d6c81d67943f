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

/** Reads it to the end, for the cache: whoever needs it asks again. */
async function fetchEarly(address: string): Promise<void> {
  const { body } = await fetch(address);
  const reader = body?.getReader();
  for (let part = await reader?.read(); part?.value; part = await reader?.read()) {
    received += part.value.length;
    bar.value = Math.max(bar.value, Math.min(0.95, received / firstBytes));
  }
}

for (const address of [core, gltf, modelOf(location.hash)]) {
  // What fails is asked for again, and told of, where it is needed.
  fetchEarly(address).catch(() => {});
}

void import('./main.js').then(({ setUpPage }) => setUpPage());
