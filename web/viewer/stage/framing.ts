// SPDX-License-Identifier: MIT
//
// Where a camera stands for points to fill its view.

import { Vector3 } from 'three';

/** Unit vectors: to the right, upwards, and from what is looked at back to the camera. */
interface ViewAxes {
  right: Vector3;
  up: Vector3;
  back: Vector3;
}

/** The camera looks at `target`, which is on the plane through the origin, from this distance. */
export interface Framing {
  target: Vector3;
  distance: number;
}

/**
 * The place from which points (x, y, z triples) just fill a view, with as much room on its left as on
 * its right, and above as below. `h` and `v` are the tangents of the angles from the middle of the
 * view to its sides, and to its top. Points that are not finite are ignored.
 *
 * From a at the distance d, a point at x, z (to the right and back) is seen within the sides if
 * x + hz ≤ a + hd and -x + hz ≤ -a + hd. With R and L the greatest left-hand sides of all points,
 * there is such an a if R + L ≤ 2hd, and a = (R - L) / 2 is in the middle. So it is with y, v and b.
 */
export function framingOf(points: Float32Array, axes: ViewAxes, h: number, v: number): Framing {
  let sides = greatestSides(points, axes, h, v);
  const distance = Math.max(sides.x.sum / (2 * h), sides.y.sum / (2 * v));
  if (!(distance > 0)) return { target: new Vector3(), distance: 3 };
  // Only one of the two directions is full: in the other, angles that just suffice give the middle.
  for (let pass = 0; pass < 2; ++pass)
    sides = greatestSides(points, axes, sides.x.sum / (2 * distance), sides.y.sum / (2 * distance));
  const target = axes.right.clone().multiplyScalar(sides.x.difference / 2);
  return { target: target.addScaledVector(axes.up, sides.y.difference / 2), distance };
}

/** The sums R + L and the differences R - L, to the sides (x) and upwards (y). */
function greatestSides(points: Float32Array, { right, up, back }: ViewAxes, h: number, v: number) {
  // The exploded view is framed anew in every frame: nothing is made or called per point.
  const [ax, ay, az] = right;
  const [bx, by, bz] = up;
  const [cx, cy, cz] = back;
  let [mostRight, mostLeft, mostUp, mostDown] = [-Infinity, -Infinity, -Infinity, -Infinity];
  for (let i = 0; i < points.length; i += 3) {
    const [px, py, pz] = [points[i], points[i + 1], points[i + 2]];
    const x = ax * px + ay * py + az * pz;
    const y = bx * px + by * py + bz * pz;
    const z = cx * px + cy * py + cz * pz;
    if (!(Math.abs(x + y + z) < Infinity)) continue;
    if (h * z + x > mostRight) mostRight = h * z + x;
    if (h * z - x > mostLeft) mostLeft = h * z - x;
    if (v * z + y > mostUp) mostUp = v * z + y;
    if (v * z - y > mostDown) mostDown = v * z - y;
  }
  return {
    x: { sum: mostRight + mostLeft, difference: mostRight - mostLeft },
    y: { sum: mostUp + mostDown, difference: mostUp - mostDown },
  };
}
