// SPDX-License-Identifier: MIT
//
// npm run bench [-- OPTIONS]: the benchmark, natively and in WebAssembly; --help tells the options.

import { buildPackage, buildWithCMake } from './build.mjs';
import { setUp } from './setup.mjs';
import { at, main, run } from './tasks.mjs';

await main(async () => {
  setUp('test');
  buildWithCMake('build/native', { targets: ['gvd_bench'] });
  await buildPackage();
  const executable = at('build/native/tests/bench/gvd_bench');
  const script = at('tests/bench/bench.mjs');
  run(process.execPath, [script, '--executable', executable, ...process.argv.slice(2)]);
});
