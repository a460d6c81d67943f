// SPDX-License-Identifier: MIT
//
// In the plane exact distances leave nothing to approximate: however a convex domain is triangulated,
// the diagram is the Euclidean one, clipped, made at once or site by site. d3-delaunay knows which
// sites are neighbours there, and where the Voronoi points are. DGPC comes close.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Delaunay } from 'd3-delaunay';
import { load } from 'geodesic-voronoi';
import { near } from './expectations.mjs';
import { pointAt } from './meshes.mjs';

/** Of the domain's diagonal, and of its area. */
const tolerance = 1e-9;

const gvd = await load();

/** Numbers in [0, 1) that depend on the seed alone (mulberry32). */
function randomNumbers(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let bits = Math.imul(state ^ (state >>> 15), state | 1);
    bits ^= bits + Math.imul(bits ^ (bits >>> 7), bits | 61);
    return ((bits ^ (bits >>> 14)) >>> 0) / 2 ** 32;
  };
}

// --- Domains and their triangulations ------------------------------------------------------------

const rectangle = ([width, height]) => [
  [0, 0],
  [width, 0],
  [width, height],
  [0, height],
];

/**
 * Triangulates the rectangle [0, width] × [0, height]: its corners, `rim` more points on each side
 * and `inner` ones, denser towards the left by `crowding`. The triangles are Delaunay for the
 * points stretched in the direction `angle`: back in the rectangle they are needles across it.
 */
function triangulate(
  [width, height],
  { rim = 0, inner, crowding = 1, stretch = 1, angle = 0 },
  random,
) {
  const points = rectangle([width, height]);
  for (let i = 0; i < rim; ++i) {
    const [x, y] = [width * random(), height * random()];
    points.push([x, 0], [width, y], [width - x, height], [0, height - y]);
  }
  for (let i = 0; i < inner; ++i) points.push([width * random() ** crowding, height * random()]);
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const stretched = points.map(([x, y]) => [stretch * (cos * x + sin * y), cos * y - sin * x]);
  const triangles = [...Delaunay.from(stretched).triangles];
  checkTriangulation(points, triangles, width * height);
  return { points, triangles };
}

/** That it covers the domain once and uses all points: else it is the wrong thing to test with. */
function checkTriangulation(points, triangles, domainArea) {
  let area = 0;
  for (let i = 0; i < triangles.length; i += 3) {
    const partArea = areaOf(triangles.slice(i, i + 3).map((v) => points[v]));
    assert.ok(partArea * areaOf([0, 1, 2].map((k) => points[triangles[k]])) > 0);
    area += Math.abs(partArea);
  }
  near(area, domainArea, 1e-12 * domainArea);
  assert.equal(new Set(triangles).size, points.length);
}

/** Signed: positive if counterclockwise. */
function areaOf(polygon) {
  return polygon.reduce((sum, [x, y], i) => {
    const [nextX, nextY] = polygon[(i + 1) % polygon.length];
    return sum + (x * nextY - nextX * y) / 2;
  }, 0);
}

/** The plane somewhere in space: from the domain's coordinates to positions, and back. */
function placeInSpace(random) {
  const offset = [random(), random(), random()];
  const [a, b, c, d] = [random() - 0.5, random() - 0.5, random() - 0.5, random() - 0.5];
  const norm = a * a + b * b + c * c + d * d;
  // Two columns of the rotation of a quaternion.
  const u = [a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)];
  const v = [2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)];
  const along = (axis, p) => p.reduce((sum, x, k) => sum + ((x - offset[k]) * axis[k]) / norm, 0);
  return {
    to: ([x, y]) => offset.map((start, k) => start + (x * u[k] + y * v[k]) / norm),
    from: (p) => [along(u, p), along(v, p)],
  };
}
const leaveInPlane = { to: ([x, y]) => [x, y, 0], from: ([x, y]) => [x, y] };

// --- Sites ---------------------------------------------------------------------------------------

const inTriangle = (random) => {
  const [u, v] = [random(), random()];
  return u + v < 1 ? [1 - u - v, u, v] : [u + v - 1, 1 - u, 1 - v];
};

/** Sites for a mesh: spread evenly, many in a few faces, or where faces meet. */
const sitesOf = {
  even: async (mesh, count, random) =>
    mesh.sampleSites(count, { seed: Math.floor(2 ** 20 * random()) }),

  crowded(mesh, count, random) {
    const faceCount = mesh.indices.length / 3;
    const faces = [random(), random(), random()].map((x) => Math.floor(faceCount * x));
    const face = Array.from({ length: count }, (_, i) => faces[i % faces.length]);
    return { face, bary: face.flatMap(() => inTriangle(random)) };
  },

  /** Vertices and points of edges by turns, each vertex once. */
  special(mesh, count, random) {
    const taken = new Set();
    const face = [];
    const bary = [];
    while (face.length < count) {
      const halfedge = Math.floor(mesh.indices.length * random());
      const isVertex = face.length % 2 === 0;
      if (isVertex && taken.has(mesh.indices[halfedge])) continue;
      if (isVertex) taken.add(mesh.indices[halfedge]);
      const share = isVertex ? 1 : 0.1 + 0.8 * random();
      const corners = [0, 0, 0];
      corners[halfedge % 3] = share;
      corners[(halfedge + 1) % 3] = 1 - share;
      face.push(Math.floor(halfedge / 3));
      bary.push(...corners);
    }
    return { face, bary };
  },
};

