// A model cut into parts for a 3D printer: each region with a thickness, as a closed shell in a
// file of its own. The thickness is in the unit of the model, and goes inwards, so that the outsides
// fit together as before.
//
//     node printable-parts.mjs model.stl 12 2 part
import { readFile, writeFile } from 'node:fs/promises';
import { load } from 'geodesic-voronoi';

const [model, count = '12', thickness = '2', output = 'part'] = process.argv.slice(2);
if (!model) throw new Error('usage: node printable-parts.mjs MODEL [COUNT] [THICKNESS] [OUTPUT]');
const gvd = await load();
const mesh = await gvd.mesh(await readFile(model));

// Regions of similar area.
const sites = await mesh.sampleSites(Number(count), { sampling: 'poisson' });
let diagram;
for await ({ diagram } of mesh.cvt(sites, { diagrams: true }));
const { points, triangles, regions } = await diagram.partition();

// The inside has a copy of every point, moved against the normal there. Regions share the points on
// their borders, and so the insides fit together, too.
const outside = points.position;
const normals = vertexNormals(outside, triangles.points);
const inside = outside.map((x, i) => x - Number(thickness) * normals[i]);
const pointCount = outside.length / 3;

for (const [label, area] of regions.area.entries()) {
  const [first, end] = regions.triangleOffset.subarray(label, label + 2);
  const corners = triangles.points.subarray(3 * first, 3 * end);
  const sides = new Set();
  for (const [a, b] of sidesOf(corners)) sides.add(a * pointCount + b);
  const shell = [...corners];
  for (let t = 0; t < corners.length; t += 3) {
    const [a, b, c] = corners.subarray(t, t + 3);
    shell.push(c + pointCount, b + pointCount, a + pointCount);
  }
  for (const [a, b] of sidesOf(corners)) {
    if (sides.has(b * pointCount + a)) continue; // another triangle of the region is beyond it
    shell.push(b, a, a + pointCount, b, a + pointCount, b + pointCount);
  }
  const { info } = await gvd.mesh({ positions: [...outside, ...inside], indices: shell });
  const isClosed = info.boundaryLoops === 0 && info.repairs.nonManifoldEdges === 0;
  console.log(`part ${label}: area ${area.toPrecision(4)}, ${isClosed ? 'closed' : 'open'}`);
  await writeFile(`${output}-${label}.obj`, obj(shell));
}
gvd.dispose();

/** The directed sides of triangles. */
function* sidesOf(corners) {
  for (let t = 0; t < corners.length; t += 3)
    for (const k of [0, 1, 2]) yield [corners[t + k], corners[t + ((k + 1) % 3)]];
}

/** Unit vectors, each the mean of the normals of the triangles around a point, by their areas. */
function vertexNormals(position, corners) {
  const normals = new Float64Array(position.length);
  for (let t = 0; t < corners.length; t += 3) {
    const [a, b, c] = Array.from(corners.subarray(t, t + 3), (p) => position.subarray(3 * p));
    const [u, v] = [b, c].map((corner) => [0, 1, 2].map((k) => corner[k] - a[k]));
    for (const p of corners.subarray(t, t + 3))
      for (const k of [0, 1, 2]) {
        const [i, j] = [(k + 1) % 3, (k + 2) % 3];
        normals[3 * p + k] += u[i] * v[j] - u[j] * v[i];
      }
  }
  for (let p = 0; p < normals.length; p += 3) {
    const length = Math.hypot(...normals.subarray(p, p + 3));
    for (const k of [0, 1, 2]) normals[p + k] /= length || 1;
  }
  return normals;
}

/** Triangles as an OBJ, with the points that they use. */
function obj(corners) {
  const numbers = new Map();
  for (const p of corners) if (!numbers.has(p)) numbers.set(p, numbers.size + 1);
  const lines = Array.from(numbers.keys(), (p) => {
    const [position, i] = p < pointCount ? [outside, p] : [inside, p - pointCount];
    return `v ${position.subarray(3 * i, 3 * i + 3).join(' ')}`;
  });
  for (let t = 0; t < corners.length; t += 3)
    lines.push(`f ${Array.from(corners.slice(t, t + 3), (p) => numbers.get(p)).join(' ')}`);
  return `${lines.join('\n')}\n`;
}
