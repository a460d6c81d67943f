// SPDX-License-Identifier: MIT
//
// Normals for shading, with creases.

/** Faces that meet at a sharper angle than this are shaded as an edge, others as one smooth surface. */
const creaseCosine = Math.cos((40 * Math.PI) / 180);

/**
 * A shading normal for every corner of every triangle: nine numbers per triangle. The normals of the
 * faces around a place are averaged by their angle there, leaving out those beyond a crease.
 */
export function cornerNormals(positions: Float32Array, indices: Int32Array): Float32Array {
  const faceNormals = normalsOfFaces(positions, indices);
  const angles = cornerAngles(positions, indices);
  const place = weld(positions);
  const { offset, corners } = cornersByPlace(indices, place);

  const normals = new Float32Array(3 * indices.length);
  for (let corner = 0; corner < indices.length; ++corner) {
    const own = 3 * Math.floor(corner / 3);
    const ownX = faceNormals[own];
    const ownY = faceNormals[own + 1];
    const ownZ = faceNormals[own + 2];
    const p = place[indices[corner]];
    let x = 0;
    let y = 0;
    let z = 0;
    for (let i = offset[p]; i < offset[p + 1]; ++i) {
      const other = 3 * Math.floor(corners[i] / 3);
      const otherX = faceNormals[other];
      const otherY = faceNormals[other + 1];
      const otherZ = faceNormals[other + 2];
      if (other !== own && ownX * otherX + ownY * otherY + ownZ * otherZ < creaseCosine) continue;
      const weight = angles[corners[i]];
      x += weight * otherX;
      y += weight * otherY;
      z += weight * otherZ;
    }
    const length = Math.hypot(x, y, z);
    normals[3 * corner] = length > 0 ? x / length : ownX;
    normals[3 * corner + 1] = length > 0 ? y / length : ownY;
    normals[3 * corner + 2] = length > 0 ? z / length : ownZ;
  }
  return normals;
}

/** Unit normals; zero for a face without area. */
function normalsOfFaces(positions: Float32Array, indices: Int32Array): Float32Array {
  const normals = new Float32Array(indices.length);
  for (let i = 0; i < indices.length; i += 3) {
    const a = 3 * indices[i];
    const b = 3 * indices[i + 1];
    const c = 3 * indices[i + 2];
    const ux = positions[b] - positions[a];
    const uy = positions[b + 1] - positions[a + 1];
    const uz = positions[b + 2] - positions[a + 2];
    const vx = positions[c] - positions[a];
    const vy = positions[c + 1] - positions[a + 1];
    const vz = positions[c + 2] - positions[a + 2];
    const x = uy * vz - uz * vy;
    const y = uz * vx - ux * vz;
    const z = ux * vy - uy * vx;
    const length = Math.hypot(x, y, z);
    if (!(length > 0)) continue;
    normals[i] = x / length;
    normals[i + 1] = y / length;
    normals[i + 2] = z / length;
  }
  return normals;
}

function cornerAngles(positions: Float32Array, indices: Int32Array): Float32Array {
  const angles = new Float32Array(indices.length);
  for (let face = 0; face < indices.length; face += 3) {
    for (let k = 0; k < 3; ++k) {
      const at = 3 * indices[face + k];
      const next = 3 * indices[face + ((k + 1) % 3)];
      const previous = 3 * indices[face + ((k + 2) % 3)];
      let dot = 0;
      let nextSquared = 0;
      let previousSquared = 0;
      for (let axis = 0; axis < 3; ++axis) {
        const u = positions[next + axis] - positions[at + axis];
        const v = positions[previous + axis] - positions[at + axis];
        dot += u * v;
        nextSquared += u * u;
        previousSquared += v * v;
      }
      const cosine = dot / Math.sqrt(nextSquared * previousSquared);
      angles[face + k] = Math.acos(Math.min(1, Math.max(-1, cosine))) || 0;
    }
  }
  return angles;
}

/** For every vertex the first vertex at the very same position. */
function weld(positions: Float32Array): Int32Array {
  const count = positions.length / 3;
  // Adding zero turns -0 into +0, which is the same place.
  const bits = new Uint32Array(positions.map((x) => x + 0).buffer);
  let capacity = 16;
  while (capacity < 2 * count) capacity *= 2;
  const table = new Int32Array(capacity).fill(-1);
  const place = new Int32Array(count);
  for (let v = 0; v < count; ++v) {
    const x = bits[3 * v];
    const y = bits[3 * v + 1];
    const z = bits[3 * v + 2];
    let hash = Math.imul(x, 0x9e3779b1) ^ Math.imul(y, 0x85ebca6b) ^ Math.imul(z, 0xc2b2ae35);
    hash ^= hash >>> 15;
    let slot = hash & (capacity - 1);
    let other = table[slot];
    while (
      other >= 0 &&
      (bits[3 * other] !== x || bits[3 * other + 1] !== y || bits[3 * other + 2] !== z)
    ) {
      slot = (slot + 1) & (capacity - 1);
      other = table[slot];
    }
    if (other < 0) table[slot] = v;
    place[v] = other < 0 ? v : other;
  }
  return place;
}

/** The corners at place p are `corners[offset[p]] … corners[offset[p + 1] - 1]`. */
function cornersByPlace(indices: Int32Array, place: Int32Array) {
  const offset = new Int32Array(place.length + 1);
  for (const v of indices) ++offset[place[v] + 1];
  for (let p = 0; p < place.length; ++p) offset[p + 1] += offset[p];
  const end = offset.slice();
  const corners = new Int32Array(indices.length);
  for (let corner = 0; corner < indices.length; ++corner) {
    corners[end[place[indices[corner]]]++] = corner;
  }
  return { offset, corners };
}
