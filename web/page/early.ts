// SPDX-License-Identifier: MIT
//
// The first script to run: fetches what the page will need while the large one arrives, and shows how much
// of it has come.

import core from 'geodesic-voronoi/core.wasm?url';
import { byId } from './dom.js';
import { modelOf } from './first_model.js';

/** Of what is fetched here, before compression; the build knows. */
declare const firstBytes: number;

const bar = byId('progress-bar', HTMLProgressElement);
let received = 0;

async function fetchModule(address: string): Promise<Response> {
  const response = await fetch(address);
  partsOf(response.clone()).catch(() => {});
  return response;
}

async function fetchModel(address: string): Promise<File> {
  const response = await fetch(address);
  if (!response.ok) throw new Error(response.statusText);
  return new File(await partsOf(response), address.slice(address.lastIndexOf('/') + 1));
}

/** Reads it to the end. */
async function partsOf({ body }: Response): Promise<Uint8Array<ArrayBuffer>[]> {
  const parts: Uint8Array<ArrayBuffer>[] = [];
  const reader = body?.getReader();
  for (let part = await reader?.read(); part?.value; part = await reader?.read()) {
    parts.push(part.value);
    received += part.value.length;
    bar.value = Math.max(bar.value, Math.min(0.95, received / firstBytes));
  }
  return parts;
}

// What fails is asked for again, and told of, where it is needed. The model that the page opens with needs
// no other module.
const modules = WebAssembly.compileStreaming(fetchModule(core)).then((wasm) => ({ wasm }));
const model = fetchModel(modelOf(location.hash));
for (const each of [modules, model]) each.catch(() => {});

void import('./main.js').then(({ setUpPage }) => setUpPage(modules, model));
