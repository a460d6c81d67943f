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

/** Why nothing is drawn at present. */
export const contextLost = 'The graphics card has dropped this view; it returns when it can.';
