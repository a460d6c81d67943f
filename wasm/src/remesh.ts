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
/** The most steps that the sites added last take towards their centroids. */
const mostSettlings = 5;

/**
 * Tessellates and adds sites in turn, until the diagram has a valid dual without more. Each round adds
 * at most half as many sites as the one before, or else the diagram before it is the result: sites that
 * are spread anew may lack others in other places, and there would be more and more. In the end, the
 * sites that were added last are settled.
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
  let last: number[] = []; // labels of the sites that the last round added
  for (let round = 1; round <= mostRounds; ++round) {
    const report = (share: number) => onProgress?.((round - 1 + share) / (mostRounds + 1));
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
      last = labelsAdded(sites, valid.sites);
      if (valid === diagram) break;
      diagram.dispose();
    } catch (error) {
      diagram?.dispose();
      if (kept && error instanceof GeodesicVoronoiError && error.code === 'too-few-sites') break;
      kept?.dispose();
      throw error;
    }
    most = Math.floor(last.length / 2);
    left -= last.length;
    sites = kept.sites;
  }
  const report = (share: number) => onProgress?.((mostRounds + share) / (mostRounds + 1));
  const settled = await settle(mesh, kept!, last, cvt, { signal, onProgress: report });
  onProgress?.(1);
  return settled;
}

/** The labels that have a site now, and had none before. */
function labelsAdded(before: SurfacePoints, { face }: SurfacePoints): number[] {
  return [...face.keys()].filter((label) => face[label] >= 0 && !(before.face[label] >= 0));
}

/**
 * Moves some sites towards the centroids of their regions, a step of Lloyd's method at a time, as long
 * as the dual stays valid and its least angle grows. Steps of all sites would soon break the dual, and
 * so may these: a site of a violation then stays where it is, and the others try again.
 */
async function settle(
  mesh: Mesh,
  diagram: Diagram,
  labels: readonly number[],
  cvt: CvtSettings,
  { signal, onProgress }: TaskOptions,
): Promise<Diagram> {
  let kept = diagram;
  let next: Diagram | undefined;
  const movable = new Set(labels);
  try {
    for (let step = 0; step < mostSettlings && movable.size > 0; ++step) {
      onProgress?.(step / mostSettlings);
      const { face } = kept.sites;
      const fixedSites = [...face.keys()].filter((l) => face[l] >= 0 && !movable.has(l));
      const options = { ...cvt, method: 'lloyd', iterations: 1, fixedSites, signal } as const;
      for await (const state of mesh.cvt(kept.sites, { ...options, diagrams: true })) {
        next?.dispose();
        next = state.diagram;
      }
      const violations = await next!.violations({ signal });
      if (violations.length > 0) {
        const moved = violations.flatMap(({ labels }) => labels).filter((l) => movable.has(l));
        if (moved.length === 0) break; // the next step would be the same
        for (const label of moved) movable.delete(label);
        continue;
      }
      if ((await leastAngle(next!, signal)) <= (await leastAngle(kept, signal))) break;
      kept.dispose();
      [kept, next] = [next!, undefined];
    }
  } catch (error) {
    kept.dispose();
    throw error;
  } finally {
    next?.dispose();
  }
  return kept;
}

async function leastAngle(diagram: Diagram, signal: AbortSignal | undefined): Promise<number> {
  return (await diagram.remeshQuality({ signal })).minAngle;
}
