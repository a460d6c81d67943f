// SPDX-License-Identifier: MIT
//
// Exact answers that were computed elsewhere, made readable for gvd_bench: truth_case.h says how.
//
// A folder of them has cases/*.json.gz beside itself meshes in ../meshes:
//
//     { mesh, kind, k, sites: { face, bary }, points: { face, bary, label, distance, distance2 } }
//
// and may have cvt/init_<mesh>_<k>.json.gz with { mesh, sites } and cvt/samples_<mesh>.json.gz with
// { points } beside them.
//
// Distances below 0 are not known. Where paths may or may not lead through a vertex that two fans
// share, labelSplit and distanceSplit are for those that don't: that is how this library sees it.

import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, join, resolve } from 'node:path';
import { gunzipSync } from 'node:zlib';

/** Writes the cases of `folder` that `only` chooses to another folder and returns the paths. */
export function writeTruthCases(folder, target, only = '') {
  return chosen(readdirSync(join(folder, 'cases')), '', only).map((name) => {
    const text = gunzipSync(readFileSync(join(folder, 'cases', `${name}.json.gz`))).toString();
    const path = join(target, `${name}.txt`);
    writeFileSync(path, toText(name, JSON.parse(text), folder));
    return path;
  });
}

/** Initial sites of tessellations and points to measure them at, where the folder has such. */
export function writeTessellations(folder, target, only = '') {
  if (!existsSync(join(folder, 'cvt'))) return [];
  const read = (name) => JSON.parse(gunzipSync(readFileSync(join(folder, 'cvt', name))).toString());
  return chosen(readdirSync(join(folder, 'cvt')), 'init_', only).map((name) => {
    const { mesh, sites } = read(`init_${name}.json.gz`);
    const { points } = read(`samples_${basename(mesh, '.glb')}.json.gz`);
    const unknown = points.face.map(() => -1);
    const path = join(target, `${name}.txt`);
    const known = { ...points, label: unknown, distance: unknown };
    writeFileSync(path, toText(name, { mesh, sites, points: known }, folder));
    return path;
  });
}

/** The one called `only`, or those with that in their name; sorted, without prefix and ending. */
function chosen(files, prefix, only) {
  const names = files
    .filter((file) => file.startsWith(prefix) && file.endsWith('.json.gz'))
    .map((file) => basename(file, '.json.gz').slice(prefix.length))
    .sort();
  return names.includes(only) ? [only] : names.filter((name) => name.includes(only));
}

function toText(name, { mesh, sites, points }, folder) {
  const { label, distance, distance2 } = points.labelSplit
    ? { label: points.labelSplit, distance: points.distanceSplit }
    : points;
  const place = ({ face, bary }, i) => [face[i], ...bary.slice(3 * i, 3 * i + 3)];
  const rows = [
    [name],
    [resolve(folder, '../meshes', mesh)],
    [sites.face.length, points.face.length],
    ...sites.face.map((_, i) => place(sites, i)),
    ...points.face.map((_, i) => [
      ...place(points, i),
      label[i],
      distance[i],
      distance2?.[i] ?? -1,
    ]),
  ];
  return rows.map((row) => `${row.join(' ')}\n`).join('');
}
