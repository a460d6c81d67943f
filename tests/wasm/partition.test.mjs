// SPDX-License-Identifier: MIT
//
// Partitions: that they arrive whole and in terms of the input, and that others can read the files.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  distancesGlb,
  load,
  partitionGlb,
  partitionJson,
  partitionObj,
  partitionPly,
  partitionStl,
  polygonGlb,
  polygonPly,
  polygonStl,
} from 'geodesic-voronoi';
import {
  areaOf,
  assertValidGlb,
  jsonOf,
  placedTriangles,
  readObj,
  readPly,
  surfaceOf,
  threeMeshes,
  total,
  trianglesOf,
} from './files.mjs';
import { near } from './expectations.mjs';
import { apart, grid, octahedron, placeOf, triples, withFlipped } from './meshes.mjs';

const gvd = await load();

/** A grid with normals that lean and with texture coordinates, of which one row has a seam. */
function dressed() {
  const { positions, indices } = grid(6);
  const normals = [];
  const uvs = [];
  for (let i = 0; i < positions.length; i += 3) {
    const x = positions[i] - 0.5;
    const length = Math.hypot(x, 1);
    normals.push(x / length, 0, 1 / length);
    uvs.push(positions[i], positions[i + 1]);
  }
  // The upper half of the square has vertices of its own along the middle, with other coordinates.
  const copies = new Map();
  const split = indices.map((vertex, corner) => {
    const triangle = indices.slice(3 * Math.floor(corner / 3), 3 * Math.floor(corner / 3) + 3);
    const isUpper = triangle.some((v) => positions[3 * v + 1] > 0.51);
    if (!isUpper || Math.abs(positions[3 * vertex + 1] - 0.5) > 0.01) return vertex;
    if (!copies.has(vertex)) {
      copies.set(vertex, positions.length / 3);
      positions.push(...positions.slice(3 * vertex, 3 * vertex + 3));
      normals.push(...normals.slice(3 * vertex, 3 * vertex + 3));
      uvs.push(uvs[2 * vertex], 7);
    }
    return copies.get(vertex);
  });
  return { positions, indices: split, normals, uvs };
}

/** Every kind of input: closed, bounded, in parts, with a part out of reach, turned over, dressed. */
const inputs = {
  octahedron: [octahedron(), 5],
  grid: [grid(8), 12],
  'more sites than triangles': [grid(1), 9],
  'one site': [octahedron(), 1],
  'two components': [apart(octahedron(), grid(4)), 7],
  'a triangle turned over': [withFlipped(octahedron(), 3), 4],
  'normals and texture coordinates': [dressed(), 6],
};

const cases = async function* () {
  for (const [name, [input, count]] of Object.entries(inputs)) {
    const mesh = await gvd.mesh(input);
    const diagram = await mesh.voronoi(await mesh.sampleSites(count, { seed: 2 }));
    yield { name, mesh, diagram, partition: await diagram.partition() };
  }
  const mesh = await gvd.mesh(apart(octahedron(), grid(3)));
  const diagram = await mesh.voronoi({ vertex: [0, 3] });
  yield { name: 'out of reach', mesh, diagram, partition: await diagram.partition() };
};

const labelCount = ({ triangles }) => new Set(triangles.label).size;

test('the parts are the surface', async () => {
  for await (const { name, mesh, diagram, partition } of cases()) {
    const { triangles, points, regions } = partition;
    const surface = surfaceOf(triples(triangles.points));
    assert.ok(surface.isOriented, name);
    assert.equal(surface.euler, mesh.info.eulerCharacteristic, name);
    assert.equal(surface.loops, mesh.info.boundaryLoops, name);
    near(total(placedTriangles(partition).map(areaOf)), mesh.info.area, 1e-12);
    regions.area.forEach((area, i) => near(area, diagram.regions[i].area, 1e-9));
    assert.deepEqual(
      [...triangles.label].sort((a, b) => (a < 0) - (b < 0) || a - b),
      [...triangles.label],
    );
    regions.triangleOffset.subarray(1).forEach((end, i) => {
      for (let t = regions.triangleOffset[i]; t < end; ++t) assert.equal(triangles.label[t], i);
    });
    // Every corner is where its triangle's coordinates say.
    triangles.points.forEach((point, c) => {
      const face = triangles.face[Math.floor(c / 3)];
      const place = placeOf(mesh, face, triangles.bary.subarray(3 * c));
      place.forEach((x, axis) => near(x, points.position[3 * point + axis], 1e-9));
    });
  }
});

