// SPDX-License-Identifier: MIT
//
// The outline of the brush that paints density.

import { Vector3 } from 'three';
import type { SurfaceHit } from '../model/picking.js';
import type { SceneMesh } from '../buffers/scene_mesh.js';

const sides = 48;

/**
 * Both ends of the sides of a ring on the surface, about as far from its centre as a brush reaches.
 */
export function brushRing(
  mesh: SceneMesh,
  { face, bary, place }: SurfaceHit,
  radius: number,
  nearest: (place: Vector3) => Vector3,
): Float32Array {
  const normal = new Float32Array(3);
  mesh.writeNormal(face, bary, normal, 0);
  const up = new Vector3().fromArray(normal).normalize();
  const across = new Vector3(up.y, up.z, up.x).cross(up).normalize();
  // All three components are equal.
  if (across.lengthSq() === 0) across.set(1, -1, 0).normalize();
  const along = up.clone().cross(across);
  const corners = Array.from({ length: sides }, (_, i) => {
    const angle = (2 * Math.PI * i) / sides;
    const offset = across.clone().multiplyScalar(Math.cos(angle));
    return nearest(
      offset.addScaledVector(along, Math.sin(angle)).multiplyScalar(radius).add(place),
    );
  });
  const ends = new Float32Array(6 * sides);
  corners.forEach((corner, i) => {
    corner.toArray(ends, 6 * i);
    corners[(i + 1) % sides].toArray(ends, 6 * i + 3);
  });
  return ends;
}
