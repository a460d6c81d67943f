// SPDX-License-Identifier: MIT
//
// The menu that gives a link and code.

import type { GeodesicVoronoiElement } from '../../viewer/element.js';
import { codeOf, type Origin, watchOrigin } from './code_forms.js';
import { byId, onClick } from '../base/dom.js';
import { isSample, sampleAddress } from '../samples/first_model.js';
import { modelName, notHeld, pageState } from '../state/page_state.js';

/** A link that brings this diagram back, and code that makes it. */
export function setUpShare(viewer: GeodesicVoronoiElement): void {
  const menu = byId('share', HTMLElement);
  const note = byId('share-note', HTMLElement);
  const link = byId('share-link', HTMLInputElement);
  const code = byId('code', HTMLElement);
  const originOf = watchOrigin(viewer);
  /** Ends when the menu is closed. */
  let opened = new AbortController();
  /** How the sites were made, found out once each time that the menu is opened. */
  let origin: Promise<Origin> | undefined;

  const showLink = () => {
    const address = new URL(location.href);
    address.hash = pageState(viewer);
    link.value = address.href;
    const lacking = notHeld(viewer);
    note.textContent =
      lacking.join(' ') || 'Whoever opens the link sees this model, these sites and this view.';
  };
  const showCode = async () => {
    const { signal } = opened;
    const name = modelName(viewer);
    const address = isSample(name) ? new URL(sampleAddress(name), location.href).href : undefined;
    const known = await origin;
    if (!known || signal.aborted) return;
    code.textContent = viewer.diagram
      ? codeOf(viewer, { name, address }, known, chosen())
      : 'Without a site there is no diagram.';
    copyCode.disabled = !viewer.diagram;
  };
  const chosen = () =>
    menu.querySelector<HTMLInputElement>('input[name="code"]:checked')?.value ?? 'script';
  menu.addEventListener('beforetoggle', ({ newState }) => {
    opened.abort();
    if (newState !== 'open') return;
    opened = new AbortController();
    showLink();
    code.textContent = '';
    copyCode.disabled = true;
    origin = originOf(opened.signal);
    void showCode();
  });
  for (const radio of menu.querySelectorAll('input[name="code"]')) {
    radio.addEventListener('change', () => void showCode());
  }
  copyOnClick('copy-link', () => link.value);
  const copyCode = copyOnClick('copy-code', () => code.textContent ?? '');
}

function copyOnClick(id: string, text: () => string): HTMLButtonElement {
  const button = onClick(id, async () => {
    try {
      await navigator.clipboard.writeText(text());
      button.textContent = 'Copied';
    } catch {
      button.textContent = 'Not allowed here';
    }
    setTimeout(() => {
      button.textContent = title;
    }, 1500);
  });
  const title = button.textContent;
  return button;
}
