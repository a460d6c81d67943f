// SPDX-License-Identifier: MIT
//
// Placing and removing sites, and the list of them.

import type { Sampling } from 'geodesic-voronoi';
import { commandOf, type GeodesicVoronoiElement } from '../../viewer/element.js';
import { byId, listen, onClick, showAttributes } from '../base/dom.js';
import { showFailure, showNoteOnSites } from '../base/messages.js';
import { counted, integer, measure } from '../base/numbers.js';

/** Sampling, removing, and the list of sites. */
export function setUpSiteControls(viewer: GeodesicVoronoiElement): void {
  setUpSampling(viewer);
  setUpEditing(viewer);
  setUpList(viewer);
  setUpBareNote(viewer);
}

/** Components of less area than this share, all of them together, are likely the debris of a scan. */
const debrisShare = 0.05;

/** Notes components that no site reaches. */
function setUpBareNote(viewer: GeodesicVoronoiElement): void {
  const note = byId('bare-note', HTMLElement);
  const update = async () => {
    const { mesh, info, sites, diagram } = viewer;
    if (!mesh || !info) return;
    const isAsked = info.components > 1 && sites.face.length > 0;
    const bare = isAsked ? await mesh.bareComponents(sites) : { components: 0, area: 0 };
    if (mesh !== viewer.mesh || diagram !== viewer.diagram) return;
    note.hidden = bare.components === 0;
    const share = bare.area / info.area;
    const advice =
      share < debrisShare
        ? '“Smallest component kept”, below “Model”, drops small ones.'
        : '“At least per component” places some, given enough sites.';
    note.textContent =
      `${integer(bare.components)} of ${counted(info.components, 'component')}, ` +
      `${Number((100 * share).toPrecision(2))} % of the area, ` +
      `${bare.components === 1 ? 'has' : 'have'} no site. ${advice}`;
  };
  listen(viewer, 'diagram', () => {
    update().catch((error) => showFailure('Components without a site cannot be counted', error));
  });
}

/**
 * Notes if sampling gives fewer sites than wanted: farthest points are vertices, and may run out.
 * The function returned tells how many are wanted by the sampling that begins.
 */
function setUpNoteOfFewer(viewer: GeodesicVoronoiElement): (count: number) => void {
  let wanted = 0;
  // There is no diagram if the sampling is given up.
  listen(viewer, 'status-change', ({ status }) => {
    if (status === 'ready') wanted = 0;
  });
  listen(viewer, 'diagram', ({ sites }) => {
    if (sites === 0 || sites >= wanted) return;
    showNoteOnSites(
      viewer,
      `${counted(sites, 'site')} instead of ${integer(wanted)}: places as far apart as possible are ` +
        'vertices, and this model has no more. Random sampling has no such limit.',
    );
  });
  return (count) => {
    wanted = count;
  };
}

function setUpSampling(viewer: GeodesicVoronoiElement): void {
  const form = byId('sampling-form', HTMLFormElement);
  const count = byId('count', HTMLInputElement);
  const seed = byId('seed', HTMLInputElement);
  const sampling = byId('sampling', HTMLSelectElement);
  const perComponent = byId('per-component', HTMLInputElement);
  const fields = { sites: count, seed, sampling, 'per-component': perComponent };
  showAttributes(viewer, fields);
  let shown = 0;
  listen(viewer, 'sites-change', ({ count: present }) => {
    if (present > 0 && present !== shown) count.valueAsNumber = present;
    shown = present;
  });
  const expectSites = setUpNoteOfFewer(viewer);
  listen(viewer, 'load', ({ info }) => {
    byId('per-component-label', HTMLElement).hidden = info.components < 2;
  });
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    expectSites(sampling.value === 'farthest' ? count.valueAsNumber : 0);
    // The attributes also hold for the next model. The viewer samples when they change.
    let isNew = false;
    for (const [name, field] of Object.entries(fields)) {
      isNew ||= viewer.getAttribute(name) !== field.value;
      viewer.setAttribute(name, field.value);
    }
    if (isNew) return;
    void viewer.sampleSites(
      count.valueAsNumber,
      seed.valueAsNumber,
      sampling.value as Sampling,
      perComponent.valueAsNumber,
    );
  });
}

function setUpEditing(viewer: GeodesicVoronoiElement): void {
  const remove = onClick('remove', () => viewer.perform('remove'));
  const clear = onClick('clear', () => {
    viewer.sites = { face: [], bary: [] };
  });
  listen(viewer, 'sites-change', ({ count, selected }) => {
    remove.disabled = selected < 0;
    clear.disabled = count === 0;
    byId('site-count', HTMLElement).textContent = counted(count, 'site');
  });
}

/**
 * The list of sites, for readers who cannot use the picture. It is updated only while it is open,
 * and only where it changed: a drag changes a few regions many times a second.
 */
function setUpList(viewer: GeodesicVoronoiElement): void {
  const details = byId('site-details', HTMLDetailsElement);
  const list = byId('site-list', HTMLSelectElement);
  let shown: Float64Array = new Float64Array();
  const fill = () => {
    if (!details.open) return;
    const areas = viewer.regionAreas;
    // Few are left: it is filled anew, since a list selects anew after each option that goes.
    if (list.length > 2 * areas.length) list.replaceChildren();
    list.length = Math.min(list.length, areas.length);
    const options = [...list.options]; // read once: a list counts its options whenever it is asked
    areas.forEach((area, i) => {
      const option = options.at(i);
      if (option && area === shown[i]) return;
      const text = `Site ${i}, region of area ${measure(area)}`;
      if (option) option.text = text;
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
  // Several are removed in a row: the site that takes the place in the list is selected.
  list.addEventListener('keydown', (event) => {
    const { selected } = viewer;
    if (commandOf(event) !== 'remove' || selected < 0) return;
    event.preventDefault();
    viewer.removeSite(selected);
    viewer.selected = Math.min(selected, viewer.sites.face.length - 1);
  });
}
