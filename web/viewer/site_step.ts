// SPDX-License-Identifier: MIT
import type { Site, Sites } from './site_history.js';

/** What leads from one list of sites to another: a site that moved, or one more at the end. */
export interface SiteStep {
  kind: 'move' | 'insert';
  /** In both lists, or in the new one. */
  index: number;
  site: Site;
}

/** The step between two lists; undefined if it takes more than one, or one that renumbers sites. */
export function stepBetween(before: Sites, after: Sites): SiteStep | undefined {
  const isOther = (site: Site, i: number) => site !== before[i];
  const index = after.findIndex(isOther);
  if (index < 0) return undefined;
  const site = after[index];
  if (after.length === before.length + 1 && index === before.length) {
    return { kind: 'insert', index, site };
  }
  const isMove =
    after.length === before.length &&
    site.id === before[index].id &&
    after.filter(isOther).length === 1;
  return isMove ? { kind: 'move', index, site } : undefined;
}
