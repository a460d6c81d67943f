// SPDX-License-Identifier: MIT
//
// The one class of errors that this library throws.

/** The kind of error, for programs. */
export type ErrorCode =
  /** The triangles cannot be made into a surface. */
  | 'invalid-mesh'
  /** The bytes are not a glTF that this library reads. */
  | 'invalid-gltf'
  /** The file is no model that this library reads, is damaged, or needs a file that is missing. */
  | 'invalid-file'
  /** There are several models among the files, and the option `file` chooses none. */
  | 'several-models'
  /** A site or another point is not on the surface. */
  | 'invalid-point'
  /** An argument is of the wrong kind, or makes no sense for this object. */
  | 'invalid-argument'
  /** The dual is not valid with as many sites as may be added (`maxAdded`), or more do not help. */
  | 'too-few-sites'
  /** The object has been disposed, or the library that it belongs to. */
  | 'disposed'
  /** There is not enough memory. The library is still usable; a diagram that was to change is disposed. */
  | 'out-of-memory'
  /** A WebAssembly module, the worker or another script of the library cannot be loaded. */
  | 'load-failed'
  /** A fault of this library, or its worker has stopped; load it again. */
  | 'internal';

/**
 * The error of this library: `code` for programs; `message` for people, one sentence without its
 * capital and full stop, as it may follow the name of a file.
 */
export class GeodesicVoronoiError extends Error {
  override readonly name = 'GeodesicVoronoiError';
  readonly code: ErrorCode;

  constructor(code: ErrorCode, message: string, options?: { cause?: unknown }) {
    super(message, options);
    this.code = code;
  }
}

export function outOfMemory(cause?: unknown): GeodesicVoronoiError {
  return new GeodesicVoronoiError('out-of-memory', 'there is not enough memory for this', {
    cause,
  });
}

export function invalidArgument(message: string): GeodesicVoronoiError {
  return new GeodesicVoronoiError('invalid-argument', message);
}

export function invalidFile(message: string, options?: { cause: unknown }): GeodesicVoronoiError {
  return new GeodesicVoronoiError('invalid-file', message, options);
}
