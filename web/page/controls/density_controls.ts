// SPDX-License-Identifier: MIT
//
// The controls of density: a brush, curvature, none.

import type { GeodesicVoronoiElement } from '../../viewer/element.js';
import { bindAttributes, byId, listen, onClick } from '../base/dom.js';
import { showFailure } from '../base/messages.js';

/** Layers that cover the surface, and with it the density. */
const covering: readonly string[] = ['distances', 'original'];

/** Painting a density, or taking that of curvature: the tessellation sizes regions by it. */
export function setUpDensityControls(viewer: GeodesicVoronoiElement): void {
  const paint = byId('density-paint', HTMLInputElement);
  const settings = byId('density-settings', HTMLElement);
  const hint = byId('hint', HTMLElement);
  const paintHint = byId('paint-hint', HTMLElement);
  const caption = byId('caption', HTMLElement);
  paint.addEventListener('change', () => {
    viewer.setAttribute('tool', paint.checked ? 'density' : 'sites');
    settings.hidden = !paint.checked;
    if (paint.checked) {
      caption.hidden = false;
      viewer.layers = viewer.layers.filter((layer) => !covering.includes(layer));
    }
    hint.hidden = paint.checked;
    paintHint.hidden = !paint.checked;
  });
  endPainting(viewer, paint);
  bindAttributes(viewer, 'brush-density', 'brush-size');
  onClick('density-curvature', async () => {
    const { mesh } = viewer;
    try {
      const density = await mesh?.curvatureDensity();
      if (mesh === viewer.mesh) viewer.density = density;
    } catch (error) {
      showFailure('The curvature cannot be computed', error);
    }
  });
  const clear = onClick('density-clear', () => {
    viewer.density = undefined;
  });
  listen(viewer, 'density-change', ({ isUniform }) => {
    clear.disabled = isUniform;
    // The legend of density is there then.
    byId('view', HTMLElement).classList.toggle('with-density', !isUniform);
  });
}

/**
 * Ends painting at Escape, with another model, when its controls are folded away or a layer covers
 * the surface, and by other edits of sites.
 */
function endPainting(viewer: GeodesicVoronoiElement, paint: HTMLInputElement): void {
  const end = () => {
    if (paint.checked) paint.click();
  };
  for (const details of document.querySelectorAll('details:has(#density-paint)')) {
    details.addEventListener('toggle', () => {
      if (!(details as HTMLDetailsElement).open) end();
    });
  }
  document.addEventListener('keydown', ({ key }) => {
    // Escape may be for a menu or dialogue that is open, or for work that is under way.
    const isFree = viewer.getAttribute('status') === 'ready';
    if (key === 'Escape' && isFree && !document.querySelector(':popover-open, dialog[open]')) end();
  });
  listen(viewer, 'load', end);
  byId('layers', HTMLFieldSetElement).addEventListener('change', ({ target }) => {
    if (covering.includes((target as HTMLInputElement).value)) end();
  });
  byId('sampling-form', HTMLFormElement).addEventListener('submit', end);
  onClick('clear', end);
  byId('site-list', HTMLSelectElement).addEventListener('change', end);
}
