// SPDX-License-Identifier: MIT
//
// Whether the dual is a valid mesh of the surface, and its repair.

import type { Violation } from 'geodesic-voronoi';
import type { GeodesicVoronoiElement } from '../../viewer/element.js';
import { showFailure, showNote } from '../base/messages.js';
import { counted } from '../base/numbers.js';
import { isSame } from '../base/same_sites.js';

/** The violations of a dual, as a sentence about what has them; undefined if there are none. */
export function violationSentence(
  what: string,
  violations: readonly Violation[],
): string | undefined {
  const [first, ...others] = violations;
  const more = others.length > 0 ? `, and ${counted(others.length, 'more violation')}` : '';
  return first && `${what} no valid mesh of the surface: ${first.message}${more}.`;
}

/**
 * Adds sites until the dual is valid, a step to undo. Sites that are edited meanwhile are kept. A
 * note tells how far it is, and cancels it.
 */
export async function repairDual(viewer: GeodesicVoronoiElement): Promise<void> {
  const { diagram, sites } = viewer;
  if (!diagram) return;
  const stopping = new AbortController();
  const { signal } = stopping;
  const cancel = { title: 'Cancel', act: () => stopping.abort() };
  let shown = '';
  let endNote = () => {};
  const onProgress = (share: number) => {
    const now = `Adding sites to make the dual valid: ${10 * Math.floor(10 * share)} %.`;
    if (now !== shown) endNote = showNote((shown = now), cancel);
  };
  try {
    const valid = await diagram.repair({ signal, onProgress });
    if (diagram === viewer.diagram && isSame(sites, viewer.sites)) viewer.sites = valid.sites;
    if (valid !== diagram) valid.dispose();
  } catch (error) {
    if (!signal.aborted) showFailure('Sites cannot be added', error);
  }
  endNote();
}
