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
  /** Per triangle the one that it is part of, if triangles have been subdivided. */
  parents?: Int32Array;
  /** The triangles before that. */
  whole?: Int32Array;
  /** Per vertex that came with that, these being the last: the two that it is the midpoint of. */
  ends?: Int32Array;
}

/** A model of a format without normals, texture coordinates and parts; its density is optional. */
export interface ReadModel extends Pick<Triangles, 'positions' | 'indices'> {
  density?: Float64Array;
  /** Sentences on things that were passed over or changed. */
  notes: string[];
}
