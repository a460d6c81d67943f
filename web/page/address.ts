// SPDX-License-Identifier: MIT
//
// The page's own address: it keeps the state that a link keeps, for reloading and coming back.

import type { GeodesicVoronoiElement } from '../viewer/element.js';
import { lastSegment } from '../viewer/model_files.js';
import { isSample } from './first_model.js';
import { isPageState, linkAttributes, pageState } from './page_state.js';

/** The address waits for the last of several changes: browsers limit how often it may change. */
const addressMilliseconds = 300;
/** What a person does first. Before, the address stays as it was opened. */
const firstActs = ['pointerdown', 'keydown', 'wheel', 'drop'];
/** Events of the viewer after which its state may be another. */
const changes = ['status-change', 'diagram', 'sites-change', 'camera-change'];

/**
 * Keeps the state of samples in the address, without a step in the browser's history. A link of a
 * file of one's own stays: the file has yet to be opened, or is opened again after reloading.
 */
export function setUpAddress(viewer: GeodesicVoronoiElement): void {
  const { hash } = location;
  const named = new URLSearchParams(hash.slice(1)).get('model');
  if (isPageState(hash) && named && !isSample(named)) return;
  let known = hash;
  let waiting = 0;
  const write = () => {
    const model = lastSegment(viewer.info?.origin.file ?? '');
    // Another hash than the known one is a link that has just been pasted.
    if (viewer.getAttribute('status') !== 'ready' || !isSample(model) || location.hash !== known)
      return;
    history.replaceState(history.state, '', pageState(viewer, model));
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
