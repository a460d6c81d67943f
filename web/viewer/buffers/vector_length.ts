// SPDX-License-Identifier: MIT
//
// Lengths of vectors in the scene.

/**
 * The length of a vector whose numbers are moderate, as all in the scene are. `Math.hypot` takes several
 * times as long, because it allows for squares that are too large or too small.
 */
export function vectorLength(x: number, y: number, z: number): number {
  return Math.sqrt(x * x + y * y + z * z);
}
