// SPDX-License-Identifier: MIT
//
// Shortest paths between the points that the command is given.

import type { SurfacePath, SurfacePoints } from '../api/results.js';
import { partOf } from '../base/slices.js';
import type { SurfacePointsInput } from '../api/options.js';
import type { Mesh } from '../api/types.js';
import { FileError } from './files.js';

/** A path from each start to its end; either may be one for all. */
export async function pathsBetween(
  mesh: Mesh,
  from: SurfacePoints,
  to: SurfacePoints,
  onProgress: (share: number) => void,
): Promise<SurfacePath[]> {
  const [starts, ends] = [singlePoints(from), singlePoints(to)];
  const count = Math.max(starts.length, ends.length);
  if ([starts, ends].some(({ length }) => length !== 1 && length !== count))
    throw new FileError(
      `there are ${starts.length} points to start at, but ${ends.length} to end at: give as many, or one of either`,
    );
  if (count === 1) return [await mesh.path(starts[0], ends[0], { onProgress })];
  // Many paths with one end in common have the distances from there in common.
  const isFromOne = starts.length === 1;
  const one = isFromOne ? starts[0] : ends.length === 1 ? ends[0] : undefined;
  const around = one && (await mesh.voronoi(one, partOf({ onProgress }, 0, 0.5)));
  const many = isFromOne ? ends : starts;
  const paths: SurfacePath[] = [];
  for (const [i, point] of many.entries()) {
    paths.push(await (around?.path(point) ?? mesh.path(point, ends[i])));
    const share = paths.length / count;
    onProgress(around ? (1 + share) / 2 : share);
  }
  return isFromOne ? paths.map(reversed) : paths;
}

/** The same path from its end. */
function reversed({ points: { face, bary, position }, length }: SurfacePath): SurfacePath {
  const triples = (values: Float64Array) =>
    values.map((_, i) => values[values.length - 3 - (i - (i % 3)) + (i % 3)]);
  const points = {
    face: face.slice().reverse(),
    bary: triples(bary),
    position: triples(position),
  };
  return { points, length };
}

/** Each of some points. */
function singlePoints({ face, bary }: SurfacePoints): SurfacePointsInput[] {
  return Array.from(face, (f, i) => ({ face: f, bary: bary.subarray(3 * i, 3 * i + 3) }));
}
