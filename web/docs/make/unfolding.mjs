// SPDX-License-Identifier: MIT
//
// Strips of triangles laid out in the plane, one after the other over the side that they share.

const distance = (positions, a, b) =>
  Math.hypot(...[0, 1, 2].map((k) => positions[3 * a + k] - positions[3 * b + k]));

/**
 * Each face of a strip as three places in the plane. The first lies with its first side on the x axis;
 * every other beside the one before it, lengths kept.
 */
export function unfoldStrip({ positions, indices }, faces) {
  const vertices = (f) => [...indices.slice(3 * f, 3 * f + 3)];
  const laid = [];
  for (const f of faces) {
    const known = new Map();
    const before = laid.at(-1);
    if (before) {
      before.vertices.forEach((v, i) => {
        if (vertices(f).includes(v)) known.set(v, before.corners[i]);
      });
    } else {
      const [a, b] = vertices(f);
      known.set(a, { x: 0, y: 0 }).set(b, { x: distance(positions, a, b), y: 0 });
    }
    const apex = vertices(f).findIndex((v) => !known.has(v));
    const [from, to] = [vertices(f)[(apex + 1) % 3], vertices(f)[(apex + 2) % 3]];
    known.set(
      vertices(f)[apex],
      apexOf(positions, vertices(f)[apex], [from, known.get(from)], [to, known.get(to)]),
    );
    laid.push({ face: f, vertices: vertices(f), corners: vertices(f).map((v) => known.get(v)) });
  }
  return laid;
}

/** To the left of the way from one corner to the other: faces are counterclockwise. */
function apexOf(positions, apex, [from, a], [to, b]) {
  const base = Math.hypot(b.x - a.x, b.y - a.y);
  const [near, far] = [distance(positions, apex, from), distance(positions, apex, to)];
  const along = (near * near - far * far + base * base) / (2 * base);
  const height = Math.sqrt(Math.max(0, near * near - along * along));
  const [ex, ey] = [(b.x - a.x) / base, (b.y - a.y) / base];
  return { x: a.x + along * ex - height * ey, y: a.y + along * ey + height * ex };
}

/** A point of a face that was laid out, from its barycentric coordinates. */
export function inPlane({ corners }, bary) {
  return {
    x: corners.reduce((sum, corner, i) => sum + bary[i] * corner.x, 0),
    y: corners.reduce((sum, corner, i) => sum + bary[i] * corner.y, 0),
  };
}

/** The barycentric coordinates of point i of a list in terms of another face that it is on. */
export function baryIn(mesh, { face, bary }, i, other) {
  const weights = new Map([0, 1, 2].map((k) => [mesh.indices[3 * face[i] + k], bary[3 * i + k]]));
  return [0, 1, 2].map((k) => weights.get(mesh.indices[3 * other + k]) ?? 0);
}

/**
 * Puts places of the plane into a box of the page, whose y axis points down; turned so that the first
 * and the last of `along` lie level.
 */
export function fitter(places, along, box) {
  const [from, to] = [along[0], along.at(-1)];
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  const [cos, sin] = [(to.x - from.x) / length, (to.y - from.y) / length];
  const turned = ({ x, y }) => ({ x: cos * x + sin * y, y: sin * x - cos * y });
  const all = places.map(turned);
  const [xs, ys] = [all.map(({ x }) => x), all.map(({ y }) => y)];
  const [x0, x1, y0, y1] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const scale = Math.min(box.width / (x1 - x0), box.height / (y1 - y0));
  return (place) => {
    const { x, y } = turned(place);
    return {
      x: box.x + box.width / 2 + scale * (x - (x0 + x1) / 2),
      y: box.y + box.height / 2 + scale * (y - (y0 + y1) / 2),
    };
  };
}
