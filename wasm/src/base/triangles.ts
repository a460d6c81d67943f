// SPDX-License-Identifier: MIT
//
// Meshes between the readers of files and the engine.

/** Triangles that were subdivided into smaller ones, their children. */
export interface Subdivision {
  /** The triangles before, and the number of their vertices. */
  whole: Int32Array;
  vertexCount: number;
  /** The children. Their vertices are those before, then the midpoints. */
  indices: Int32Array<ArrayBuffer>;
  /** Per child, ascending: the triangle that it is part of. */
  parents: Int32Array<ArrayBuffer>;
  /** Per midpoint, the two vertices that it lies between. */
  ends: Int32Array<ArrayBuffer>;
}

/** A triangle mesh as it is handed on: read from a file or given by the caller, not yet checked. */
export interface Triangles {
  positions: Float64Array;
  indices: Int32Array;
  /** Per vertex, or empty; the core has no use for them. */
  normals: Float64Array;
  uvs: Float64Array;
  density: Float64Array;
  subdivision?: Subdivision;
}

/** A model of a format without normals, texture coordinates and parts; its density is optional. */
export interface ReadModel extends Pick<Triangles, 'positions' | 'indices'> {
  density?: Float64Array;
  /** Sentences on things that were passed over or changed. */
  notes: string[];
}
