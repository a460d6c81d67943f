// A model cut into regions, as one mesh with a feature id per region (EXT_mesh_features): to be
// coloured, picked or joined with a table by whatever reads glTF.
//
//     node feature-ids.mjs model.glb 50 parts.glb
import { readFile, writeFile } from 'node:fs/promises';
import { load, partitionGlb } from 'geodesic-voronoi';

const [model, count = '50', output = 'parts.glb'] = process.argv.slice(2);
const gvd = await load();
const mesh = await gvd.mesh(await readFile(model));
const diagram = await mesh.voronoi(await mesh.sampleSites(Number(count)), { detail: 1 });
const parts = await diagram.partition();

// Normals and texture coordinates of the model are interpolated.
await writeFile(output, partitionGlb(parts, { mesh, layout: 'features' }));

parts.regions.area.forEach((area, label) => {
  const perimeter = parts.regions.perimeter[label];
  console.log(
    `region ${label}: area ${area.toPrecision(4)}, perimeter ${perimeter.toPrecision(4)}`,
  );
});
gvd.dispose();
