// SPDX-License-Identifier: MIT
//
// The few changes that lead from one list of sites to another.

import type { Site, Sites } from './site_history.js';

/**
 * A change of one site in a list: the last one goes, one becomes another, or one more comes at the
 * end.
 */
export type SiteStep =
  | { kind: 'remove'; index: number }
  | { kind: 'move'; index: number; site: Site }
  | { kind: 'insert'; index: number; site: Site };

/** The most steps: beyond, the whole diagram is computed anew. */
const mostSteps = 2;

/**
 * The steps from one list to another, in an order in which no two sites meet; undefined if many.
 */
export function stepsBetween(before: Sites, after: Sites): SiteStep[] | undefined {
  const common = Math.min(before.length, after.length);
  const differing = after.slice(0, common).filter((site, i) => site !== before[i]).length;
  const count = differing + Math.abs(after.length - before.length);
  if (count === 0 || count > mostSteps) return undefined;
  const steps: SiteStep[] = [];
  for (let index = before.length - 1; index >= common; --index) {
    steps.push({ kind: 'remove', index });
  }
  after.forEach((site, index) => {
    if (index >= common) steps.push({ kind: 'insert', index, site });
    else if (site !== before[index]) steps.push({ kind: 'move', index, site });
  });
  return steps;
}

/** The list without a site: the last one takes its place, so that all others keep theirs. */
export function without(sites: Sites, id: number): Sites {
  const index = sites.findIndex((site) => site.id === id);
  if (index < 0) return sites;
  const last = sites[sites.length - 1];
  return sites.slice(0, -1).map((site, i) => (i === index ? last : site));
}
