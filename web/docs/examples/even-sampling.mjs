// Points spread evenly over a scan.
//
//     node even-sampling.mjs scan.glb 300 points.ply
import { readFile, writeFile } from 'node:fs/promises';
import { load } from 'geodesic-voronoi';

const [model, count = '300', output = 'points.ply'] = process.argv.slice(2);
if (!model) throw new Error('usage: node even-sampling.mjs MODEL [COUNT] [OUTPUT]');
const gvd = await load();
const mesh = await gvd.mesh(await readFile(model));

// Each site moves to the centroid of its region, until regions are as compact as they can be.
let state;
const sites = await mesh.sampleSites(Number(count), { sampling: 'poisson' });
for await (state of mesh.cvt(sites, { iterations: 30, energyTolerance: 1e-3, data: true }));

const positions = await mesh.positionsOf(state.sites); // x, y, z each
const lines = Array.from(state.sites.face, (_, i) => positions.slice(3 * i, 3 * i + 3).join(' '));
const axes = ['x', 'y', 'z'].map((axis) => `property double ${axis}\n`).join('');
const header = `ply\nformat ascii 1.0\nelement vertex ${lines.length}\n${axes}end_header\n`;
await writeFile(output, `${header}${lines.join('\n')}\n`);

const areas = state.data.regionArea;
const spread = Math.max(...areas) / Math.min(...areas);
console.log(
  `${lines.length} points; the largest region has ${spread.toFixed(2)} × the smallest's area`,
);
gvd.dispose();
