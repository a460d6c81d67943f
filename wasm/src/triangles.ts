// SPDX-License-Identifier: MIT
//
// A mesh between the readers of files and the engine.

/** A triangle mesh as it is handed on: read from a file or given by the caller, not yet checked. */
export interface Triangles {
  positions: Float64Array;
  indices: Int32Array;
  /** Per vertex, or empty; the core has no use for them. */
  normals: Float64Array;
  uvs: Float64Array;
  density: Float64Array;
}
