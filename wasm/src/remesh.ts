// SPDX-License-Identifier: MIT
//
// Remeshing: sites at the centroids of their regions, and as many as a valid dual takes.

import type { CvtSettings } from './engine.js';
import type { SurfacePoints } from './results.js';
import type { Diagram, Mesh, TaskOptions } from './types.js';

/** Sites that repair adds are no centroids: after some were, everything moves again, this often. */
const mostRounds = 3;
/** About the part of the time that the tessellation of a round takes; its diagram and repair are the rest. */
const tessellationShare = 0.8;

/** The diagram with a valid dual that the tessellation of the sites, and of those added, comes to. */
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