test('regions have their neighbours, outlines and centroids', async () => {
  for await (const { name, mesh, diagram, partition } of cases()) {
    const { neighbours, perimeter, boundaryLength, nearCentroid, loops } = partition.regions;
    diagram.regions.forEach((region, i) => {
      const [from, to] = [neighbours.offset[i], neighbours.offset[i + 1]];
      assert.deepEqual([...neighbours.label.subarray(from, to)], region.neighbours, name);
      const lengths = neighbours.length.subarray(from, to);
      near(total([...lengths]) + boundaryLength[i], perimeter[i], 1e-12);
      assert.equal(loops[i], region.loops.length, name);
    });
    const { label } = await diagram.locate(nearCentroid);
    assert.deepEqual([...label], [...label.keys()], name);
    assert.equal(mesh.info.genus, 0);
  }
});

test('a site without a region has none of it', async () => {
  const mesh = await gvd.mesh(octahedron());
  const diagram = await mesh.voronoi({ vertex: [0, 3, 3] });
  const { regions } = await diagram.partition();
  assert.equal(regions.area[2], 0);
  assert.equal(regions.triangleOffset[3], regions.triangleOffset[2]);
  assert.ok(Number.isNaN(regions.centroid[6]));
  assert.equal(regions.nearCentroid.face[2], -1);
  const json = partitionJson(await diagram.partition(), { sites: diagram.sites });
  assert.equal(json.regions[2].centroid, null);
});

test('what is out of reach can be left out', async () => {
  const mesh = await gvd.mesh(apart(octahedron(), grid(3)));
  const diagram = await mesh.voronoi({ vertex: [0, 3] });
  const partition = await diagram.partition({ leaveOutUnreachable: true });
  assert.ok(partition.triangles.label.every((label) => label >= 0));
  near(total(placedTriangles(partition).map(areaOf)), mesh.info.area - 1, 1e-12);
});

test('what several labels tie on can be left out', async () => {
  // A square, slit from the left to its middle. Two sites above the slit are equally far from its
  // end, around which alone they come to what is below.
  const { positions, indices } = grid(4);
  const slit = indices.map((vertex, corner) => {
    const triangle = indices.slice(3 * Math.floor(corner / 3), 3 * Math.floor(corner / 3) + 3);
    const isBelow = triangle.some((v) => positions[3 * v + 1] < 0.5);
    return isBelow && (vertex === 10 || vertex === 11) ? vertex + 15 : vertex;
  });
  const mesh = await gvd.mesh({
    positions: [...positions, 0, 0.49, 0, 0.25, 0.49, 0],
    indices: slit,
  });
  assert.equal(mesh.info.boundaryLoops, 1);
  const diagram = await mesh.voronoi({ vertex: [15, 21] }, { metric: 'exact' });
  const whole = await diagram.partition();
  const holed = await diagram.partition({ leaveOutIndifferent: true });
  const left = new Set(diagram.data.indifferentFaces);
  assert.equal(holed.triangles.label.length, whole.triangles.label.length - left.size);
  assert.ok(left.size > 0);
  assert.ok(holed.triangles.face.every((face) => !left.has(face)));
  await assertValidGlb(partitionGlb(holed));
});

test('GLB: a primitive per region', async () => {
  for await (const { name, mesh, diagram, partition } of cases()) {
    const bytes = partitionGlb(partition, { mesh });
    await assertValidGlb(bytes);
    const meshes = await threeMeshes(bytes);
    assert.equal(meshes.length, labelCount(partition), name);
    let triangleCount = 0;
    for (const { name: title, userData, geometry } of meshes) {
      const { region } = userData;
      const triangles = trianglesOf(geometry);
      triangleCount += triangles.length;
      if (region < 0) continue;
      // three takes spaces out of names.
      assert.equal(title, `region_${region}`);
      near(total(triangles.map(areaOf)), diagram.regions[region].area, 1e-5);
    }
    assert.equal(triangleCount, partition.triangles.label.length, name);

    const again = await gvd.mesh(bytes);
    assert.equal(again.info.inputFaces, triangleCount, name);
    assert.deepEqual(
      again.parts.map((part) => part.name),
      [...new Set(partition.triangles.label)].map((i) => (i < 0 ? 'unreachable' : `region ${i}`)),
    );
    again.parts.forEach((part) =>
      assert.equal(
        part.triangleCount,
        partition.triangles.label.filter(
          (label) => part.name === (label < 0 ? 'unreachable' : `region ${label}`),
        ).length,
      ),
    );
    near(again.info.area, mesh.info.area, 1e-6);
    assert.equal(again.info.eulerCharacteristic, mesh.info.eulerCharacteristic, name);
    assert.equal(again.info.boundaryLoops, mesh.info.boundaryLoops, name);
  }
});

