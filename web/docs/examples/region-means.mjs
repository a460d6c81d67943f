// The regions of landmarks as a table: area, perimeter, and the mean of a measurement over each, such as a thickness.
// The landmarks are a table of names and places, the measurement has a number per vertex, each in a line.
//
//     node region-means.mjs bone.ply landmarks.csv thickness.txt > regions.csv
import { readFile } from 'node:fs/promises';
import { load } from 'geodesic-voronoi';

const [model, table, measurement] = process.argv.slice(2);
if (!measurement) throw new Error('usage: node region-means.mjs MODEL LANDMARKS MEASUREMENT');
const linesOf = async (file) => (await readFile(file, 'utf8')).trim().split('\n');
const landmarks = (await linesOf(table))
  .slice(1)
  .map((line) => line.match(/^(.*),([^,]*),([^,]*),([^,]*)$/).slice(1));
const values = (await linesOf(measurement)).map(Number);

const gvd = await load();
const mesh = await gvd.mesh(await readFile(model));
if (values.length !== mesh.info.inputVertices)
  throw new Error(
    `there are ${values.length} values, not one for each of ${mesh.info.inputVertices} vertices`,
  );
const sites = await mesh.closestPoints(landmarks.flatMap(([, ...place]) => place.map(Number)));
const diagram = await mesh.voronoi(sites);
const { points, triangles, regions } = await diagram.partition();

console.log('landmark,offSurface,area,perimeter,mean');
for (const [label, [name]] of landmarks.entries()) {
  const [first, end] = regions.triangleOffset.subarray(label, label + 2);
  let integral = 0;
  for (let t = first; t < end; ++t) integral += areaOf(t) * meanOf(t);
  const { area, perimeter } = regions;
  const numbers = [sites.distance[label], area[label], perimeter[label], integral / area[label]];
  console.log([name, ...numbers.map((x) => x.toPrecision(6))].join(','));
}
gvd.dispose();

function areaOf(t) {
  const corners = triangles.points.subarray(3 * t, 3 * t + 3);
  const [a, b, c] = Array.from(corners, (p) => points.position.subarray(3 * p, 3 * p + 3));
  const side = (to, k) => to[k % 3] - a[k % 3];
  const normal = [1, 2, 3].map((k) => side(b, k) * side(c, k + 1) - side(b, k + 1) * side(c, k));
  return Math.hypot(...normal) / 2;
}

/** The mean over a triangle: that of its three corners, at which the measurement is interpolated from the vertices. */
function meanOf(t) {
  const ends = mesh.indices.subarray(3 * triangles.face[t]);
  const shares = triangles.bary.subarray(9 * t, 9 * t + 9);
  return shares.reduce((sum, share, i) => sum + share * values[ends[i % 3]], 0) / 3;
}
