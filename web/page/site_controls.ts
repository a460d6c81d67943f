// SPDX-License-Identifier: MIT
import type { Sampling } from 'geodesic-voronoi';
import type { GeodesicVoronoiElement } from '../viewer/element.js';
import { byId, listen, onClick } from './dom.js';
import { measure } from './numbers.js';

/** Scattering, undoing, removing, and the list of sites. */
export function setUpSiteControls(viewer: GeodesicVoronoiElement): void {
  setUpScatter(viewer);
  setUpEditing(viewer);
  setUpList(viewer);
}

function setUpScatter(viewer: GeodesicVoronoiElement): void {
  const form = byId('scatter', HTMLFormElement);
  const count = byId('count', HTMLInputElement);
  const seed = byId('seed', HTMLInputElement);
  const sampling = byId('sampling', HTMLSelectElement);
  const fields = { sites: count, seed, sampling };
  for (const [name, field] of Object.entries(fields)) {
    field.value = viewer.getAttribute(name) ?? field.value;
  }
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    // The attributes also hold for the next model. The viewer scatters when they change.
    let isNew = false;
    for (const [name, field] of Object.entries(fields)) {
      isNew ||= viewer.getAttribute(name) !== field.value;
      viewer.setAttribute(name, field.value);
    }
    if (isNew) return;
    void viewer.scatter(count.valueAsNumber, seed.valueAsNumber, sampling.value as Sampling);
  });
}

function setUpEditing(viewer: GeodesicVoronoiElement): void {
  const undo = onClick('undo', () => viewer.undo());
  const redo = onClick('redo', () => viewer.redo());
  const remove = onClick('remove', () => viewer.removeSite(viewer.selected));
  const clear = onClick('clear', () => {
    viewer.sites = { face: [], bary: [] };
  });
  listen(viewer, 'sites-change', ({ count, selected, canUndo, canRedo }) => {
    undo.disabled = !canUndo;
    redo.disabled = !canRedo;
    remove.disabled = selected < 0;
    clear.disabled = count === 0;
  });
}

/**
 * For readers of lists rather than of pictures. It is kept up only while it is open, and of it what has
 * changed: a drag changes a few regions many times a second.
 */
function setUpList(viewer: GeodesicVoronoiElement): void {
  const details = byId('site-details', HTMLDetailsElement);
  const list = byId('site-list', HTMLSelectElement);
  let shown: Float64Array = new Float64Array();
  const fill = () => {
    if (!details.open) return;
    const areas = viewer.regionAreas;
    list.length = Math.min(list.length, areas.length);
    areas.forEach((area, i) => {
      if (i < list.length && area === shown[i]) return;
      const text = `Site ${i + 1}, region of area ${measure(area)}`;
      if (i < list.length) list.options[i].text = text;
      else list.add(new Option(text));
    });
    shown = areas;
    if (list.selectedIndex !== viewer.selected) list.selectedIndex = viewer.selected;
  };
  details.addEventListener('toggle', fill);
  listen(viewer, 'diagram', fill);
  listen(viewer, 'cvt-iteration', fill);
  listen(viewer, 'sites-change', ({ selected }) => {
    list.selectedIndex = selected;
  });
  list.addEventListener('change', () => {
    viewer.selected = list.selectedIndex;
  });
}
