// SPDX-License-Identifier: MIT
//
// What `npm run bench` is asked for. Checked here, before anything is built: a build takes minutes.

import { statSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { parseArgs } from 'node:util';

export const usage = `Usage: npm run bench [-- OPTIONS]
       npm run --silent bench -- OPTIONS --json   (without npm's own lines on standard output)

What to measure, and on what
  --part NAME        only speed, size, accuracy, convergence or cvt
  --metric NAME      only dgpc or exact
  --mesh FILE        a glTF file (.glb or .gltf) instead of the meshes that are generated or come
                     with npm; may be repeated
  --subdivide N      every face in four, N times, new vertices displaced by a little noise (0)
  --only TEXT        only meshes and cases with this in their name; if a case is called so, only it
  --truth FOLDER     compares with the exact answers there: truth_cases.mjs says how they look

How
  --sites N,N,...    numbers of sites that speed is measured with (1,10,100,300,1000,5000)
  --seed N           what the sites depend on (1)
  --runs N           the fastest counts; Dijkstra's algorithm and the metrics take turns (5)
  --detail N         of the diagrams (0)
  --oracle-sites N, --oracle-points N, --oracle-faces N
                     where distances are compared with CGAL's: sites (30) and points (1000) per
                     mesh, faces of the largest mesh (6000)
  --wasm             times the same in WebAssembly too, under Node

What to write: tables for people, or
  --json             one JSON document, times in seconds
  -o, --output FILE  writes there instead of to standard output
  --help             writes this

The JSON has a list per part. That of speed has an entry per mesh and number of sites, that of size
(one shape with 300 sites, finer and finer) one per mesh:
  mesh, faces, sites, dijkstra   the last one in seconds: the unit
  metrics.dgpc, metrics.exact    distances, diagram (tracing, with loops), partition, change (a site
                                 that moves to the next face; where the metric allows that), and
                                 with --wasm, wasm (distances and diagram there) in seconds;
                                 bytes (the most allocated for both at a time), bytesPerFace

The exit code is 2 if an option or a file is wrong.`;

/** Something that whoever called can mend: one line says it, and the exit code is 2. */
export class UsageError extends Error {
  exitCode = 2;
}

const parts = ['speed', 'size', 'accuracy', 'convergence', 'cvt'];
const metrics = ['dgpc', 'exact'];

/** Those that gvd_bench takes too, with what must hold of their values. */
const shared = {
  part: oneOf(parts),
  metric: oneOf(metrics),
  subdivide: number(0),
  only: () => {},
  sites: (name, text) => text.split(',').forEach((item) => number(1)(name, item)),
  seed: number(0),
  runs: number(1),
  detail: number(0),
  'oracle-sites': number(1),
  'oracle-points': number(1),
  'oracle-faces': number(0),
};

/** The options by name, and in `native` those to hand on. Throws a `UsageError`. */
export function readOptions(args) {
  const { values } = parse(args);
  const native = [];
  for (const [name, check] of Object.entries(shared)) {
    if (values[name] === undefined) continue;
    check(name, values[name]);
    native.push(`--${name}`, values[name]);
  }
  for (const file of values.mesh) {
    if (!kind(file)?.isFile()) throw new UsageError(`--mesh: there is no file ${file}`);
  }
  if (values.truth && !kind(join(values.truth, 'cases'))?.isDirectory()) {
    throw new UsageError(`--truth: there is no folder ${join(values.truth, 'cases')}`);
  }
  if (values.output && !kind(dirname(values.output))?.isDirectory()) {
    throw new UsageError(`--output: there is no folder ${dirname(values.output)}`);
  }
  return { ...values, native };
}

function parse(args) {
  try {
    return parseArgs({
      args,
      options: {
        ...Object.fromEntries(Object.keys(shared).map((name) => [name, { type: 'string' }])),
        mesh: { type: 'string', multiple: true, default: [] },
        truth: { type: 'string' },
        wasm: { type: 'boolean' },
        json: { type: 'boolean' },
        output: { type: 'string', short: 'o' },
        help: { type: 'boolean', short: 'h' },
      },
    });
  } catch (error) {
    throw new UsageError(error.message.split('\n')[0]);
  }
}

function number(least) {
  return (name, text) => {
    if (!/^\d+$/.test(text) || Number(text) < least || Number(text) >= 2 ** 31) {
      throw new UsageError(`--${name}: '${text}' is not a number of at least ${least}`);
    }
  };
}

function oneOf(known) {
  return (name, text) => {
    if (!known.includes(text)) {
      throw new UsageError(`--${name}: '${text}' is none of ${known.join(', ')}`);
    }
  };
}

const kind = (path) => statSync(path, { throwIfNoEntry: false });
