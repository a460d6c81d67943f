// SPDX-License-Identifier: MIT
import type { ErrorCode } from './types.js';

/** What this library throws: `code` for programs, `message`, one sentence, for people. */
export class GeodesicVoronoiError extends Error {
  override readonly name = 'GeodesicVoronoiError';
  readonly code: ErrorCode;

  constructor(code: ErrorCode, message: string, options?: ErrorOptions) {
    super(message, options);
    this.code = code;
  }
}
