// SPDX-License-Identifier: MIT
//
// One face in which three regions meet, flat: its cells, and along one of its sides the squared
// distances that decide.

import { Drawing, pairsOf } from './drawing.mjs';
import { baryIn, fitter, inPlane, unfoldStrip } from './unfolding.mjs';

const colours = ['#2b6a99', '#b4630a', '#3c8d40'];

export async function envelopeFigure({ mesh }) {
  const drawing = new Drawing(760, 300, {
    title: 'A face that three regions share, and squared distances along one of its sides',
    kind: 'plot',
  });
  const sites = await mesh.sampleSites(14, { seed: 8, sampling: 'poisson' });
  const { data } = await mesh.voronoi(sites);
  const face = faceOfVoronoiPoint(data);
  const cells = [...data.cells.face.keys()].filter((cell) => data.cells.face[cell] === face);
  const labels = [...new Set(cells.map((cell) => data.cells.label[cell]))].sort((a, b) => a - b);
  const squared = await squaredDistances(mesh, sites, labels);
  const shown = { mesh, data, face, cells, labels, squared };
  drawFace(drawing, shown, { x: 30, y: 30, width: 300, height: 230 });
  drawSide(drawing, shown, { x: 410, y: 30, width: 320, height: 200 });
  return drawing;
}

/** The face with three cells, around a Voronoi point well inside of it. */
function faceOfVoronoiPoint({ points, voronoiPoints, cells }) {
  const depth = (point) => Math.min(...points.bary.slice(3 * point, 3 * point + 3));
  const shares = (face) => cells.face.reduce((count, f) => count + (f === face), 0);
  const inside = [...voronoiPoints.point].filter((point) => shares(points.face[point]) === 3);
  return points.face[inside.sort((p, q) => depth(q) - depth(p))[0]];
}

/** Per label, the square of its distance at every vertex. */
async function squaredDistances(mesh, { face, bary }, labels) {
  const squared = new Map();
  for (const label of labels) {
    const site = { face: [face[label]], bary: bary.slice(3 * label, 3 * label + 3) };
    const { distance } = await mesh.distances(site);
    squared.set(
      label,
      distance.map((d) => d * d),
    );
  }
  return squared;
}

function drawFace(drawing, { mesh, data, face, cells, labels }, box) {
  const [laid] = unfoldStrip(mesh, [face]);
  const fit = fitter(laid.corners, laid.corners.slice(0, 2), box);
  for (const cell of cells) {
    const { offset, points, label } = data.cells;
    const corners = [...points.slice(offset[cell], offset[cell + 1])].map((point) =>
      fit(inPlane(laid, baryIn(mesh, data.points, point, face))),
    );
    const colour = colours[labels.indexOf(label[cell])];
    drawing.polygon(corners, 'line', `${colour}40`);
    const middle = (axis) => corners.reduce((sum, p) => sum + p[axis], 0) / corners.length;
    drawing.text(
      { x: middle('x'), y: middle('y') + 4 },
      `region ${label[cell]}`,
      'middle small on',
    );
  }
  ['i', 'j', 'k'].forEach((name, i) => {
    const { x, y } = fit(laid.corners[i]);
    const outside = y > box.y + box.height / 2 ? 18 : -8;
    drawing.text({ x, y: y + outside }, name, 'middle');
  });
}

/** Along the side with most regions: linear interpolants straight, true squared distances dotted. */
function drawSide(drawing, { mesh, face, labels, squared }, box) {
  const corners = [...mesh.indices.slice(3 * face, 3 * face + 3)];
  const side =
    [0, 1, 2].find(
      (i) =>
        nearest(squared, labels, corners[i]) !== nearest(squared, labels, corners[(i + 1) % 3]),
    ) ?? 0;
  const [a, b] = [corners[side], corners[(side + 1) % 3]];
  const values = labels.flatMap((label) => [squared.get(label)[a], squared.get(label)[b]]);
  const [least, most] = [0.9 * Math.min(...values), 1.02 * Math.max(...values)];
  const place = (t, value) => ({
    x: box.x + t * box.width,
    y: box.y + box.height * (1 - (value - least) / (most - least)),
  });
  const linear = (label, t) => (1 - t) * squared.get(label)[a] + t * squared.get(label)[b];

  drawing.polyline([place(0, most), place(0, least), place(1, least), place(1, most)], 'thin');
  const steps = Array.from({ length: 101 }, (_, i) => i / 100);
  const envelope = (t) => Math.min(...labels.map((label) => linear(label, t)));
  drawing.polyline(
    steps.map((t) => place(t, envelope(t))),
    'line',
  );
  for (const [i, label] of labels.entries()) {
    drawing.polyline([place(0, linear(label, 0)), place(1, linear(label, 1))], 'thin', colours[i]);
    const end = place(1, linear(label, 1));
    drawing.text({ x: end.x + 6, y: end.y + 4 }, `g${label}`, 'small');
  }
  for (const [s, t] of pairsOf(steps)) {
    const owner = (u) => labels.find((label) => linear(label, u) === envelope(u));
    if (owner(s) === owner(t)) continue;
    const at = crossing(owner(s), owner(t), linear);
    drawing.circle(place(at, envelope(at)), 4, 'point');
    drawing.text({ x: place(at, 0).x, y: box.y + box.height + 18 }, 't', 'middle');
  }
  const names = ['i', 'j', 'k'];
  drawing.text({ x: box.x, y: box.y + box.height + 18 }, names[side], 'middle');
  drawing.text(
    { x: box.x + box.width, y: box.y + box.height + 18 },
    names[(side + 1) % 3],
    'middle',
  );
  drawing.text(
    { x: box.x, y: box.y - 10 },
    'squared distance, linear along the side',
    'small soft',
  );
}

/** Equation 3 of Melvær & Reimers 2014: t = a / (a - b), a and b the differences of the squares. */
function crossing(one, other, linear) {
  const [a, b] = [0, 1].map((end) => linear(one, end) - linear(other, end));
  return a / (a - b);
}

const nearest = (squared, labels, vertex) =>
  labels.reduce((best, label) =>
    squared.get(label)[vertex] < squared.get(best)[vertex] ? label : best,
  );
