// SPDX-License-Identifier: MIT
//
// The controls on a phone: a sheet at the bottom.

import { byId, onClick } from '../base/dom.js';

/** A press that moves farther than this, in CSS pixels, is a swipe. */
const swipeDistance = 24;

/**
 * On a phone the controls are a sheet at the bottom: a tap on its grip or a swipe opens and closes
 * it.
 */
export function setUpSheet(): void {
  const panel = byId('panel', HTMLElement);
  const isSheet = () => getComputedStyle(grip).display !== 'none';
  const show = (open: boolean) => {
    panel.hidden = !open;
    grip.ariaExpanded = String(open);
  };
  const grip = onClick('sheet', () => show(panel.hidden === true));
  setUpSwipe([grip, byId('lead', HTMLElement)], (up) => {
    if (isSheet()) show(up);
  });
  // Beside the view, the panel has no grip to open it again.
  let wasSheet = isSheet();
  addEventListener('resize', () => {
    if (isSheet() !== wasSheet) show(wasSheet);
    wasSheet = isSheet();
  });
  show(!wasSheet);
}

/** Calls back when a press on one of the elements moves up or down, and suppresses its click. */
function setUpSwipe(elements: readonly HTMLElement[], swiped: (up: boolean) => void): void {
  let isSwipe = false;
  for (const element of elements) {
    element.addEventListener('pointerdown', ({ clientY: start }) => {
      isSwipe = false;
      const pressing = new AbortController();
      const { signal } = pressing;
      const follow = ({ clientY }: PointerEvent) => {
        if (Math.abs(clientY - start) < swipeDistance) return;
        isSwipe = true;
        pressing.abort();
        swiped(clientY < start);
      };
      // The pointer may leave what it began on.
      addEventListener('pointermove', follow, { signal });
      for (const end of ['pointerup', 'pointercancel']) {
        addEventListener(end, () => pressing.abort(), { signal });
      }
    });
    element.addEventListener(
      'click',
      (event) => {
        // A click by the keyboard has no detail.
        if (isSwipe && event.detail > 0) event.stopImmediatePropagation();
        isSwipe = false;
      },
      { capture: true },
    );
  }
}
