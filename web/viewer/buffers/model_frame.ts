// SPDX-License-Identifier: MIT
//
// From a model's coordinates to those of the scene.

/**
 * Where a model stands in the scene: its bounding box is centred on the origin and its farthest
 * vertex is at distance 1. So camera, depth buffer and 32-bit positions work for models in
 * micrometres and in map coordinates alike.
 */
export class ModelFrame {
  /** The centre of the bounding box, in the model's coordinates. */
  readonly centre: readonly number[];
  /** Lengths in the scene per length in the model. */
  readonly scale: number;

  constructor(centre: readonly number[], scale: number) {
    this.centre = centre;
    this.scale = scale;
  }

  /** The frame of the vertices that triangles with finite corners use. */
  static around(positions: ArrayLike<number>, indices: ArrayLike<number>): ModelFrame {
    const least = [Infinity, Infinity, Infinity];
    const most = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < indices.length; ++i) {
      for (let k = 0; k < 3; ++k) {
        const x = positions[3 * indices[i] + k];
        if (!Number.isFinite(x)) continue;
        if (x < least[k]) least[k] = x;
        if (x > most[k]) most[k] = x;
      }
    }
    const centre = least.map((x, k) => (x <= most[k] ? (x + most[k]) / 2 : 0));
    let radius = 0;
    for (let i = 0; i < indices.length; ++i) {
      const v = 3 * indices[i];
      const r = Math.hypot(
        positions[v] - centre[0],
        positions[v + 1] - centre[1],
        positions[v + 2] - centre[2],
      );
      if (r > radius && r < Infinity) radius = r;
    }
    return new ModelFrame(centre, radius > 0 ? 1 / radius : 1);
  }

  /**
   * Converts x, y, z triples to the scene: all of them, or those with these numbers. Subtracts
   * before rounding: far origins do no harm.
   */
  toScene(positions: ArrayLike<number>, numbers?: ArrayLike<number>): Float32Array {
    const [x, y, z] = this.centre;
    const { scale } = this;
    const count = numbers ? numbers.length : positions.length / 3;
    const scene = new Float32Array(3 * count);
    for (let i = 0; i < count; ++i) {
      const from = 3 * (numbers ? numbers[i] : i);
      scene[3 * i] = (positions[from] - x) * scale;
      scene[3 * i + 1] = (positions[from + 1] - y) * scale;
      scene[3 * i + 2] = (positions[from + 2] - z) * scale;
    }
    return scene;
  }
}
