// SPDX-License-Identifier: MIT
//
// Normals for shading, with creases.

import { adjacencyOf } from './places.js';
import { vectorLength } from './vector_length.js';

/** Faces that meet at a sharper angle than this are shaded as an edge, others as one smooth surface. */
const creaseCosine = Math.cos((40 * Math.PI) / 180);

/**
 * A shading normal for every corner of every triangle: nine numbers per triangle. The normals of the
 * faces around a place are averaged by their angle there, leaving out those beyond a crease.
 */
export function cornerNormals(positions: Float32Array, indices: Int32Array): Float32Array {
  const faceNormals = normalsOfFaces(positions, indices);
  const angles = cornerAngles(positions, indices);
  const { place, offset, corners } = adjacencyOf({ positions, indices });

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
    const length = vectorLength(x, y, z);
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
    const length = vectorLength(x, y, z);
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
