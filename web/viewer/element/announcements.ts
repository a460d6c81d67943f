// SPDX-License-Identifier: MIT
//
// Tells those who do not see the element which site is selected, and what is painted.

import { measure } from '../layers/measure.js';
import type { ReflectingElement } from './reflecting_element.js';

/**
 * Announces the selected site to screen readers when the selection or its region changes, and the density
 * when it is painted or cleared.
 */
export function setUpAnnouncements(
  element: ReflectingElement & { readonly regionAreas: Float64Array },
  announce: (sentence: string) => void,
): void {
  let told = -1;
  let siteCount = 0;
  const tell = () => {
    const area = element.regionAreas[told];
    const region = area === undefined ? '' : `, region of area ${measure(area)}`;
    announce(`${told < 0 ? 'No site' : `Site ${told}`} selected, of ${siteCount}${region}`);
  };
  element.addEventListener('sites-change', ({ detail: { selected, count } }) => {
    siteCount = count;
    if (selected === told) return;
    told = selected;
    tell();
  });
  element.addEventListener('diagram', () => {
    if (told >= 0) tell();
  });
  let wasUniform = true;
  element.addEventListener('density-change', ({ detail: { isUniform } }) => {
    if (!(isUniform && wasUniform))
      announce(isUniform ? 'No density is painted' : 'Density painted');
    wasUniform = isUniform;
  });
}