test('GLB: one mesh with feature ids', async () => {
  for await (const { name, mesh, diagram, partition } of cases()) {
    const bytes = partitionGlb(partition, { mesh, layout: 'features', scale: 10 });
    await assertValidGlb(bytes);
    const meshes = await threeMeshes(bytes);
    assert.equal(meshes.length, 1, name);
    const [{ geometry }] = meshes;
    const ids = geometry.attributes._feature_id_0;
    const areas = new Float64Array(diagram.regions.length + 1);
    trianglesOf(geometry).forEach((corners, t) => {
      const [id, ...others] = [0, 1, 2].map((i) => ids.getX(geometry.index.getX(3 * t + i)));
      assert.deepEqual(others, [id, id]);
      areas[id] += areaOf(corners);
    });
    diagram.regions.forEach(({ area }, i) => near(areas[i] / 100, area, 1e-5));
    const json = jsonOf(bytes);
    const [{ featureCount, attribute, nullFeatureId }] =
      json.meshes[0].primitives[0].extensions.EXT_mesh_features.featureIds;
    const isPartUnreached = partition.triangles.label.at(-1) < 0;
    assert.equal(attribute, 0);
    assert.equal(featureCount, labelCount(partition) - Number(isPartUnreached));
    assert.equal(nullFeatureId, isPartUnreached ? diagram.regions.length : undefined);
    const again = await gvd.mesh(bytes);
    assert.equal(again.info.inputFaces, partition.triangles.label.length, name);
    near(again.info.area / 100, mesh.info.area, 1e-5);
  }
});

test('GLB: the colours of regions are those of materials, or of vertices', async () => {
  const mesh = await gvd.mesh(octahedron());
  const partition = await (await mesh.voronoi({ vertex: [0, 1, 3] })).partition();
  const colours = [[1, 0, 0.5], undefined, [0, 0.25, 1]];
  const [first, other, last] = await threeMeshes(partitionGlb(partition, { colours }));
  assert.deepEqual(first.material.color.toArray(), colours[0]);
  assert.deepEqual(last.material.color.toArray(), colours[2]);
  assert.equal(
    new Set([first, other, last].map(({ material }) => material.color.getHex())).size,
    3,
  );
  const bytes = partitionGlb(partition, { colours, layout: 'features' });
  const [{ geometry }] = await threeMeshes(bytes);
  const { color, _feature_id_0: ids } = geometry.attributes;
  for (let v = 0; v < ids.count; ++v) {
    const expected = colours[ids.getX(v)];
    if (!expected) continue;
    for (const k of [0, 1, 2]) near(color.getComponent(v, k), expected[k], 1 / 255);
  }
});

test('OBJ: a group per region, closed where the input is', async () => {
  for await (const { name, mesh, diagram, partition } of cases()) {
    const { v, vt, vn, faces } = readObj(partitionObj(partition, { mesh, scale: 2 }));
    assert.equal(v.length, partition.points.face.length, name);
    assert.equal(vt.length > 0, mesh.uvs.length > 0);
    assert.equal(vn.length > 0, mesh.normals.length > 0);
    const surface = surfaceOf(faces.map(({ corners }) => corners.map(([point]) => point)));
    assert.equal(surface.euler, mesh.info.eulerCharacteristic, name);
    const areas = new Map();
    for (const { group, corners } of faces) {
      const area = areaOf(corners.map(([point]) => v[point]));
      areas.set(group, (areas.get(group) ?? 0) + area);
    }
    diagram.regions.forEach(({ area }, i) => near(areas.get(`region_${i}`), 4 * area, 1e-12));
  }
});

