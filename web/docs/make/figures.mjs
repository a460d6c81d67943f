// SPDX-License-Identifier: MIT
//
// The figures of "How it works": what the library answers about small meshes, drawn. Nothing in them
// is drawn by hand, and the same library gives the same bytes.

import { load } from 'geodesic-voronoi';
import { RegionColours, toneColour } from '../../../dist/viewer/buffers/region_colours.js';
import { torus } from '../../page/samples/shapes.mjs';
import { Drawing, pairsOf, View } from './drawing.mjs';
import { envelopeFigure } from './envelope_figure.mjs';
import { baryIn, fitter, inPlane, unfoldStrip } from './unfolding.mjs';

const look = { turn: 0.6, tilt: 0.75 };
const [width, height] = [760, 340];
const left = { x: 10, y: 10, width: 360, height: 320 };
const right = { x: 390, y: 10, width: 360, height: 320 };

/** By file name, the texts of all figures. */
export async function makeFigures() {
  const gvd = await load();
  const ring = torus(28, 13);
  const mesh = await gvd.mesh(ring);
  const scene = { mesh, look };
  const figures = {
    'unfolding.svg': await unfoldingFigure(scene),
    'virtual-source.svg': await virtualSourceFigure(gvd),
    'bisector.svg': await bisectorFigure(scene),
    'envelope.svg': await envelopeFigure(scene),
    'outlines.svg': await outlinesFigure(scene),
    'detail.svg': await detailFigure(gvd),
    'dual.svg': await dualFigure(scene),
    'cvt.svg': await cvtFigure(scene),
  };
  gvd.dispose();
  return Object.fromEntries(Object.entries(figures).map(([name, drawing]) => [name, `${drawing}`]));
}

/** A shortest path on the surface, and the strip of faces that it runs through laid flat. */
async function unfoldingFigure({ mesh, look }) {
  const drawing = new Drawing(width, height, {
    title: 'A shortest path on a torus, and the same strip of triangles unfolded into the plane',
    kind: 'plain',
  });
  const view = new View(mesh, { ...look, box: left });
  const { points } = await mesh.path(
    { vertex: [nearestVertex(mesh, [-1, 0.3, 0.75])] },
    { vertex: [nearestVertex(mesh, [0.75, 0.4, 0.55])] },
  );
  const strip = pairsOf([...points.face.keys()]).map(([i, j]) => commonFace(mesh, points, i, j));
  const faces = strip.filter((face, i) => face !== strip[i - 1]);
  drawSurface(drawing, view);
  for (const f of faces) drawing.polygon(view.corners(f), 'strip');
  drawing.polyline(placesOf(view, points.position), 'path');

  const laid = unfoldStrip(mesh, faces);
  const flat = [...points.face.keys()].map((i) => {
    const cell = laid[faces.indexOf(strip[Math.min(i, strip.length - 1)])];
    return inPlane(cell, baryIn(mesh, points, i, cell.face));
  });
  const fit = fitter(
    laid.flatMap(({ corners }) => corners),
    flat,
    right,
  );
  for (const { corners } of laid) drawing.polygon(corners.map(fit), 'strip');
  drawing.polyline(flat.map(fit), 'path');
  for (const end of [flat[0], flat.at(-1)]) drawing.circle(fit(end), 5, 'site');
  const ends = placesOf(view, points.position);
  for (const end of [ends[0], ends.at(-1)]) drawing.circle(end, 5, 'site');
  return drawing;
}

/** Distances behind a corner that paths bend around. */
async function virtualSourceFigure(gvd) {
  const drawing = new Drawing(width, height, {
    title: 'Distances from a site on a plate with a hole: paths turn at its corners',
    kind: 'plain',
  });
  const plate = plateWithHole(24, 11);
  const mesh = await gvd.mesh(plate);
  const box = { x: 20, y: 20, width: width - 40, height: height - 40 };
  const view = new View(mesh, { turn: 0, tilt: 0, box });
  const site = { vertex: [nearestVertex(mesh, [0.13, 0.37, 0])] };
  drawSurface(drawing, view);
  drawIsolines(drawing, view, mesh, (await mesh.distances(site)).distance, 0.06);
  for (const target of [
    [1.9, 0.62, 0],
    [2, 0.3, 0],
    [1.4, 0.05, 0],
  ]) {
    const { points } = await mesh.path(site, { vertex: [nearestVertex(mesh, target)] });
    drawing.polyline(placesOf(view, points.position), 'path');
  }
  drawing.circle(view.place(mesh.positions, site.vertex[0]), 6, 'site');
  return drawing;
}

