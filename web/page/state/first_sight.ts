// SPDX-License-Identifier: MIT
//
// The opening of the page: a model whose random regions become even ones, once.

import type { CvtState } from 'geodesic-voronoi';
import { attributeOf } from '../../viewer/attributes/attribute_defaults.js';
import type { GeodesicVoronoiElement } from '../../viewer/element.js';
import { hexagonEnergy } from '../../viewer/session/hexagon_energy.js';
import type { CvtReadings } from '../readings/cvt_readings.js';
import { byId, listen } from '../base/dom.js';
import { showFailure } from '../base/messages.js';
import { isSample, modelOf } from '../samples/first_model.js';
import { isPageState, modelName, readPageState } from './page_state.js';
import { isSame } from '../base/same_sites.js';

/** Opens a shared link as it was; without one, a sample plays once. */
export function setUpFirstSight(viewer: GeodesicVoronoiElement, readings: CvtReadings): void {
  enableWithModel(viewer);
  endCaption(viewer);
  const play = () => {
    if (!isSample(modelName(viewer))) return; // a file was opened before there was anything to play
    evenOut(viewer, readings).catch((error) => showFailure('Regions cannot be evened out', error));
  };
  viewer.src = modelOf(location.hash);
  if (isPageState(location.hash)) readPageState(viewer, location.hash);
  else viewer.addEventListener('diagram', play, { once: true });
}

/** Controls are disabled until there is something for them to do. */
function enableWithModel(viewer: GeodesicVoronoiElement): void {
  const groups = ['toolbar', 'lead', 'panel'].map((id) => byId(id, HTMLFieldSetElement));
  listen(viewer, 'load', () => {
    for (const group of groups) group.disabled = false;
  });
}

/**
 * Removes the sentence on the view after the first edit, where nothing can be edited, and where
 * other colours are shown than those it speaks of.
 */
function endCaption(viewer: GeodesicVoronoiElement): void {
  const caption = byId('caption', HTMLElement);
  new MutationObserver(() => {
    const { layers } = viewer;
    const hidesRegions = layers.includes('distances') || layers.includes('original');
    if (!layers.includes('regions') || hidesRegions) caption.hidden = true;
  }).observe(viewer, { attributeFilter: ['layers'] });
  listen(viewer, 'exploded', (parts) => {
    if (parts) caption.hidden = true;
  });
  const ofSites = [caption.querySelector('span')!, byId('drag-hint', HTMLElement)];
  listen(viewer, 'sites-change', ({ count, selected }) => {
    for (const part of ofSites) part.hidden = count === 0;
    if (selected >= 0) caption.hidden = true;
  });
}

/**
 * Plays a tessellation; for readers who want no motion, computes it without showing iterations.
 * Either way it is one step to undo.
 */
async function evenOut(viewer: GeodesicVoronoiElement, readings: CvtReadings): Promise<void> {
  if (!matchMedia('(prefers-reduced-motion: reduce)').matches) {
    viewer.playCvt();
    return;
  }
  const { mesh, sites } = viewer;
  if (!mesh) return;
  const isIdle = () => viewer.cvtStatus === 'idle';
  const clear = () => isIdle() && readings.tell('idle');
  const iterations = Number(attributeOf(viewer, 'cvt-iterations'));
  const states: CvtState[] = [];
  // What the reader has opened or edited meanwhile is kept.
  const isChanged = () =>
    mesh !== viewer.mesh || viewer.density !== undefined || !isSame(sites, viewer.sites);
  readings.tell('running');
  try {
    for await (const state of mesh.cvt(sites, { iterations })) {
      if (isChanged()) break;
      states.push(state);
    }
  } catch (error) {
    clear();
    throw error;
  }
  const last = states.at(-1);
  if (!last || isChanged()) {
    clear();
    return;
  }
  viewer.sites = last.sites;
  const { regionAreas: regionArea } = viewer;
  const hexagons = hexagonEnergy({ siteCount: regionArea.length, regionArea });
  const show = () => {
    if (!isIdle()) return;
    for (const state of states) {
      readings.add({ ...state, relativeEnergy: state.energy / hexagons });
    }
    readings.tell(last.iteration < iterations ? 'done' : 'paused');
    // The next diagram has other sites, to which the readings do not apply.
    viewer.addEventListener('diagram', clear, { once: true });
  };
  viewer.addEventListener('diagram', show, { once: true });
}
