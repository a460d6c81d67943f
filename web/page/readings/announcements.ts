// SPDX-License-Identifier: MIT
//
// Tells those who do not see the page which site is selected, and what is painted.

import type { GeodesicVoronoiElement } from '../../viewer/element.js';
import { byId, listen } from '../base/dom.js';
import { integer, measure } from '../base/numbers.js';

/**
 * Announces the selected site to screen readers when the selection or its region changes, and the density
 * when it is painted or cleared.
 */
export function setUpAnnouncements(viewer: GeodesicVoronoiElement): void {
  const announcement = byId('announcement', HTMLElement);
  let told = -1;
  const tell = () => {
    const area = viewer.regionAreas[told];
    const region = area === undefined ? '' : `, region of area ${measure(area)}`;
    const count = integer(viewer.sites.face.length);
    announcement.textContent = told < 0 ? '' : `Site ${told} selected, of ${count}${region}`;
  };
  listen(viewer, 'sites-change', ({ selected }) => {
    if (selected === told) return;
    told = selected;
    tell();
  });
  listen(viewer, 'diagram', tell);
  let wasUniform = true;
  listen(viewer, 'density-change', ({ isUniform }) => {
    if (!(isUniform && wasUniform))
      announcement.textContent = isUniform ? 'No density is painted' : 'Density painted';
    wasUniform = isUniform;
  });
}
