// SPDX-License-Identifier: MIT
//
// The focus of the keyboard: it goes on to a neighbour when its button is disabled or disappears.

import type { GeodesicVoronoiElement } from '../../viewer/element.js';

/** What a neighbour is looked for in, from the inside out. */
const groups = '#toolbar, .row, details, aside';
/** The buttons that bring hidden controls back. */
const ofPanel = '#hide-panel, #sheet';

/** Without this, the next key would go to the whole page, and Tab would begin anew. */
export function keepFocus(viewer: GeodesicVoronoiElement): void {
  // Called before the browser takes the focus away, which it does when it draws.
  new MutationObserver(() => {
    const { activeElement } = document;
    if (!(activeElement instanceof HTMLElement) || canHaveFocus(activeElement)) return;
    const next = neighbourOf(activeElement) ?? viewer.shadowRoot?.querySelector('canvas');
    next?.focus();
  }).observe(document.body, { subtree: true, attributeFilter: ['disabled', 'hidden', 'class'] });
}

function canHaveFocus(element: HTMLElement): boolean {
  return element.checkVisibility() && !element.matches(':disabled');
}

/** The nearest before it that can have the focus, else after it, in the innermost group that has one. */
function neighbourOf(element: HTMLElement): HTMLElement | undefined {
  const among = (root: ParentNode, selector: string) =>
    [...root.querySelectorAll<HTMLElement>(selector)].filter(
      (each) => each === element || canHaveFocus(each),
    );
  for (
    let group = element.closest(groups);
    group;
    group = group.parentElement?.closest(groups) ?? null
  ) {
    const buttons = among(group, 'button, summary');
    const at = buttons.indexOf(element);
    const next = buttons[at - 1] ?? buttons[at + 1];
    if (next) return next;
  }
  return element.closest('aside') ? among(document, ofPanel)[0] : undefined;
}
