// The logarithmic map of one point as a PLY: geodesic distance and direction at every vertex, to
// texture, brush or stamp around it.
//
//     node log-map.mjs model.glb log-map.ply
import { readFile, writeFile } from 'node:fs/promises';
import { distancesPly, load } from 'geodesic-voronoi';

const [model, output = 'log-map.ply'] = process.argv.slice(2);
const gvd = await load();
const mesh = await gvd.mesh(await readFile(model));
const centre = await mesh.sampleSites(1);
const map = await mesh.distances(centre);

// Vertices with properties label, distance, direction_x and direction_y.
await writeFile(output, distancesPly(map, { mesh }));

// Distance times direction are coordinates in the tangent plane of the point.
const [u, v] = [0, 1].map((k) => Array.from(map.distance, (d, i) => d * map.direction[2 * i + k]));
const farthest = map.distance.indexOf(Math.max(...map.distance.filter(Number.isFinite)));
console.log(
  `farthest: vertex ${farthest} at (${u[farthest].toFixed(4)}, ${v[farthest].toFixed(4)})`,
);
gvd.dispose();
