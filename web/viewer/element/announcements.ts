// SPDX-License-Identifier: MIT
//
// Tells those who do not see the element which site is selected, and what is painted.

import { measure } from '../layers/measure.js';
import type { ReflectingElement } from './reflecting_element.js';

/**
 * Announces to screen readers which site is selected, with the area of its region, and that area when it
 * changes; the density when it is painted or cleared.
 */
export function setUpAnnouncements(
  element: ReflectingElement & { readonly regionAreas: Float64Array },
  announce: (sentence: string) => void,
): void {
  let told = -1;
  let siteCount = 0;
  /** The area of its region, as it was told; undefined before that is there. */
  let area: string | undefined;
  const areaNow = () => {
    const { regionAreas } = element;
    // With another number, they are those of the diagram before.
    return told < 0 || regionAreas.length !== siteCount ? undefined : measure(regionAreas[told]);
  };
  const tellSelection = () => {
    area = areaNow();
    const region = area === undefined ? '' : `, region of area ${area}`;
    announce(`${told < 0 ? 'No site' : `Site ${told}`} selected, of ${siteCount}${region}`);
  };
  element.addEventListener('sites-change', ({ detail: { selected, count } }) => {
    siteCount = count;
    if (selected === told) return;
    told = selected;
    tellSelection();
  });
  element.addEventListener('diagram', () => {
    const now = areaNow();
    if (now === undefined || now === area) return;
    if (area === undefined) tellSelection();
    else announce(`Region of area ${(area = now)}`);
  });
  let wasUniform = true;
  element.addEventListener('density-change', ({ detail: { isUniform } }) => {
    if (!(isUniform && wasUniform))
      announce(isUniform ? 'No density is painted' : 'Density painted');
    wasUniform = isUniform;
  });
}
