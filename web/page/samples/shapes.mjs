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

/** A tube around a trefoil knot, which lies on a torus. */
export function knot() {
  const centre = (s) => {
    const [around, across] = [2 * turn * s, 3 * turn * s];
    const radius = 2 + Math.cos(across);
    return [radius * Math.cos(around), radius * Math.sin(around), 1.15 * Math.sin(across)];
  };
  const thickness = 0.52;
  return grid(420, 34, { across: true, along: true }, (s, t) => {
    const ahead = normalised(difference(centre(s + 1e-4), centre(s - 1e-4)));
    // The direction away from the middle of the torus' tube turns with the knot, and closes.
    const [x, y] = centre(s);
    const ring = 2 / Math.hypot(x, y);
    const outward = difference(centre(s), [ring * x, ring * y, 0]);
    const along = outward.reduce((sum, o, k) => sum + o * ahead[k], 0);
    const first = normalised(outward.map((o, k) => o - along * ahead[k]));
    const second = cross(ahead, first);
    const angle = turn * t;
    return centre(s).map(
      (c, k) => c + thickness * (first[k] * Math.cos(angle) + second[k] * Math.sin(angle)),
    );
  });
}

/**
 * A Möbius strip of some thickness: what looks like two sides is one, which closes after two
 * rounds. (A strip without thickness has no orientation; it would have to be cut.)
 */
export function moebiusStrip() {
  const [halfWidth, halfThickness] = [0.46, 0.05];
  return grid(300, 56, { across: 'half-turned', along: true }, (s, t) => {
    const angle = turn * t;
    // A superellipse: flat sides and round edges.
    const power = (x) => Math.sign(x) * Math.abs(x) ** 0.55;
    const across = halfWidth * power(Math.cos(angle));
    const up = halfThickness * power(Math.sin(angle));
    const twist = (turn * s) / 2;
    const outward = across * Math.cos(twist) - up * Math.sin(twist);
    const height = across * Math.sin(twist) + up * Math.cos(twist);
    const radius = 1 + outward;
    return [radius * Math.cos(turn * s), height, -radius * Math.sin(turn * s)];
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

/**
 * A surface over the unit square in m × n cells of two triangles. `across` and `along` say whether
 * the first and second parameter close to a ring, 'half-turned' with the second one half a turn on.
 */
function grid(m, n, { across, along }, place) {
  const rows = across ? m : m + 1;
  const columns = along ? n : n + 1;
  const positions = [];
  for (let i = 0; i < rows; ++i) {
    for (let j = 0; j < columns; ++j) positions.push(...place(i / m, j / n));
  }
  const vertex = (i, j) => {
    const shift = across === 'half-turned' && i === m ? n / 2 : 0;
    return (i % rows) * columns + ((j + shift) % columns);
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
