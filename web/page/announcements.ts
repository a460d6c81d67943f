// SPDX-License-Identifier: MIT
//
// Tells those who do not see the page which site is chosen.

import type { GeodesicVoronoiElement } from '../viewer/element.js';
import { byId, listen } from './dom.js';
import { integer, measure } from './numbers.js';

/** Announces the chosen site to screen readers when the choice or its region changes. */
export function setUpAnnouncements(viewer: GeodesicVoronoiElement): void {
  const announcement = byId('announcement', HTMLElement);
  let chosen = -1;
  const tell = () => {
    const area = viewer.regionAreas[chosen];
    const region = area === undefined ? '' : `, region of area ${measure(area)}`;
    const count = integer(viewer.sites.face.length);
    announcement.textContent = chosen < 0 ? '' : `Site ${chosen} chosen, of ${count}${region}`;
  };
  listen(viewer, 'sites-change', ({ selected }) => {
    if (selected === chosen) return;
    chosen = selected;
    tell();
  });
  listen(viewer, 'diagram', tell);
}
