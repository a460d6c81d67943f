// SPDX-License-Identifier: MIT
//
// The diagram that the options ask for, and what standard error should say about it.

import { mostMislabelled } from '../api/results.js';
import { counted } from '../base/sentences.js';
import type { Diagram, Mesh } from '../api/types.js';
import type { Output } from './files.js';
import { withProgress } from './progress.js';
import { type Notices, openWithSites, type SiteValues, writeNotes } from './sites.js';

/** Opens a mesh and computes the diagram of the sites that the options ask for. */
export async function openDiagram(
  path: string,
  output: Output,
  values: SiteValues & { detail?: number },
  options?: { addsSites: boolean },
): Promise<{ mesh: Mesh; diagram: Diagram }> {
  const { mesh, sites } = await openWithSites(path, output, values, options);
  const { metric, detail } = values;
  const diagram = await withProgress(values, (onProgress) =>
    mesh.voronoi(sites, { metric, detail, onProgress }),
  );
  writeNotes(hiddenNotes(diagram), values);
  // Points are located by distance, however coarse borders are.
  if (detail !== undefined)
    await noteCoarseFaces(diagram, values, { remedy: detail === 0 ? ' --detail 1' : '' });
  return { mesh, diagram };
}

/** Sites that have no region. */
function hiddenNotes({ sites, regions }: Diagram): string[] {
  const isEmpty = (label: number) => regions[label].area === 0 && regions[label].loops.length === 0;
  const hidden = sites.face.reduce(
    (count, face, label) => count + Number(face >= 0 && isEmpty(label)),
    0,
  );
  if (hidden === 0) return [];
  return [`${counted(hidden, 'site')} without a region: another site is at the same place`];
}

/** Notes where the faces of a tessellation are too coarse: it interpolates squared distances within each. */
export function noteCoarseTessellation(diagram: Diagram, notices: Notices): Promise<void> {
  return noteCoarseFaces(diagram, notices, { more: ', energies and centroids are inaccurate' });
}

/** Notes how much of the area faces put in the wrong region because they are coarse, and what helps. */
async function noteCoarseFaces(
  diagram: Diagram,
  notices: Notices,
  { more = '', remedy = '' }: { more?: string; remedy?: string },
): Promise<void> {
  if (notices.quiet) return;
  const { mislabelled, maxEdge } = await diagram.accuracy();
  if (mislabelled <= mostMislabelled) return;
  const share = Number((100 * mislabelled).toPrecision(2));
  const note =
    `faces are too coarse: about ${share} % of the area lies in the wrong region${more} ` +
    `(--max-edge ${maxEdge}${remedy} makes it less)`;
  writeNotes([note], notices);
}
