// SPDX-License-Identifier: MIT
//
// The first script to run: fetches what the page will need while the large one arrives, and shows
// how much of it has come.

import core from 'geodesic-voronoi/core.wasm?url';
import { byId } from './base/dom.js';
import { modelOf } from './samples/first_model.js';

/** The uncompressed bytes of everything that is fetched here, inserted by the build. */
declare const firstBytes: number;

// The poster is of the model that the page opens with, unless a link names another.
const address = modelOf(location.hash);
byId('poster', HTMLElement).hidden = address !== modelOf('');

const bar = byId('progress-bar', HTMLProgressElement);
let received = 0;

async function fetchCounted(address: string, signal?: AbortSignal): Promise<Response> {
  const response = await fetch(address, { signal });
  count(response.clone()).catch(() => {});
  return response;
}

/** Reads a response to its end and counts its bytes. */
async function count({ body }: Response): Promise<void> {
  const reader = body?.getReader();
  for (let part = await reader?.read(); part?.value; part = await reader?.read()) {
    received += part.value.length;
    bar.value = Math.max(bar.value, Math.min(0.95, received / firstBytes));
  }
}

// A fetch that fails is repeated, or reported, where its result is needed. The first model needs no
// other module than this one.
const modules = WebAssembly.compileStreaming(fetchCounted(core)).then((wasm) => ({ wasm }));
const opening = new AbortController();
const response = fetchCounted(address, opening.signal);
for (const each of [modules, response]) each.catch(() => {});

void import('./main.js').then(
  ({ setUpPage }) => setUpPage(modules, { address, response, opening }),
  tellFailure,
);

/** Reports that the large script failed; only this one is left to do so. */
function tellFailure({ message }: Error): void {
  byId('progress', HTMLElement).hidden = true;
  byId('error-close', HTMLElement).hidden = true;
  byId('error-text', HTMLElement).textContent =
    `The page cannot be loaded: ${message}. Reload it to try again.`;
  byId('error', HTMLElement).hidden = false;
  byId('status', HTMLElement).textContent = 'No model is open.';
}