test('PLY: a label per face', async () => {
  for await (const { name, mesh, diagram, partition } of cases()) {
    const { vertex, face } = readPly(partitionPly(partition, { mesh }));
    assert.deepEqual(
      face.map(({ label }) => label),
      [...partition.triangles.label],
      name,
    );
    if (mesh.uvs.length === 0) assert.equal(vertex.length, partition.points.face.length, name);
    const areas = new Float64Array(diagram.regions.length);
    const place = (i) => [vertex[i].x, vertex[i].y, vertex[i].z];
    for (const { label, vertex_indices: corners } of face)
      if (label >= 0) areas[label] += areaOf(corners.map(place));
    diagram.regions.forEach(({ area }, i) => near(areas[i], area, 1e-12));
  }
});

test('STL: the triangles of one region or of all, and of polygons', async () => {
  for await (const { name, mesh, diagram, partition } of cases()) {
    const read = (stl) => gvd.mesh(stl);
    const all = await read(partitionStl(partition, { scale: 2 }));
    assert.equal(all.info.inputFaces, partition.triangles.label.length, name);
    near(all.info.area / 4, mesh.info.area, 1e-5);
    for (const [region, { area }] of diagram.regions.entries()) {
      const stl = partitionStl(partition, { region });
      if (area > 0) near((await read(stl)).info.area, area, 1e-5);
      else assert.equal(stl.length, 84);
    }
    const dual = await diagram.dual();
    const stl = polygonStl(dual);
    assert.equal(new DataView(stl.buffer).getUint32(80, true), dual.triangles.face.length);
  }
  const { value } = await cases().next();
  const view = new DataView(partitionStl(value.partition).buffer);
  const [normal, first, ...others] = [0, 1, 2, 3].map((i) =>
    [0, 1, 2].map((k) => view.getFloat32(84 + 12 * i + 4 * k, true)),
  );
  near(Math.hypot(...normal), 1, 1e-6);
  for (const corner of others) {
    const along = corner.reduce((sum, x, k) => sum + normal[k] * (x - first[k]), 0);
    near(along, 0, 1e-6);
  }
});

test('PLY: the colours of regions, as bytes of sRGB', async () => {
  for await (const { mesh, partition } of cases()) {
    const colours = [[1, 0.215861, 0]];
    const { face } = readPly(partitionPly(partition, { mesh, colours }));
    const rgb = face.map(({ red, green, blue }) => [red, green, blue].join());
    const { label } = partition.triangles;
    label.forEach((each, t) => each === 0 && assert.equal(rgb[t], '255,128,0'));
    const seen = new Map(Array.from(label, (each, t) => [each, rgb[t]]));
    label.forEach((each, t) => assert.equal(rgb[t], seen.get(each)));
    assert.equal(new Set(seen.values()).size, seen.size, 'another one for each region');
  }
});

test('normals and texture coordinates are interpolated, across no seam', async () => {
  const mesh = await gvd.mesh(dressed());
  const diagram = await mesh.voronoi(await mesh.sampleSites(6, { seed: 2 }));
  const { vertex, face } = readPly(partitionPly(await diagram.partition(), { mesh }));
  const places = new Set(vertex.map(({ x, y }) => `${x} ${y}`));
  assert.ok(places.size < vertex.length, 'the seam has vertices on both sides');
  for (const { vertex_indices: corners } of face) {
    const isUpper = corners.some((i) => vertex[i].y > 0.5 + 1e-9);
    for (const i of corners) {
      const { x, y, nx, ny, nz, s, t } = vertex[i];
      near(Math.hypot(nx, ny, nz), 1, 1e-6);
      near(nx / nz, x - 0.5, 0.02);
      near(s, x, 1e-6);
      // PLY counts from the bottom, glTF from the top.
      if (!isUpper) near(1 - t, y, 1e-6);
      else if (Math.abs(y - 0.5) < 1e-12) near(1 - t, 7, 1e-6);
    }
  }
});

