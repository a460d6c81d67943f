// SPDX-License-Identifier: MIT
//
// Points in a JSON file, in every form that the library writes.

import { isObject } from '../base/checks.js';
import { GeodesicVoronoiError, invalidArgument } from '../api/errors.js';
import type { MeshInfo } from '../api/results.js';
import type { SurfacePointsInput } from '../api/options.js';
import { counted, integer } from '../base/sentences.js';

/** The content of a file of points. */
export interface PointsFile {
  points: SurfacePointsInput;
  /** The number of triangles of their mesh, if the file says so. */
  faces?: number;
}

/** The content of a parsed file: a list of points or of places, or the sites of a result. */
export function pointsFile(json: unknown): PointsFile {
  if (isPlaces(json)) return { points: { position: json.flat() } };
  const points = has(json, 'sites') ? json.sites : json;
  const isList = has(points, 'face') && has(points, 'bary');
  if (typeof json === 'string') throw invalidArgument('this is a text: parse it by JSON.parse');
  if (!isList && !has(points, 'vertex') && !has(points, 'position')) {
    throw invalidArgument(
      'there are no points: {"face": […], "bary": […]}, {"vertex": […]}, {"position": [x, y, z, …]} or [[x, y, z], …]',
    );
  }
  const faces = has(json, 'mesh') && has(json.mesh, 'faces') ? json.mesh.faces : undefined;
  return {
    points: points as SurfacePointsInput,
    ...(typeof faces === 'number' && { faces }),
  };
}

/** Refuses points that belong to a mesh with another number of triangles. */
export function requireSameMesh({ faces }: PointsFile, { inputFaces }: MeshInfo): void {
  if (faces === undefined || faces === inputFaces) return;
  throw new GeodesicVoronoiError(
    'invalid-point',
    `the points belong to another mesh, of another file or made with other options: to one with ${counted(faces, 'triangle')}, not ${integer(inputFaces)}`,
  );
}

/** Whether it is a list of places as most programs write it, three numbers in a list each. */
function isPlaces(json: unknown): json is number[][] {
  const isPlace = (each: unknown) => Array.isArray(each) && each.length === 3;
  return Array.isArray(json) && json.length > 0 && json.every(isPlace);
}

function has<Key extends string>(value: unknown, key: Key): value is Record<Key, unknown> {
  return isObject(value) && key in value;
}
