// The areas of the regions of many models, as a table: each model in a worker thread, as many at once
// as the machine has processors. A model that takes longer than a minute, or cannot be read, is
// passed over with a message.
//
//     node many-models.mjs 20 models/*.stl > areas.csv
import { readFile } from 'node:fs/promises';
import { availableParallelism } from 'node:os';
import { isMainThread, parentPort, Worker, workerData } from 'node:worker_threads';
import { compileModules, load } from 'geodesic-voronoi';

if (isMainThread) {
  const [count, ...models] = process.argv.slice(2);
  const rows = new Map();
  let done = 0;
  const modules = await compileModules(); // once for all threads
  const waiting = [...models.entries()];
  async function work() {
    for (let next = waiting.shift(); next !== undefined; next = waiting.shift()) {
      const [i, model] = next;
      try {
        rows.set(i, await areasInThread({ modules, model, count: Number(count) }));
      } catch (error) {
        console.error(`${model}: ${error.message}`);
      }
      console.error(`${++done} of ${models.length} done`);
    }
  }
  await Promise.all(Array.from({ length: availableParallelism() }, work));
  console.log('model,label,area');
  models.forEach((model, i) =>
    rows.get(i)?.forEach((area, label) => console.log(`${model},${label},${area}`)),
  );
} else {
  const { modules, model, count } = workerData;
  const gvd = await load(modules);
  const signal = AbortSignal.timeout(60_000);
  const mesh = await gvd.mesh(await readFile(model), { signal });
  const sites = await mesh.sampleSites(count, { seed: 1, signal }); // the same at each run
  const diagram = await mesh.voronoi(sites, { signal });
  parentPort.postMessage(diagram.data.regionArea);
}

function areasInThread(task) {
  return new Promise((resolve, reject) => {
    const thread = new Worker(new URL(import.meta.url), { workerData: task });
    thread.once('message', resolve).once('error', reject);
  });
}
