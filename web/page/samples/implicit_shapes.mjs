// SPDX-License-Identifier: MIT
//
// Surfaces where a function is zero, as {positions, indices}.

/** A quartic surface of genus 5. */
export function tangleCube() {
  const quartic = (x) => x * x * (x * x - 5);
  return isosurface(56, 2.7, (x, y, z) => quartic(x) + quartic(y) + quartic(z) + 11.2);
}

/** Three rings grown together: genus 3. */
export function tripleTorus() {
  const rings = [0, 1, 2].map((i) => {
    const angle = (2 * Math.PI * i) / 3 + Math.PI / 2;
    return [1.02 * Math.cos(angle), 1.02 * Math.sin(angle)];
  });
  return isosurface(80, 2.2, (x, y, z) =>
    rings
      .map(([cx, cy]) => Math.hypot(Math.hypot(x - cx, y - cy) - 0.72, z) - 0.33)
      .reduce((a, b) => roundedUnion(a, b, 0.28)),
  );
}

/**
 * A bearing block: a plate with four bolt holes, and on it a boss with a bore, held by two ribs.
 */
export function bearingBlock() {
  const cylinder = (radius, p, q) => Math.hypot(p, q) - radius;
  const fillet = 0.1;
  const body = (x, y, z) => {
    const plate = box([x, y + 0.62, z], [1.45, 0.16, 0.8], 0.08);
    const boss = Math.max(cylinder(0.62, x, y - 0.12), Math.abs(z) - 0.62);
    const foot = box([x, y + 0.3, z], [0.62, 0.42, 0.45], 0.05);
    const slope = 0.8 * Math.abs(x) + 0.6 * (y + 0.5) - 0.9;
    const rib = Math.max(slope, Math.abs(z) - 0.13, y - 0.3, -0.7 - y);
    return [foot, rib, plate].reduce((a, b) => roundedUnion(a, b, fillet), boss);
  };
  return isosurface(92, 1.62, (x, y, z) => {
    const bore = cylinder(0.36, x, y - 0.12);
    const bolts = cylinder(0.15, Math.abs(x) - 1.12, Math.abs(z) - 0.5);
    return [bore, bolts].reduce((a, b) => -roundedUnion(-a, b, 0.07), body(x, y, z));
  });
}

/** The signed distance of a box with rounded edges. */
function box(place, halfSizes, rounding) {
  const q = place.map((x, k) => Math.abs(x) - halfSizes[k] + rounding);
  const outside = Math.hypot(...q.map((x) => Math.max(x, 0)));
  return outside + Math.min(Math.max(...q), 0) - rounding;
}

/** The union of two bodies given by signed distances, with a fillet where they meet. */
function roundedUnion(a, b, radius) {
  const h = Math.max(radius - Math.abs(a - b), 0) / radius;
  return Math.min(a, b) - (h * h * radius) / 4;
}

/**
 * The surface on which `value` is zero, inside a cube of n³ cells: a vertex in each cell that the
 * surface crosses, and two triangles for each of the grid's edges that it crosses ("surface nets").
 * Then vertices are spread evenly and put on the surface.
 */
function isosurface(n, halfWidth, value) {
  const step = (2 * halfWidth) / n;
  const at = (index) => step * index - halfWidth;
  const size = n + 1;
  const strides = [size * size, size, 1];
  const keyOf = (i, j, k) => i * strides[0] + j * strides[1] + k;
  const inside = new Uint8Array(size ** 3);
  for (let i = 0; i < size; ++i) {
    for (let j = 0; j < size; ++j) {
      for (let k = 0; k < size; ++k)
        inside[keyOf(i, j, k)] = value(at(i), at(j), at(k)) < 0 ? 1 : 0;
    }
  }
  const positions = [];
  const vertexOfCell = new Map();
  const vertexOf = (cell) => {
    const key = keyOf(...cell);
    if (!vertexOfCell.has(key)) {
      vertexOfCell.set(key, positions.length / 3);
      positions.push(...cell.map((index) => at(index + 0.5)));
    }
    return vertexOfCell.get(key);
  };
  const indices = [];
  for (let i = 1; i < n; ++i) {
    for (let j = 1; j < n; ++j) {
      for (let k = 1; k < n; ++k) {
        for (let axis = 0; axis < 3; ++axis) {
          const tail = keyOf(i, j, k);
          if (inside[tail] === inside[tail + strides[axis]]) continue;
          // The four cells around the edge, counterclockwise as seen from its tip.
          const cells = [
            [0, 0],
            [-1, 0],
            [-1, -1],
            [0, -1],
          ].map(([u, v]) => {
            const cell = [i, j, k];
            cell[(axis + 1) % 3] += u;
            cell[(axis + 2) % 3] += v;
            return vertexOf(cell);
          });
          const [a, b, c, d] = inside[tail] ? cells : cells.reverse();
          indices.push(a, b, c, a, c, d);
        }
      }
    }
  }
  for (let round = 0; round < 4; ++round) {
    smooth(positions, indices);
    for (let v = 0; v < positions.length; v += 3) {
      // Newton's step along the gradient, and not across a cell.
      const place = positions.slice(v, v + 3);
      const slope = gradient(value, place, 1e-3 * step);
      const squared = slope.reduce((sum, x) => sum + x * x, 0);
      const factor = value(...place) / squared;
      const bound = Math.min(1, step / (Math.abs(factor) * Math.sqrt(squared)));
      if (!(squared > 0)) continue;
      for (let k = 0; k < 3; ++k) positions[v + k] -= bound * factor * slope[k];
    }
  }
  return { positions, indices };
}

/** By central differences. */
function gradient(value, place, step) {
  return place.map((_, axis) => {
    const at = (offset) => value(...place.map((x, k) => (k === axis ? x + offset : x)));
    return (at(step) - at(-step)) / (2 * step);
  });
}

/** Moves each vertex to the middle of its neighbours; the surface has no boundary. */
function smooth(positions, indices) {
  const sums = new Float64Array(positions.length);
  const counts = new Int32Array(positions.length / 3);
  indices.forEach((tail, i) => {
    const tip = indices[i % 3 === 2 ? i - 2 : i + 1];
    ++counts[tail];
    for (let k = 0; k < 3; ++k) sums[3 * tail + k] += positions[3 * tip + k];
  });
  for (let i = 0; i < positions.length; ++i) positions[i] = sums[i] / counts[Math.floor(i / 3)];
}
