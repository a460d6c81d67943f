// SPDX-License-Identifier: MIT
//
// Surfaces drawn by formulas, as {positions, indices}.

const turn = 2 * Math.PI;

export function torus() {
  return grid(150, 60, { across: true, along: true }, (s, t) => {
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
    return [x, 0.13 * Math.cos(10 * r) * Math.exp(-0.8 * r * r), z];
  });
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
