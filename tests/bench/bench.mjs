// SPDX-License-Identifier: MIT
//
// npm run bench [-- OPTIONS]: runs gvd_bench, then the same through WebAssembly, and shows both.

import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { writeModels } from './models.mjs';
import { report, summaries } from './report.mjs';
import { writeTessellations, writeTruthCases } from './truth_cases.mjs';
import { measureWasm } from './wasm.mjs';

const usage = `Usage: npm run bench [-- OPTIONS]
  --sites N, --seed N   sites per mesh (300), and what they depend on (1)
  --runs N              the fastest counts (5)
  --detail N            of the diagrams (0)
  --part NAME           only speed, accuracy, convergence or cvt
  --only TEXT           only meshes with this in their name
  --truth FOLDER        compares with the exact answers there: truth_cases.mjs says how they look
  --native              leaves WebAssembly out
  --json                writes one JSON document, times in seconds
  -o, --output FILE     writes there`;

/** Those that gvd_bench takes too. */
const shared = ['sites', 'seed', 'runs', 'detail', 'part', 'only'];

const { values } = parseArgs({
  options: {
    ...Object.fromEntries(shared.map((name) => [name, { type: 'string' }])),
    executable: { type: 'string' },
    truth: { type: 'string' },
    native: { type: 'boolean' },
    json: { type: 'boolean' },
    output: { type: 'string', short: 'o' },
    help: { type: 'boolean' },
  },
});

if (values.help) {
  console.log(usage);
} else {
  const folder = mkdtempSync(join(tmpdir(), 'geodesic-voronoi-'));
  try {
    write(await measure(folder));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

async function measure(folder) {
  const [meshes, models, truth] = ['meshes', 'models', 'truth'].map((name) => join(folder, name));
  for (const path of [meshes, models, truth]) mkdirSync(path);
  const options = ['--meshes', meshes];
  for (const name of shared) if (values[name]) options.push(`--${name}`, values[name]);
  for (const path of writeModels(models)) options.push('--model', path);
  const cases = values.truth ? writeTruthCases(values.truth, truth) : [];
  for (const path of cases) options.push('--case', path);
  const tessellations = values.truth ? writeTessellations(values.truth, truth) : [];
  for (const path of tessellations) options.push('--tessellation', path);
  const measured = runNative(options);
  if (measured.cases.length > 0) measured.caseSummaries = summaries(measured.cases);
  if (!values.native) await measureWasm(measured, meshes);
  return measured;
}

function runNative(options) {
  const { status, error, stdout } = spawnSync(values.executable, options, {
    stdio: ['ignore', 'pipe', 'inherit'],
    maxBuffer: 2 ** 28,
  });
  if (error) throw error;
  if (status !== 0) throw new Error(`gvd_bench ended with status ${status}`);
  return JSON.parse(stdout);
}

function write(measured) {
  const text = values.json ? JSON.stringify(measured, null, 2) : report(measured);
  if (values.output) writeFileSync(values.output, `${text}\n`);
  else console.log(`\n${text}`);
}
