// SPDX-License-Identifier: MIT
import { byId, onClick } from './dom.js';

/** On a phone the controls are a sheet at the bottom, which a button opens and closes. */
export function setUpSheet(): void {
  const panel = byId('panel', HTMLElement);
  const button = onClick('sheet', () => show(panel.hidden === true));
  const show = (open: boolean) => {
    panel.hidden = !open;
    button.setAttribute('aria-expanded', String(open));
  };
  // Beside the view there is no button to open it again.
  matchMedia('(max-width: 760px)').addEventListener('change', () => show(true));
}
