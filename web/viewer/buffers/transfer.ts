// SPDX-License-Identifier: MIT
//
// What a message to or from a worker hands over instead of copying it.

/** The buffers in a message, each once. */
export function buffersOf(message: unknown, found = new Set<ArrayBuffer>()): Set<ArrayBuffer> {
  if (message instanceof ArrayBuffer) found.add(message);
  else if (ArrayBuffer.isView(message)) found.add(message.buffer as ArrayBuffer);
  else if (typeof message === 'object' && message !== null)
    for (const inner of Object.values(message)) buffersOf(inner, found);
  return found;
}
