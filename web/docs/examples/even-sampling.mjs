// Points spread evenly over a scan.
//
//     node even-sampling.mjs scan.glb 300 points.ply
import { readFile, writeFile } from 'node:fs/promises';
import { load } from 'geodesic-voronoi';

const [model, count = '300', output = 'points.ply'] = process.argv.slice(2);
const gvd = await load();
const mesh = await gvd.mesh(await readFile(model));

// Each site moves to the centroid of its region, until regions are as compact as they can be.
let state;
const sites = await mesh.sampleSites(Number(count), { sampling: 'poisson' });
for await (state of mesh.cvt(sites, { iterations: 30, energyTolerance: 1e-3, data: true }));

// A surface point is a face and barycentric coordinates: a blend of the corners.
const { face, bary } = state.sites;
const places = Array.from(face, (f, i) =>
  [0, 1, 2].map((axis) =>
    [0, 1, 2].reduce(
      (sum, k) => sum + bary[3 * i + k] * mesh.positions[3 * mesh.indices[3 * f + k] + axis],
      0,
    ),
  ),
);
const axes = ['x', 'y', 'z'].map((axis) => `property double ${axis}\n`).join('');
const header = `ply\nformat ascii 1.0\nelement vertex ${places.length}\n${axes}end_header\n`;
await writeFile(output, `${header}${places.map((place) => place.join(' ')).join('\n')}\n`);

const areas = state.data.regionArea;
const spread = Math.max(...areas) / Math.min(...areas);
console.log(
  `${places.length} points; the largest region has ${spread.toFixed(2)} × the smallest's area`,
);
gvd.dispose();
