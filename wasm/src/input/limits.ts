// SPDX-License-Identifier: MIT
//
// Limits on the size of a model, so that a small file cannot take all memory or hours.

import { type GeodesicVoronoiError, invalidFile } from '../api/errors.js';
import type { GltfLimits } from '../api/options.js';
import { counted } from '../base/sentences.js';

/** The limits of the glTF reader that apply to every format. */
export type SizeLimits = Required<Pick<GltfLimits, 'maxVertices' | 'maxTriangles'>>;

/** The most corners of one polygon: the time that cutting takes may grow with their square. */
const maxCorners = 2 ** 14;

/** The default limits: those of the glTF reader. */
export function toSizeLimits({
  maxVertices = 2 ** 24,
  maxTriangles = 2 ** 24,
}: GltfLimits): SizeLimits {
  return { maxVertices, maxTriangles };
}

export function requireVertices(count: number, { maxVertices }: SizeLimits): void {
  if (count > maxVertices) throw tooMany(counted(maxVertices, 'vertex', 'vertices'), 'maxVertices');
}

export function requireTriangles(count: number, { maxTriangles }: SizeLimits): void {
  if (count > maxTriangles) throw tooMany(counted(maxTriangles, 'triangle'), 'maxTriangles');
}

export function requireCorners(count: number): void {
  if (count <= maxCorners) return;
  throw invalidFile(
    `it has a polygon with more than ${counted(maxCorners, 'corner')}, the most that are read`,
  );
}

function tooMany(what: string, limit: string): GeodesicVoronoiError {
  return invalidFile(`it has more than ${what}; raise the limit ${limit} to read it`);
}
