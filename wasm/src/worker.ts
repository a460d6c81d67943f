// SPDX-License-Identifier: MIT
//
// The script of the module worker that `loadWorker` starts. It imports nothing before it runs:
// bundlers let chunks import from a script what they share with it, and WebKit runs the first
// script of a worker once more when a module imports it.

import type { Port } from './engine/worker_server.js';

const port = globalThis as unknown as Port & { onmessageerror: (() => void) | null };
const early: MessageEvent[] = [];
port.onmessage = (event) => early.push(event);
// The other side hears of it as of any error of a worker; it would wait for an answer for ever.
port.onmessageerror = () => {
  throw new Error('a message cannot be received');
};

// Node has no `reportError`: the name is read only if it is needed.
import('./engine/worker_server.js').then(
  ({ serveLocalEngine }) => {
    serveLocalEngine(port);
    for (const event of early) port.onmessage?.(event);
  },
  (error) => reportError(error),
);