/** Where points of a triangulation are in the domain. */
function positionsOf({ points, triangles }, { face, bary }) {
  return Array.from(face, (f, i) =>
    [0, 1].map((axis) =>
      [0, 1, 2].reduce((sum, c) => sum + bary[3 * i + c] * points[triangles[3 * f + c]][axis], 0),
    ),
  );
}

// --- The diagram to expect -----------------------------------------------------------------------

/** d3-delaunay takes triangles for degenerate by their absolute size. A power of two rounds nothing. */
const scale = 2 ** 20;

/** The Euclidean diagram: areas of cells, and Voronoi points, in the domain or not, by their sites. */
function euclideanDiagram(sites, domain) {
  const delaunay = Delaunay.from(sites.map(([x, y]) => [scale * x, scale * y]));
  const areas = sites.map((site, i) => {
    const neighbours = sites.length > 1 ? [...delaunay.neighbors(i)] : [];
    return areaOf(
      neighbours.reduce((cell, j) => nearerTo(site, sites[j], cell), rectangle(domain)),
    );
  });
  const { circumcenters } = delaunay.voronoi();
  const voronoiPoints = new Map();
  for (let t = 0; 2 * t < circumcenters.length && sites.length > 2; ++t) {
    const key = keyOf(delaunay.triangles.subarray(3 * t, 3 * t + 3));
    voronoiPoints.set(key, [circumcenters[2 * t] / scale, circumcenters[2 * t + 1] / scale]);
  }
  return { areas, voronoiPoints };
}

/**
 * The part of a convex polygon that is nearer to `site` than to `other`. The cells of d3-delaunay
 * itself have sides that start at the circumcentres of its triangles, and these may be far away.
 */
function nearerTo([siteX, siteY], [otherX, otherY], polygon) {
  const [dx, dy] = [otherX - siteX, otherY - siteY];
  const excess = ([x, y]) => (x - siteX) * dx + (y - siteY) * dy - (dx * dx + dy * dy) / 2;
  return polygon.flatMap((p, i) => {
    const q = polygon[(i + 1) % polygon.length];
    const [atP, atQ] = [excess(p), excess(q)];
    const kept = atP <= 0 ? [p] : [];
    if (atP <= 0 === atQ <= 0) return kept;
    const share = atP / (atP - atQ);
    return [...kept, [p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])]];
  });
}

const keyOf = (labels) => [...labels].sort((a, b) => a - b).join();

/** How far inside the domain a point is; below 0 outside. */
const depth = ([x, y], [width, height]) => Math.min(x, y, width - x, height - y);

// --- Comparisons ---------------------------------------------------------------------------------

const distance = ([x, y], [otherX, otherY]) => Math.hypot(x - otherX, y - otherY);

function checkAreas(regionArea, areas, domainArea) {
  assert.equal(regionArea.length, areas.length);
  regionArea.forEach((area, label) =>
    near(area, areas[label], tolerance * domainArea, `area of region ${label}:`),
  );
}

/** One to one: a Voronoi point is known by the sites around it. */
function checkVoronoiPoints({ points, voronoiPoints }, expected, place, domain) {
  const allowed = tolerance * Math.hypot(...domain);
  const missing = new Map(expected);
  voronoiPoints.point.forEach((point, i) => {
    const [start, end] = voronoiPoints.labelOffset.subarray(i, i + 2);
    const key = keyOf(voronoiPoints.labels.subarray(start, end));
    const at = place.from([...points.position.subarray(3 * point, 3 * point + 3)]);
    assert.ok(missing.has(key), `of sites ${key}: ${at} is one too many`);
    const error = distance(at, missing.get(key));
    assert.ok(error <= allowed, `of sites ${key}: ${at} is not ${missing.get(key)}, by ${error}`);
    missing.delete(key);
  });
  for (const [key, at] of missing) {
    assert.ok(depth(at, domain) < allowed, `of sites ${key}: ${at} is missing`);
  }
}

async function checkDistances(triangulation, diagram, sites, domain, random) {
  const face = Array.from({ length: 100 }, () =>
    Math.floor((random() * triangulation.triangles.length) / 3),
  );
  const query = { face, bary: face.flatMap(() => inTriangle(random)) };
  const located = await diagram.locate(query);
  const allowed = tolerance * Math.hypot(...domain);
  positionsOf(triangulation, query).forEach((p, i) => {
    const least = Math.min(...sites.map((site) => distance(site, p)));
    near(located.distance[i], least, allowed, `distance at ${p}:`);
    near(distance(sites[located.label[i]], p), least, allowed, `site nearest to ${p}:`);
  });
}

// --- Cases ---------------------------------------------------------------------------------------

