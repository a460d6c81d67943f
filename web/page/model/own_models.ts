// SPDX-License-Identifier: MIT
//
// The models among the files that a person opens. This code is fetched when it is needed first.

import { listModels, type ModelFiles } from 'geodesic-voronoi';

/** Their paths, in natural order. Empty after an error, which opening the files will report. */
export async function ownModels(files: ModelFiles): Promise<string[]> {
  const paths = await listModels(files).catch(() => []);
  return paths.sort(new Intl.Collator(undefined, { numeric: true }).compare);
}
