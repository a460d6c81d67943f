// SPDX-License-Identifier: MIT
//
// Meshes between the readers of files and the engine.

/** A triangle mesh as it is handed on: read from a file or given by the caller, not yet checked. */
export interface Triangles {
  positions: Float64Array;
  indices: Int32Array;
  /** Per vertex, or empty; the core has no use for them. */
  normals: Float64Array;
  uvs: Float64Array;
  density: Float64Array;
  /** After a subdivision: per triangle the one that it is part of. */
  parents?: Int32Array;
  /** The `indices` before the subdivision. */
  whole?: Int32Array;
  /** The ends of the edges whose midpoints are the last vertices: two vertices per midpoint. */
  ends?: Int32Array;
}

/** A model of a format without normals, texture coordinates and parts; its density is optional. */
export interface ReadModel extends Pick<Triangles, 'positions' | 'indices'> {
  density?: Float64Array;
  /** Sentences on things that were passed over or changed. */
  notes: string[];
}
