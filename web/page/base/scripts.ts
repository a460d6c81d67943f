// SPDX-License-Identifier: MIT
//
// Scripts that the page fetches when they are needed.

/** Waits for the import of a script; a failure is told of in a sentence. */
export async function fetched<Script>(script: Promise<Script>): Promise<Script> {
  try {
    return await script;
  } catch (cause) {
    const message = 'A part of this page cannot be fetched: try again when the server answers.';
    throw new Error(message, { cause });
  }
}
