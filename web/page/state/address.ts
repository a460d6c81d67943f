// SPDX-License-Identifier: MIT
//
// The page's own address: it keeps the state that a link keeps, for reloading and coming back.

import type { GeodesicVoronoiElement } from '../../viewer/element.js';
import { lastSegment } from '../../viewer/session/model_files.js';
import { listen } from '../base/dom.js';
import { isSample, modelOf, namedModel } from '../samples/first_model.js';
import type { Edits } from './edits.js';
import { isPageState, linkAttributes, modelName, pageState } from './page_state.js';

/** The address waits for the last of several changes: browsers limit how often it may change. */
const addressMilliseconds = 300;
/** What a person does first. Before, the address stays as it was opened. */
const firstActs = ['pointerdown', 'click', 'change', 'keydown', 'wheel', 'drop'];
/** Events of the viewer after which its state may be another. */
const changes = ['status-change', 'diagram', 'sites-change', 'camera-change'];

/**
 * Keeps the state in the address, opens a link that comes into it, and asks before anything is left
 * that was done and that the address does not hold.
 */
export function setUpAddress(viewer: GeodesicVoronoiElement, edits: Edits): void {
  const restore = keepState(viewer);
  let isLeaving = false;
  // A link that is pasted into the page's own window, Back and Forward change nothing but the hash.
  addEventListener('hashchange', () => {
    isLeaving = edits.mayBeLeft();
    if (isLeaving) location.reload();
    else restore();
  });
  addEventListener('beforeunload', (event) => {
    if (!isLeaving && edits.areLost) event.preventDefault();
  });
}

/**
 * Keeps the state in the address. Another model is a step in the browser's history, so that Back
 * returns to the one before with its sites; other changes are none. A link of a reader's own file
 * opens with a sample in its place, and stays in the address until another model is opened. Returns
 * a function that puts the state back into the address.
 */
function keepState(viewer: GeodesicVoronoiElement): () => void {
  const { hash } = location;
  const named = namedModel(hash);
  const first = lastSegment(modelOf(hash));
  // The sample in place of a file, which the address does not describe.
  let standIn = isPageState(hash) && named && !isSample(named) ? first : undefined;
  listen(viewer, 'load', ({ name }) => {
    if (name !== standIn) standIn = undefined;
  });
  let known = hash;
  let model = named ?? first;
  let waiting = 0;
  const write = () => {
    // Another hash than the known one is a link that is about to be opened.
    const isReady = viewer.status === 'ready' && standIn === undefined;
    if (!isReady || location.hash !== known) return;
    const state = pageState(viewer);
    const isOther = modelName(viewer) !== model;
    if (isOther) history.pushState(null, '', state);
    else history.replaceState(history.state, '', state);
    model = modelName(viewer);
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
  return () => history.pushState(null, '', known);
}