/** Where the distances of two sites are the same. */
async function bisectorFigure({ mesh, look }) {
  const drawing = new Drawing(width, height, {
    title: 'Distances of two sites, and the bisector where they are equal',
  });
  const targets = [
    [-0.6, 0.4, 0.9],
    [1, 0.4, 0.3],
  ];
  const sites = { vertex: targets.map((target) => nearestVertex(mesh, target)) };
  const view = new View(mesh, { ...look, box: left });
  drawSurface(drawing, view);
  const { distance } = await mesh.distances({ vertex: [sites.vertex[0]] });
  drawIsolines(drawing, view, mesh, distance, 0.12);
  drawSites(drawing, view, mesh, { vertex: [sites.vertex[0]] });

  const diagram = await mesh.voronoi(sites, { detail: 1 });
  const beside = new View(mesh, { ...look, box: right });
  drawRegions(drawing, beside, diagram);
  for (const label of [0, 1]) {
    const { distance } = await mesh.distances({ vertex: [sites.vertex[label]] });
    const pieces = piecesOf(diagram, mesh, label);
    drawIsolines(drawing, beside, mesh, distance, 0.12, { pieces, className: 'thin on' });
  }
  drawBisectors(drawing, beside, diagram);
  drawSites(drawing, beside, mesh, sites);
  diagram.dispose();
  return drawing;
}

/** A diagram traced: regions, arcs and Voronoi points. */
async function outlinesFigure({ mesh, look }) {
  const drawing = new Drawing(width, height, {
    title: 'Regions of 24 sites, their outlines and Voronoi points; one of the outlines by itself',
  });
  const diagram = await mesh.voronoi(await mesh.sampleSites(24, { seed: 5, sampling: 'poisson' }));
  const view = new View(mesh, { ...look, box: left });
  drawRegions(drawing, view, diagram);
  drawBisectors(drawing, view, diagram);
  drawVoronoiPoints(drawing, view, diagram);

  const beside = new View(mesh, { ...look, box: right });
  drawSurface(drawing, beside);
  const { position } = diagram.data.points;
  const region = mostSeen(beside, diagram);
  for (const loop of region.loops) {
    const outline = [...loop, loop[0]].map((point) => beside.place(position, point));
    drawing.segments(beside.seen(pairsOf(outline)), 'path');
    for (const point of outline) if (beside.sees(point)) drawing.circle(point, 2.2, 'point');
  }
  diagram.dispose();
  return drawing;
}

/** The same sites, bisectors straight in each face and in parts of it. */
async function detailFigure(gvd) {
  const drawing = new Drawing(width, height, {
    title:
      'A coarse torus: one straight segment per face, and faces on bisectors split three times',
  });
  const mesh = await gvd.mesh(torus(9, 5));
  const sites = await mesh.sampleSites(9, { seed: 3, sampling: 'poisson' });
  const colours = new RegionColours();
  for (const [detail, box] of [
    [0, left],
    [3, right],
  ]) {
    const view = new View(mesh, { ...look, box });
    const diagram = await mesh.voronoi(sites, { detail });
    drawRegions(drawing, view, diagram, colours);
    drawBisectors(drawing, view, diagram);
    diagram.dispose();
    drawing.segments(
      view.facesInOrder().flatMap((f) => sidesOf(view.corners(f))),
      'grid',
    );
  }
  return drawing;
}

/** Regions of a diagram with a valid dual, and that dual. */
async function dualFigure({ mesh, look }) {
  const drawing = new Drawing(width, height, {
    title: 'Regions, and their dual: a vertex per site, a polygon per Voronoi point',
  });
  const begun = await mesh.voronoi(await mesh.sampleSites(60, { seed: 2, sampling: 'poisson' }));
  const diagram = await begun.repair();
  const view = new View(mesh, { ...look, box: left });
  drawRegions(drawing, view, diagram);
  drawBisectors(drawing, view, diagram);

  drawSites(drawing, view, mesh, diagram.sites);

  const dual = await diagram.dual();
  const [points, triangles] = [dual.points.position, dual.triangles.points];
  const beside = new View({ positions: points, indices: triangles }, { ...look, box: right });
  for (const t of beside.facesInOrder()) {
    const { faces } = dual;
    const polygon = dual.triangles.face[t];
    const corners = faces.points.slice(faces.offset[polygon], faces.offset[polygon + 1]);
    const places = [...corners].map((point) => beside.place(points, point));
    drawing.polygon(places, 'base');
  }
  diagram.dispose();
  return drawing;
}

