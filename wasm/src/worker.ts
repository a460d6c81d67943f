// SPDX-License-Identifier: MIT
//
// The script of the module worker that `loadWorker` starts. It imports its code only when it runs:
// a bundler could put code that it shares with others into this script, from which they would
// import it, and WebKit runs the first script of a worker once more when a module imports it.

import type { Port } from './engine/worker_server.js';

const port = globalThis as unknown as Port & { onmessageerror: (() => void) | null };
const early: MessageEvent[] = [];
port.onmessage = (event) => early.push(event);
// The other side gets this as an error of the worker; else it would wait for an answer for ever.
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
