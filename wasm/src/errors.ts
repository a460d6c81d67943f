// SPDX-License-Identifier: MIT
import type { ErrorCode } from './types.js';

/**
 * What this library throws: `code` for programs; `message` for people, one sentence without its
 * capital and full stop, as it may follow the name of a file.
 */
export class GeodesicVoronoiError extends Error {
  override readonly name = 'GeodesicVoronoiError';
  readonly code: ErrorCode;

  constructor(code: ErrorCode, message: string, options?: ErrorOptions) {
    super(message, options);
    this.code = code;
  }
}

export function outOfMemory(cause?: unknown): GeodesicVoronoiError {
  return new GeodesicVoronoiError('out-of-memory', 'there is not enough memory for this', {
    cause,
  });
}
