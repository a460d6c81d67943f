// SPDX-License-Identifier: MIT
//
// The same meshes and sites through WebAssembly, as others get it: `voronoi` to the arrays.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { load } from 'geodesic-voronoi';

/**
 * Adds `wasm`, the seconds of a diagram, to every metric of gvd_bench's `speed` that has times, or
 * `wasmNote`, why there are none. The meshes are in a folder, as GLBs.
 */
export async function measureWasm({ speed, seed, runs, detail }, folder) {
  const gvd = await load();
  for (const name of new Set(speed.map(({ mesh }) => mesh))) {
    const mesh = await gvd.mesh(readFileSync(join(folder, `${name}.glb`)));
    for (const { sites, metrics } of speed.filter((entry) => entry.mesh === name)) {
      console.error(`${name}, ${sites} ${sites === 1 ? 'site' : 'sites'}, in WebAssembly`);
      const points = await mesh.sampleSites(sites, { seed });
      for (const [metric, times] of Object.entries(metrics)) {
        if (times.note) continue;
        try {
          const work = () => mesh.voronoi(points, { metric, detail });
          await warmUp(work);
          times.wasm = await leastSeconds(runs, work);
        } catch (error) {
          times.wasmNote = `WebAssembly: ${error.message}`;
        }
      }
    }
    mesh.dispose();
  }
  gvd.dispose();
}

/**
 * Code is compiled quickly first, and again for speed once it has run for a while, on other threads of
 * this process: neither is to count.
 */
async function warmUp(work) {
  const milliseconds = 300;
  const end = performance.now() + milliseconds;
  do (await work()).dispose();
  while (performance.now() < end);
}

/** CPU time of this process: other processes do not count. */
async function leastSeconds(runs, work) {
  let least = Infinity;
  for (let i = 0; i < runs; ++i) {
    const start = process.cpuUsage();
    const result = await work();
    const { user, system } = process.cpuUsage(start);
    result.dispose();
    least = Math.min(least, (user + system) / 1e6);
  }
  return least;
}
