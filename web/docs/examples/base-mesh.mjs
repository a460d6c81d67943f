// A coarse polygonal base mesh of a torus: the dual of a diagram, with as many sites as that takes.
//
//     node base-mesh.mjs base.obj
import { writeFile } from 'node:fs/promises';
import { load, polygonObj } from 'geodesic-voronoi';

const [output = 'base.obj'] = process.argv.slice(2);
const gvd = await load();
const mesh = await gvd.mesh(torus(60, 30));

// With few sites, regions reach around the tube: their dual is no torus. `repair` adds what is missing.
const begun = await mesh.voronoi(await mesh.sampleSites(8, { sampling: 'farthest' }));
console.log((await begun.violations()).map(({ message }) => message).join('\n'));
const diagram = await begun.repair();
const base = await diagram.dual();
await writeFile(output, polygonObj(base));

const { vertices, faces, genus } = base.topology;
console.log(`${vertices} vertices, ${faces} polygons, genus ${genus}`);
gvd.dispose();

/** A tube around the vertical axis, in m by n squares of two triangles each. */
function torus(m, n) {
  const positions = [];
  const indices = [];
  for (let i = 0; i < m; ++i) {
    for (let j = 0; j < n; ++j) {
      const [u, v] = [(2 * Math.PI * i) / m, (2 * Math.PI * j) / n];
      const radius = 1 + 0.4 * Math.cos(v);
      positions.push(radius * Math.cos(u), 0.4 * Math.sin(v), -radius * Math.sin(u));
      const at = (k, l) => ((i + k) % m) * n + ((j + l) % n);
      indices.push(at(0, 0), at(1, 0), at(1, 1), at(0, 0), at(1, 1), at(0, 1));
    }
  }
  return { positions, indices };
}
