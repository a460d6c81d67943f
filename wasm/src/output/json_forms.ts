// SPDX-License-Identifier: MIT
//
// What the JSON forms of several results have in common: points, and the unit of lengths.

import { isObject, toResult } from '../base/checks.js';
import { invalidArgument } from '../api/errors.js';
import type { PlacedPoints, SurfacePoints } from '../api/results.js';

/** The JSON form of a list of points. */
export interface SurfacePointsJson {
  face: number[];
  bary: number[];
}

/** The JSON form of a list of points with where they are. */
export type PlacedPointsJson = SurfacePointsJson & { position: number[] };

/** What lengths in a JSON form are in. */
export interface LengthsJson {
  /** The factor from the input's lengths to those of the file, and their unit there, if known. */
  scale: number;
  unit?: string;
}

export function lengthsJson({ scale, unit }: LengthsJson): LengthsJson {
  return { scale, ...(unit !== undefined && { unit }) };
}

export function pointsJson(points: SurfacePoints): SurfacePointsJson {
  if (isObject(points) && 'sites' in points)
    throw invalidArgument('points is a result: pass its sites');
  const { face, bary } = toResult('points', points, 'face', 'bary');
  return { face: [...face], bary: [...bary] };
}

export function placedPointsJson(points: PlacedPoints, scale: number): PlacedPointsJson {
  return { ...pointsJson(points), position: Array.from(points.position, (x) => scale * x) };
}
