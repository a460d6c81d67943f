// SPDX-License-Identifier: MIT
//
// The script of the module worker that `loadWorker` starts.

import { compileFromWeb } from './compile.js';
import { LocalEngine } from './local_engine.js';
import { serve, type Port } from './worker_server.js';

serve(globalThis as unknown as Port, (sources) => LocalEngine.load(sources, compileFromWeb));
