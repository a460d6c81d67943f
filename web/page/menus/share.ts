// SPDX-License-Identifier: MIT
//
// The menu that gives a link and code.

import type { GeodesicVoronoiElement } from '../../viewer/element.js';
import { codeOf, watchOrigin } from './code_forms.js';
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

  const fill = () => {
    const model = modelName(viewer);
    const address = new URL(location.href);
    address.hash = pageState(viewer);
    link.value = address.href;
    const lacking = notHeld(viewer);
    note.textContent =
      lacking.join(' ') || 'Whoever opens the link sees this model, these sites and this view.';
    const itsAddress = isSample(model)
      ? new URL(sampleAddress(model), location.href).href
      : undefined;
    void originOf().then((origin) => {
      code.textContent = codeOf(viewer, { name: model, address: itsAddress }, origin, chosen());
    });
  };
  const chosen = () =>
    menu.querySelector<HTMLInputElement>('input[name="code"]:checked')?.value ?? 'script';
  menu.addEventListener('beforetoggle', (event) => {
    if ((event as ToggleEvent).newState === 'open') fill();
  });
  for (const radio of menu.querySelectorAll('input[name="code"]')) {
    radio.addEventListener('change', fill);
  }
  copyOnClick('copy-link', () => link.value);
  copyOnClick('copy-code', () => code.textContent ?? '');
}

function copyOnClick(id: string, text: () => string): void {
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
}
