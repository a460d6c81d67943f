// SPDX-License-Identifier: MIT
//
// npm run bench [-- ARGUMENTS]: the benchmark, natively built; the arguments are its own.

import { buildWithCMake } from './build.mjs';
import { setUp } from './setup.mjs';
import { at, main, run } from './tasks.mjs';

await main(() => {
  setUp('test');
  buildWithCMake('build/native', { targets: ['gvd_bench'] });
  run(at('build/native/tests/bench/gvd_bench'), process.argv.slice(2));
});
