// SPDX-License-Identifier: MIT
//
// The models among the files that a person opens: fetched with the first of these.

import { listModels, type ModelFiles } from 'geodesic-voronoi';

/** Their paths, as a person would order them; none if something is wrong, which is said when they are opened. */
export async function ownModels(files: ModelFiles): Promise<string[]> {
  const paths = await listModels(files).catch(() => []);
  return paths.sort(new Intl.Collator(undefined, { numeric: true }).compare);
}
