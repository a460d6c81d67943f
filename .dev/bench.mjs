// SPDX-License-Identifier: MIT
//
// npm run bench [-- OPTIONS]: the benchmark, natively and in WebAssembly; --help tells the options.

import { bench } from '../tests/bench/bench.mjs';
import { readOptions, usage } from '../tests/bench/options.mjs';
import { buildPackage, buildWithCMake } from './build.mjs';
import { setUp } from './setup.mjs';
import { at, keepStandardOutput, main, step } from './tasks.mjs';

await main(async () => {
  const options = readOptions(process.argv.slice(2));
  if (options.help) {
    console.log(usage);
    return;
  }
  // For what was measured, which may be read by a program.
  keepStandardOutput();
  setUp('test');
  const executable = 'build/native/tests/bench/gvd_bench';
  await step(
    'Benchmark',
    { inputs: ['CMakeLists.txt', 'core', 'tests'], outputs: [executable] },
    () => buildWithCMake('build/native', { targets: ['gvd_bench'] }),
  );
  if (options.wasm) await buildPackage();
  await bench(options, at(executable));
});