/** Random sites, and the same ones at the centroids of their regions. */
async function cvtFigure({ mesh, look }) {
  const drawing = new Drawing(width, height, {
    title: 'Regions of random sites, and of the same sites after 40 iterations',
  });
  const options = { iterations: 40, diagrams: true };
  const states = [];
  for await (const state of mesh.cvt(await mesh.sampleSites(60, { seed: 2 }), options)) {
    states.push(state);
  }
  const colours = new RegionColours();
  for (const [state, box] of [
    [states[0], left],
    [states.at(-1), right],
  ]) {
    const view = new View(mesh, { ...look, box });
    drawRegions(drawing, view, state.diagram, colours);
    drawBisectors(drawing, view, state.diagram);
    drawSites(drawing, view, mesh, state.sites);
  }
  for (const { diagram } of states) diagram.dispose();
  return drawing;
}

// --- Parts of figures -----------------------------------------------------------------------------

function drawSurface(drawing, view) {
  for (const f of view.facesInOrder()) drawing.polygon(view.corners(f), 'surface');
}

/** Region triangles and the cells of mixed faces, in the colours of the viewer. */
function drawRegions(drawing, view, { data }, colours = new RegionColours()) {
  const tones = colours.assign(data, [...Array(data.siteCount).keys()]);
  const colour = (label) => `#${toneColour(tones[label]).toString(16).padStart(6, '0')}`;
  const cellsOfFace = new Map();
  data.cells.face.forEach((f, cell) => cellsOfFace.set(f, [...(cellsOfFace.get(f) ?? []), cell]));
  for (const f of view.facesInOrder()) {
    if (data.faceLabel[f] >= 0) {
      drawing.polygon(view.corners(f), 'region', colour(data.faceLabel[f]));
      continue;
    }
    for (const cell of cellsOfFace.get(f) ?? []) {
      const { offset, points, label } = data.cells;
      const corners = [...points.slice(offset[cell], offset[cell + 1])];
      const places = corners.map((point) => view.place(data.points.position, point));
      drawing.polygon(places, 'cell', colour(label[cell]));
    }
  }
}

function drawBisectors(drawing, view, { data }) {
  const { points } = data.segments;
  const pairs = [];
  for (let i = 0; i < points.length; i += 2) {
    pairs.push([0, 1].map((end) => view.place(data.points.position, points[i + end])));
  }
  drawing.segments(view.seen(pairs), 'line');
}

function drawVoronoiPoints(drawing, view, { data }) {
  for (const point of data.voronoiPoints.point) {
    const place = view.place(data.points.position, point);
    if (view.sees(place)) drawing.circle(place, 3, 'point');
  }
}

function drawSites(drawing, view, mesh, sites) {
  const { length } = sites.vertex ?? sites.face;
  for (let i = 0; i < length; ++i) {
    const place = sites.vertex
      ? view.place(mesh.positions, sites.vertex[i])
      : view.place(positionAt(mesh, sites, i), 0);
    if (view.sees(place)) drawing.circle(place, length > 20 ? 2.5 : 5, 'site');
  }
}

function positionAt(mesh, { face, bary }, i) {
  const corners = mesh.indices.slice(3 * face[i], 3 * face[i] + 3);
  const along = (axis) =>
    corners.reduce((sum, v, k) => sum + bary[3 * i + k] * mesh.positions[3 * v + axis], 0);
  return [0, 1, 2].map(along);
}

/**
 * Where distances at vertices, linear in between, are multiples of a step: in the pieces of faces given,
 * as barycentric coordinates of their corners, or in whole faces.
 */
