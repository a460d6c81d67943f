// SPDX-License-Identifier: MIT
//
// The benchmark: runs gvd_bench, then the same through WebAssembly, and shows both.

import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { selfContained, writeModels } from './models.mjs';
import { UsageError } from './options.mjs';
import { report, summaries } from './report.mjs';
import { writeTessellations, writeTruthCases } from './truth_cases.mjs';

/** Measures what `options` (of `readOptions`) ask for, natively by `executable`, and writes it. */
export async function bench(options, executable) {
  const folder = mkdtempSync(join(tmpdir(), 'geodesic-voronoi-'));
  try {
    write(await measure(options, executable, folder), options);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

async function measure(options, executable, folder) {
  const [meshes, models, truth] = ['meshes', 'models', 'truth'].map((name) => join(folder, name));
  for (const path of [meshes, models, truth]) mkdirSync(path);
  const args = [...options.native, '--meshes', meshes];
  for (const path of options.mesh) args.push('--mesh', selfContained(path, models));
  if (options.mesh.length === 0) {
    args.push('--generated');
    for (const path of writeModels(models)) args.push('--mesh', path);
  }
  if (options.truth) {
    const only = options.only ?? '';
    for (const path of writeTruthCases(options.truth, truth, only)) args.push('--case', path);
    for (const path of writeTessellations(options.truth, truth, only))
      args.push('--tessellation', path);
  }
  const measured = runNative(executable, args);
  if (isEmpty(measured)) throw new UsageError('nothing to measure: see --part, --only and --help');
  if (measured.cases.length > 0) measured.caseSummaries = summaries(measured.cases);
  if (options.wasm) {
    // What it imports may have been built just now.
    const { measureWasm } = await import('./wasm.mjs');
    await measureWasm(measured, meshes);
  }
  return measured;
}

function runNative(executable, args) {
  const { status, error, stdout } = spawnSync(executable, args, {
    stdio: ['ignore', 'pipe', 'inherit'],
    maxBuffer: 2 ** 28,
  });
  if (error) throw error;
  // It has said itself what was wrong.
  if (status === 2) throw new UsageError('');
  if (status !== 0) throw new Error(`gvd_bench ended with status ${status}`);
  return JSON.parse(stdout);
}

const isEmpty = (measured) =>
  Object.values(measured)
    .filter(Array.isArray)
    .every((list) => list.length === 0);

function write(measured, { json, output }) {
  const text = json ? JSON.stringify(measured, null, 2) : report(measured);
  if (output) writeFileSync(output, `${text}\n`);
  else console.log(text);
}
