// SPDX-License-Identifier: MIT
//
// Surfaces drawn by formulas, as {positions, indices}.

const turn = 2 * Math.PI;

export function torus(around = 150, across = 60) {
  return grid(around, across, { across: true, along: true }, (s, t) => {
    const radius = 1 + 0.42 * Math.cos(turn * t);
    return [radius * Math.cos(turn * s), 0.42 * Math.sin(turn * t), -radius * Math.sin(turn * s)];
  });
}

/** A tube around a trefoil knot. */
export function knot() {
  const centre = (s) => {
    const angle = turn * s;
    return [
      Math.sin(angle) + 2 * Math.sin(2 * angle),
      Math.cos(angle) - 2 * Math.cos(2 * angle),
      -1.4 * Math.sin(3 * angle),
    ];
  };
  return grid(360, 30, { across: true, along: true }, (s, t) => {
    const ahead = normalised(difference(centre(s + 1e-4), centre(s - 1e-4)));
    // Away from the knot's axis, made perpendicular to the tube: turns once with the knot, without twist.
    const outward = normalised(cross(ahead, [0, 0, 1]));
    const upward = cross(outward, ahead);
    return centre(s).map(
      (c, k) => c + 0.6 * (outward[k] * Math.cos(turn * t) + upward[k] * Math.sin(turn * t)),
    );
  });
}

/** One side, one edge: the mesh builder has to cut it to orient it. */
export function moebiusStrip() {
  return grid(220, 28, { across: 'mirrored', along: false }, (s, t) => {
    const width = 0.9 * (t - 0.5);
    const radius = 1 + width * Math.cos((turn * s) / 2);
    return [
      radius * Math.cos(turn * s),
      width * Math.sin((turn * s) / 2),
      -radius * Math.sin(turn * s),
    ];
  });
}

/** A square sheet with waves: distances differ from those on the map below it. */
export function ripples() {
  return grid(110, 110, { across: false, along: false }, (s, t) => {
    const x = 2 * s - 1;
    const z = 1 - 2 * t;
    const r = Math.hypot(x, z);
    const y = 0.13 * Math.cos(10 * r) * Math.exp(-0.8 * r * r);
    // Tilted towards whoever looks at it.
    const [sine, cosine] = [Math.sin(0.5), Math.cos(0.5)];
    return [x, cosine * y - sine * z, sine * y + cosine * z];
  });
}

/** A quartic surface of genus 5. */
export function tangleCube() {
  const quartic = (x) => x * x * (x * x - 5);
  const slope = (x) => x * (4 * x * x - 10);
  return isosurface(46, 2.7, {
    value: (x, y, z) => quartic(x) + quartic(y) + quartic(z) + 11.2,
    gradient: (x, y, z) => [slope(x), slope(y), slope(z)],
  });
}

/**
 * Where `value` is zero inside the cube of that half width, cut into n³ cells: a vertex in each cell
 * that the surface crosses, and two triangles for each of the grid's edges that it crosses ("surface
 * nets"). Then vertices are spread evenly and put on the surface.
 */
function isosurface(n, halfWidth, { value, gradient }) {
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
      // Newton's step along the gradient.
      const place = positions.slice(v, v + 3);
      const slope = gradient(...place);
      const factor = value(...place) / slope.reduce((sum, x) => sum + x * x, 0);
      for (let k = 0; k < 3; ++k) positions[v + k] -= factor * slope[k];
    }
  }
  return { positions, indices };
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

/**
 * A surface over the unit square in m × n cells of two triangles. `across` and `along` say whether
 * the first and second parameter close to a ring, 'mirrored' with the second parameter reversed.
 */
function grid(m, n, { across, along }, place) {
  const rows = across ? m : m + 1;
  const columns = along ? n : n + 1;
  const positions = [];
  for (let i = 0; i < rows; ++i) {
    for (let j = 0; j < columns; ++j) positions.push(...place(i / m, j / n));
  }
  const vertex = (i, j) => {
    const mirror = across === 'mirrored' && i === m;
    return (i % rows) * columns + (mirror ? n - j : j % columns);
  };
  const indices = [];
  for (let i = 0; i < m; ++i) {
    for (let j = 0; j < n; ++j) {
      const [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
      // Diagonals in turn: no direction of the surface is favoured.
      if ((i + j) % 2 === 0) indices.push(a, b, c, a, c, d);
      else indices.push(a, b, d, b, c, d);
    }
  }
  return { positions, indices };
}

function difference(a, b) {
  return a.map((x, k) => x - b[k]);
}

function cross([ax, ay, az], [bx, by, bz]) {
  return [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
}

function normalised(a) {
  const length = Math.hypot(...a);
  return a.map((x) => x / length);
}
