// SPDX-License-Identifier: MIT
//
// Errors as sentences.

/** What happened and, from the library, why. */
export function sentence(what: string, cause: unknown): Error {
  const why = cause instanceof Error ? cause.message : String(cause);
  return new Error(`${what}: ${why.replace(/\.$/, '')}.`, { cause });
}
