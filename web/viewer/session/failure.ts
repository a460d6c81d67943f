// SPDX-License-Identifier: MIT
//
// Errors as sentences.

/** What failed: opening a model, computing with one that is open, or drawing. */
export type FailureType = 'loadfailure' | 'computefailure' | 'nowebgl' | 'webglcontextlost';

/** What happened and, from the library, why. */
export function sentence(what: string, cause: unknown): Error {
  const why = cause instanceof Error ? cause.message : String(cause);
  return new Error(`${what}: ${why.replace(/\.$/, '')}.`, { cause });
}

/** Whether work has failed only because nobody wants it any more: it was aborted, or its mesh is gone. */
export function isAbandoned(error: unknown, signal?: AbortSignal): boolean {
  return signal?.aborted === true || (error as { code?: unknown })?.code === 'disposed';
}

/** Why nothing can be drawn, where that is so. */
export class NoWebGlError extends Error {
  constructor(cause: unknown) {
    const sentences =
      'This view needs WebGL 2, which this browser does not offer; ' +
      'its settings may have it turned off, with graphics acceleration.';
    super(sentences, { cause });
  }
}

/** Why nothing is drawn at present. */
export const contextLost = 'The graphics card has dropped this view; it returns when it can.';
