// SPDX-License-Identifier: MIT
//
// The two messages that the page shows over the view: an error, and a note that is none.

import type { GeodesicVoronoiElement } from '../../viewer/element.js';
import { isAbandoned, sentence } from '../../viewer/session/failure.js';
import { byId } from './dom.js';
import { isSame } from './same_sites.js';

/**
 * Shows a note that is no error, with an action, if there is one, to do about it. Returns what hides
 * it, if it is still there, once it is no longer true.
 */
export function showNote(
  sentence: string,
  action?: { title: string; act: () => void },
): () => void {
  const text = byId('note-text', HTMLElement);
  text.textContent = sentence;
  const button = byId('note-action', HTMLButtonElement);
  button.hidden = action === undefined;
  button.textContent = action?.title ?? '';
  button.onclick = () => {
    hideNote();
    action?.act();
  };
  byId('note', HTMLElement).hidden = false;
  return () => {
    if (text.textContent === sentence) hideNote();
  };
}

/** Shows a note on the sites as they are, which ends with their next change. Returns what hides it. */
export function showNoteOnSites(
  viewer: GeodesicVoronoiElement,
  ...note: Parameters<typeof showNote>
): () => void {
  const end = showNote(...note);
  const { sites } = viewer;
  const noted = new AbortController();
  const endIfChanged = () => {
    if (isSame(sites, viewer.sites)) return; // only the selection is another one
    noted.abort();
    end();
  };
  viewer.addEventListener('sites-change', endIfChanged, { signal: noted.signal });
  return end;
}

export function hasNote(): boolean {
  return !byId('note', HTMLElement).hidden;
}

export function hideNote(): void {
  byId('note', HTMLElement).hidden = true;
}

/** Shows an error, as a sentence. */
export function showError(sentence: string): void {
  byId('error-text', HTMLElement).textContent = sentence;
  byId('error', HTMLElement).hidden = false;
}

/** Shows that something cannot be done, and why; nothing if its model or diagram is gone. */
export function showFailure(what: string, cause: unknown): void {
  if (!isAbandoned(cause)) showError(sentence(what, cause).message);
}

export function hideError(): void {
  byId('error', HTMLElement).hidden = true;
}
