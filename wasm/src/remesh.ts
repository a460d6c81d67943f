// SPDX-License-Identifier: MIT
//
// Remeshing: sites move to the centroids of their regions, and more are added for a valid dual.

import type { CvtSettings } from './engine.js';
import type { SurfacePoints } from './results.js';
import type { Diagram, Mesh, TaskOptions } from './types.js';

/** The most rounds of tessellation and repair: added sites are not at centroids yet. */
const mostRounds = 3;
/** The approximate share of tessellation in a round's time; diagram and repair are the rest. */
const tessellationShare = 0.8;

/** Tessellates and adds sites in turn, until the diagram has a valid dual. */
export async function remesh(
  mesh: Mesh,
  given: SurfacePoints,
  settings: CvtSettings & { maxAdded: number },
  { signal, onProgress }: TaskOptions,
): Promise<Diagram> {
  const { maxAdded, ...cvt } = settings;
  const most = given.face.length + maxAdded;
  let sites = given;
  for (let round = 1; ; ++round) {
    const report = (share: number) => onProgress?.((round - 1 + share) / mostRounds);
    for await (const state of mesh.cvt(sites, {
      ...cvt,
      signal,
      onProgress: (share) => report(tessellationShare * share),
    })) {
      sites = state.sites;
    }
    const diagram = await mesh.voronoi(sites, { metric: cvt.metric, signal });
    try {
      const valid = await diagram.repair({
        maxAdded: most - sites.face.length,
        signal,
        onProgress: (share) => report(tessellationShare + (1 - tessellationShare) * share),
      });
      if (valid === diagram || round === mostRounds) {
        if (valid !== diagram) diagram.dispose();
        onProgress?.(1);
        return valid;
      }
      sites = valid.sites;
      valid.dispose();
    } catch (error) {
      diagram.dispose();
      throw error;
    }
    diagram.dispose();
  }
}
