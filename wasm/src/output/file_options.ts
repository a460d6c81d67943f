// SPDX-License-Identifier: MIT
//
// Options of the functions that write files: how a result is written, and the mesh that some formats
// need besides.

import { isObject, toOptions, toResult, type Complete, type DefaultsOf } from '../base/checks.js';
import { positive, requireAllowed, string } from '../base/rules.js';
import { invalidArgument } from '../api/errors.js';
import type { Mesh } from '../api/types.js';

/** Options of every file. */
export interface FileOptions {
  /** What lengths are multiplied with on the way out. Default 1. */
  scale?: number | undefined;
}

/** Options of a JSON form. */
export interface JsonOptions extends FileOptions {
  /** The name of the unit that lengths have after `scale`; it is written with them. */
  unit?: string | undefined;
}

/** The mesh that a result came from, or as much of it as writers need. */
export type AttributeSource = Pick<Mesh, 'positions' | 'indices' | 'normals' | 'uvs'>;

/** Options of a file with a partition or a dual. */
export interface SurfaceFileOptions extends FileOptions {
  /** Brings the normals and texture coordinates to interpolate. */
  mesh?: AttributeSource | undefined;
}

/**
 * How a GLB holds the regions of a partition. 'regions': a node with one primitive per region, named
 * `region 0`, …, with its label in `extras.region`. 'features': one primitive, with the labels in
 * `_FEATURE_ID_0` as EXT_mesh_features has them.
 */
export type PartitionLayout = (typeof partitionLayouts)[number];
export const partitionLayouts = ['regions', 'features'] as const;

/** The options of a writer, with defaults for those left out; checks those that several have. */
export function toFileOptions<
  Options extends FileOptions,
  const Defaults extends DefaultsOf<Omit<Options, 'scale'>>,
>(
  options: Options | undefined,
  defaults: Defaults,
): Complete<Options, Defaults> & { scale: number } {
  if (isObject(options) && 'positions' in options && 'indices' in options)
    throw invalidArgument('options is a mesh: pass it as { mesh }');
  const all = toOptions<object, object>(options, { ...defaults, scale: 1 }) as {
    scale: number;
    unit?: string;
    mesh?: AttributeSource;
  };
  requireAllowed('scale', all.scale, positive);
  if (all.unit !== undefined) requireAllowed('unit', all.unit, string);
  if (all.mesh !== undefined) toAttributeSource(all.mesh);
  return all as unknown as Complete<Options, Defaults> & { scale: number };
}

/** A coordinate as a format has it whose numbers have 32 bits. */
export function toFloat32(coordinate: number, scale: number, format: 'a GLB' | 'an STL'): number {
  const rounded = Math.fround(coordinate);
  if (Number.isFinite(rounded)) return rounded;
  throw invalidArgument(
    `multiplied by ${scale}, coordinates are too large for the numbers of ${format}, of 32 bits`,
  );
}

export function toAttributeSource(mesh: AttributeSource): AttributeSource {
  return toResult('mesh', mesh, 'positions', 'indices', 'normals', 'uvs');
}