test('a glTF brings its normals and texture coordinates', async () => {
  const mesh = await gvd.mesh(dressed());
  const diagram = await mesh.voronoi({ vertex: [0, 20] });
  const again = await gvd.mesh(partitionGlb(await diagram.partition(), { mesh }));
  assert.equal(again.normals.length, again.positions.length);
  assert.equal(again.uvs.length, (again.positions.length / 3) * 2);
  for (let i = 0; i < again.positions.length / 3; ++i)
    near(again.uvs[2 * i], again.positions[3 * i], 1e-6);
  const plain = await gvd.mesh(grid(2));
  assert.equal(plain.normals.length + plain.uvs.length, 0);
});

test('where there is no normal, that of the triangle takes its place', async () => {
  const { positions, indices } = grid(3);
  const upright = positions.map((_, i) => [positions[i], 0, -positions[i - 1]][i % 3]);
  const normals = positions.map(() => 0);
  const mesh = await gvd.mesh({ positions: upright, indices, normals });
  const diagram = await mesh.voronoi({ vertex: [0, 15] });
  const { vertex } = readPly(partitionPly(await diagram.partition(), { mesh }));
  for (const { ny } of vertex) assert.equal(ny, 1);
});

test('normals and texture coordinates that are not finite do not get into files', async () => {
  const shape = grid(3);
  const count = shape.positions.length / 3;
  const normals = Array.from({ length: 3 * count }, (_, i) =>
    i < 12 ? NaN : i < 24 ? Infinity : 1,
  );
  const uvs = Array.from({ length: 2 * count }, (_, i) => [NaN, 0.5, -Infinity, 1e300][i % 4]);
  const mesh = await gvd.mesh({ ...shape, normals, uvs });
  const diagram = await mesh.voronoi({ vertex: [0, count - 1] });
  const [partition, dual] = [await diagram.partition(), await diagram.dual({ primal: true })];
  const { vertex } = readPly(partitionPly(partition, { mesh }));
  for (const each of [vertex, readPly(polygonPly(dual, { mesh })).vertex])
    for (const { nx, ny, nz, s, t } of each) {
      near(Math.hypot(nx, ny, nz), 1, 1e-6);
      assert.ok(Number.isFinite(s) && Number.isFinite(t), `${s} ${t}`);
    }
  const places = new Set(vertex.map(({ x, y, z }) => `${x} ${y} ${z}`));
  assert.equal(vertex.length, places.size, 'there is no seam');
  const distances = await mesh.distances({ vertex: [0] });
  await assertValidGlb(partitionGlb(partition, { mesh }));
  await assertValidGlb(polygonGlb(dual, { mesh }));
  await assertValidGlb(distancesGlb(distances, { mesh }));
});

test('attributes have to fit the mesh', async () => {
  const { positions, indices } = grid(1);
  for (const more of [{ normals: [0, 0, 1] }, { uvs: [1] }])
    await assert.rejects(gvd.mesh({ positions, indices, ...more }), {
      code: 'invalid-argument',
      message: /has \d numbers?, not \d+/,
    });
});

test('JSON holds facts and triangles', async () => {
  const mesh = await gvd.mesh(grid(5));
  const diagram = await mesh.voronoi(await mesh.sampleSites(4));
  const partition = await diagram.partition();
  const json = JSON.parse(
    JSON.stringify(partitionJson(partition, { sites: diagram.sites, scale: 2 })),
  );
  json.regions.forEach((region, i) => {
    near(region.area, 4 * diagram.regions[i].area, 1e-12);
    near(region.perimeter, 2 * partition.regions.perimeter[i], 1e-12);
    assert.deepEqual(
      region.neighbours.map(({ label }) => label),
      diagram.regions[i].neighbours,
    );
    assert.equal(region.triangleCount, json.triangles.label.filter((label) => label === i).length);
  });
  assert.deepEqual(json.sites.face, [...diagram.sites.face]);
});

test('places that no triangle names are not in a file', async () => {
  const mesh = await gvd.mesh(grid(6));
  const vertex = Int32Array.from({ length: 7 * 7 }, (_, v) => v);
  const partition = await (await mesh.voronoi({ vertex })).partition();
  const { points } = partition;
  const position = new Float64Array(points.position.length + 3000);
  position.set(points.position);
  const face = new Int32Array(position.length / 3);
  for (const layout of ['regions', 'features'])
    assert.deepEqual(
      partitionGlb({ ...partition, points: { ...points, face, position } }, { layout }),
      partitionGlb(partition, { layout }),
    );
});
