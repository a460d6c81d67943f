// SPDX-License-Identifier: MIT
//
// The page's own address: it keeps the state that a link keeps, for reloading and coming back.

import type { GeodesicVoronoiElement } from '../viewer/element.js';
import { listen } from './dom.js';
import { isSample } from './first_model.js';
import { isPageState, linkAttributes, modelName, notHeld, pageState } from './page_state.js';

/** The address waits for the last of several changes: browsers limit how often it may change. */
const addressMilliseconds = 300;
/** What a person does first. Before, the address stays as it was opened. */
const firstActs = ['pointerdown', 'keydown', 'wheel', 'drop'];
/** Events of the viewer after which its state may be another. */
const changes = ['status-change', 'diagram', 'sites-change', 'camera-change'];

/**
 * Keeps the state in the address, without a step in the browser's history. A link of a file of
 * one's own stays until that file, or any other model than the one that stands in for it, is opened.
 */
export function setUpAddress(viewer: GeodesicVoronoiElement): void {
  const { hash } = location;
  const named = new URLSearchParams(hash.slice(1)).get('model');
  // Models to come before the first that the address is to tell of.
  let standIns = isPageState(hash) && named && !isSample(named) ? 1 : 0;
  listen(viewer, 'load', () => --standIns);
  let known = hash;
  let waiting = 0;
  const write = () => {
    // Another hash than the known one is a link that has just been pasted.
    const isReady = viewer.getAttribute('status') === 'ready' && standIns < 0;
    if (!isReady || location.hash !== known) return;
    history.replaceState(history.state, '', pageState(viewer));
    known = location.hash;
  };
  const writeSoon = () => {
    clearTimeout(waiting);
    waiting = window.setTimeout(write, addressMilliseconds);
  };
  const begun = new AbortController();
  const begin = () => {
    begun.abort();
    for (const type of changes) viewer.addEventListener(type, writeSoon);
    new MutationObserver(writeSoon).observe(viewer, { attributeFilter: [...linkAttributes] });
    writeSoon();
  };
  for (const type of firstActs) {
    addEventListener(type, begin, { capture: true, passive: true, signal: begun.signal });
  }
}

/** Asks before the page is left, if its address does not hold what was done. */
export function setUpLeaving(viewer: GeodesicVoronoiElement): void {
  let isEdited = false;
  listen(viewer, 'sites-change', ({ canUndo }) => {
    isEdited = canUndo;
  });
  addEventListener('beforeunload', (event) => {
    const isWork = viewer.loaded && (isEdited || !isSample(modelName(viewer)));
    if (isWork && notHeld(viewer).length > 0) event.preventDefault();
  });
}
