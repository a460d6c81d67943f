// SPDX-License-Identifier: MIT
//
// Remeshing: sites move to the centroids of their regions, and more are added for a valid dual.

import type { CvtSettings } from './engine.js';
import { GeodesicVoronoiError } from './errors.js';
import type { SurfacePoints } from './results.js';
import type { Diagram, Mesh, TaskOptions } from './types.js';

/** The most rounds of tessellation and repair: sites just added are not at centroids yet. */
const mostRounds = 3;
/** The approximate share of tessellation in a round's time; diagram and repair are the rest. */
const tessellationShare = 0.8;

/**
 * Tessellates and adds sites in turn, until the diagram has a valid dual without more. Each round adds
 * at most half as many sites as the one before, or else the diagram before it is the result: sites that
 * are spread anew may lack others in other places, and there would be more and more.
 */
export async function remesh(
  mesh: Mesh,
  given: SurfacePoints,
  settings: CvtSettings & { maxAdded: number },
  { signal, onProgress }: TaskOptions,
): Promise<Diagram> {
  const { maxAdded, ...cvt } = settings;
  let [sites, most, left] = [given, maxAdded, maxAdded];
  let kept: Diagram | undefined;
  for (let round = 1; round <= mostRounds; ++round) {
    const report = (share: number) => onProgress?.((round - 1 + share) / mostRounds);
    let diagram: Diagram | undefined;
    try {
      for await (const state of mesh.cvt(sites, {
        ...cvt,
        signal,
        onProgress: (share) => report(tessellationShare * share),
      })) {
        sites = state.sites;
      }
      diagram = await mesh.voronoi(sites, { metric: cvt.metric, signal });
      const valid = await diagram.repair({
        maxAdded: Math.min(most, left),
        signal,
        onProgress: (share) => report(tessellationShare + (1 - tessellationShare) * share),
      });
      kept?.dispose();
      kept = valid;
      if (valid === diagram) break;
      diagram.dispose();
    } catch (error) {
      diagram?.dispose();
      if (kept && error instanceof GeodesicVoronoiError && error.code === 'too-few-sites') break;
      kept?.dispose();
      throw error;
    }
    const added = countOf(kept.sites) - countOf(sites);
    most = Math.floor(added / 2);
    left -= added;
    sites = kept.sites;
  }
  onProgress?.(1);
  return kept!;
}

/** Labels that are free have no site. */
function countOf({ face }: SurfacePoints): number {
  return face.filter((f) => f >= 0).length;
}