function drawIsolines(drawing, view, mesh, distance, step, { pieces, className } = {}) {
  const pairs = [];
  for (const { face, corners } of pieces ?? wholeFaces(view)) {
    const vertices = [...mesh.indices.slice(3 * face, 3 * face + 3)];
    const sides = view.corners(face);
    const blend = (bary, of) => bary.reduce((sum, weight, i) => sum + weight * of(i), 0);
    const at = corners.map((bary) => blend(bary, (i) => distance[vertices[i]]));
    const places = corners.map((bary) =>
      Object.fromEntries(
        ['x', 'y', 'depth'].map((axis) => [axis, blend(bary, (i) => sides[i][axis])]),
      ),
    );
    for (let k = Math.ceil(Math.min(...at) / step); k * step < Math.max(...at); ++k) {
      const crossings = at.flatMap((a, i) => {
        const next = (i + 1) % at.length;
        if (a < k * step === at[next] < k * step) return [];
        return [between(places[i], places[next], (k * step - a) / (at[next] - a))];
      });
      if (crossings.length === 2) pairs.push(crossings);
    }
  }
  drawing.segments(view.seen(pairs), className ?? 'thin');
}

const unitBary = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

function wholeFaces(view) {
  return view.facesInOrder().map((face) => ({ face, corners: unitBary }));
}

/** What a region has of each face. */
function piecesOf({ data }, mesh, label) {
  const whole = [...data.faceLabel.keys()]
    .filter((face) => data.faceLabel[face] === label)
    .map((face) => ({ face, corners: unitBary }));
  const { offset, points, face } = data.cells;
  const parts = [...face.keys()]
    .filter((cell) => data.cells.label[cell] === label)
    .map((cell) => ({
      face: face[cell],
      corners: [...points.slice(offset[cell], offset[cell + 1])].map((point) =>
        baryIn(mesh, data.points, point, face[cell]),
      ),
    }));
  return [...whole, ...parts];
}

// --- Geometry ---------------------------------------------------------------------------------------

const between = (a, b, t) =>
  Object.fromEntries(['x', 'y', 'depth'].map((axis) => [axis, a[axis] + t * (b[axis] - a[axis])]));

const sidesOf = (corners) => corners.map((corner, i) => [corner, corners[(i + 1) % 3]]);

function placesOf(view, positions) {
  return Array.from({ length: positions.length / 3 }, (_, i) => view.place(positions, i));
}

/** The region of which most of the outline is seen. */
function mostSeen(view, { data, regions }) {
  const hidden = ({ loops }) =>
    loops
      .flatMap((loop) => [...loop])
      .filter((point) => !view.sees(view.place(data.points.position, point))).length;
  return [...regions].sort((a, b) => hidden(a) - hidden(b))[0];
}

/** Vertices with a weight at a point; two points in succession of a path share a face that has them. */
function verticesAt(mesh, { face, bary }, i) {
  return [0, 1, 2].flatMap((k) => (bary[3 * i + k] > 0 ? [mesh.indices[3 * face[i] + k]] : []));
}

function commonFace(mesh, points, i, j) {
  const wanted = new Set([...verticesAt(mesh, points, i), ...verticesAt(mesh, points, j)]);
  for (let f = 0; f < mesh.indices.length / 3; ++f) {
    const corners = mesh.indices.slice(3 * f, 3 * f + 3);
    if ([...wanted].every((v) => corners.includes(v))) return f;
  }
  throw new Error(`points ${i} and ${j} of a path have no face in common`);
}

function nearestVertex({ positions }, target) {
  let best = { distance: Infinity, vertex: -1 };
  for (let v = 0; 3 * v < positions.length; ++v) {
    const distance = Math.hypot(...target.map((x, k) => x - positions[3 * v + k]));
    if (distance < best.distance) best = { distance, vertex: v };
  }
  return best.vertex;
}

/** A plate of 2 by 1, m by n squares, with a rectangular hole. */
function plateWithHole(m, n) {
  const positions = [];
  const indices = [];
  for (let j = 0; j <= n; ++j) for (let i = 0; i <= m; ++i) positions.push((2 * i) / m, j / n, 0);
  const isHole = (i, j) => i >= m / 3 && i < m / 2 && j >= 3 && j < 8;
  for (let j = 0; j < n; ++j) {
    for (let i = 0; i < m; ++i) {
      if (isHole(i, j)) continue;
      const a = j * (m + 1) + i;
      const b = a + m + 1;
      if ((i + j) % 2 === 0) indices.push(a, a + 1, b, a + 1, b + 1, b);
      else indices.push(a, a + 1, b + 1, a, b + 1, b);
    }
  }
  return { positions, indices };
}