const domains = { square: [1, 1], wide: [3, 1], strip: [1, 25] };

const triangulations = {
  'two triangles': { inner: 0 },
  'a few triangles': { inner: 5 },
  Delaunay: { rim: 10, inner: 200 },
  graded: { rim: 5, inner: 200, crowding: 2 },
  'needles upright': { rim: 10, inner: 200, stretch: 20 },
  'needles flat': { rim: 10, inner: 200, stretch: 1 / 20 },
  'needles oblique': { inner: 200, stretch: 20, angle: 0.6 },
};

const siteCounts = [1, 2, 3, 10, 50, 200, 500];

/** Every triangulation with every number of sites; the rest takes turns. */
const cases = Object.keys(triangulations).flatMap((triangulation, i) =>
  siteCounts.map((siteCount, j) => ({
    triangulation,
    siteCount,
    domain: Object.keys(domains)[(i + j) % 3],
    // Two triangles have not many vertices and edges.
    sites: triangulations[triangulation].inner > 5 ? Object.keys(sitesOf)[j % 3] : 'even',
    turned: (i + j) % 2 === 1,
    detail: (i + 2 * j) % 5 === 0 ? 2 : 0,
    seed: 1000 + 10 * i + j,
  })),
);

/** The diagram of these sites, made at once or of most of them with the rest put in afterwards. */
async function diagramOf(mesh, given, isLive, options) {
  const { face, bary } = given;
  if (!isLive) return mesh.voronoi({ face, bary }, options);
  const first = Math.max(Math.ceil(face.length / 2), face.length - 10);
  const diagram = await mesh.voronoi(
    { face: face.slice(0, first), bary: bary.slice(0, 3 * first) },
    options,
  );
  for (let i = first; i < face.length; ++i) await diagram.insertSite(pointAt(given, i));
  return diagram;
}

/** Of random points, how many DGPC gives to a farther site, and the mean error of its distances. */
async function measureApproximation(plane, diagram, sites, random) {
  const count = 1000;
  const face = Array.from({ length: count }, () =>
    Math.floor((random() * plane.triangles.length) / 3),
  );
  const query = { face, bary: face.flatMap(() => inTriangle(random)) };
  const located = await diagram.locate(query);
  let mislabelled = 0;
  let error = 0;
  let mean = 0;
  positionsOf(plane, query).forEach((p, i) => {
    const least = Math.min(...sites.map((site) => distance(site, p)));
    mislabelled += distance(sites[located.label[i]], p) > least * (1 + tolerance) ? 1 / count : 0;
    error += Math.abs(located.distance[i] - least) / count;
    mean += least / count;
  });
  return { mislabelled, error: error / mean };
}

/** How close DGPC comes in each case. */
const measured = [];

for (const { triangulation, siteCount, domain: name, sites: kind, turned, detail, seed } of cases) {
  const space = turned ? ', turned in space' : '';
  const split = detail > 0 ? `, detail ${detail}` : '';
  const title = `${name} in ${triangulation}, ${siteCount} ${kind} sites${space}${split}`;
  test(`the diagram is Euclidean: ${title}`, { timeout: 60_000 }, async (t) => {
    const random = randomNumbers(seed);
    const domain = domains[name];
    const plane = triangulate(domain, triangulations[triangulation], random);
    const place = turned ? placeInSpace(random) : leaveInPlane;
    const mesh = await gvd.mesh({
      positions: plane.points.flatMap(place.to),
      indices: plane.triangles,
    });
    const given = await sitesOf[kind](mesh, siteCount, random);
    const sites = positionsOf(plane, given);
    const expected = euclideanDiagram(sites, domain);
    for (const isLive of [false, true]) {
      await t.test(`exact${isLive ? ', live' : ''}`, async () => {
        const diagram = await diagramOf(mesh, given, isLive, { detail, signal: t.signal });
        checkAreas(diagram.data.regionArea, expected.areas, domain[0] * domain[1]);
        checkVoronoiPoints(diagram.data, expected.voronoiPoints, place, domain);
        await checkDistances(plane, diagram, sites, domain, random);
      });
    }
    const approximate = await mesh.voronoi(given, { metric: 'dgpc', signal: t.signal });
    const accuracy = await measureApproximation(plane, approximate, sites, random);
    measured.push({ title, triangulation, ...accuracy });
  });
}

// Published DGPC carries one distance per vertex and label: in the plane too, what lies behind a vertex
// that another site owns, or beyond a needle, follows from less than all there is to know.
test('DGPC approximates that: triangles of common shape', () => {
  const common = measured.filter(({ triangulation }) => !triangulation.includes('needles'));
  assert.equal(common.length, 4 * siteCounts.length);
  for (const { title, mislabelled, error } of common) {
    assert.ok(mislabelled <= 0.015, `${title}: ${mislabelled} mislabelled`);
    assert.ok(error <= 0.025, `${title}: mean error ${error}`);
  }
  const mean = common.reduce((sum, { mislabelled }) => sum + mislabelled, 0) / common.length;
  assert.ok(mean <= 0.0025, `${mean} mislabelled on average`);
});
