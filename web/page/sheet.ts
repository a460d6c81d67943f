// SPDX-License-Identifier: MIT
import { byId, onClick } from './dom.js';

/** A press that moves farther than this, in CSS pixels, is a swipe. */
const swipeDistance = 24;

/** On a phone the controls are a sheet at the bottom: a tap on its grip or a swipe opens and closes it. */
export function setUpSheet(): void {
  const panel = byId('panel', HTMLElement);
  const narrow = matchMedia('(max-width: 760px)');
  const show = (open: boolean) => {
    panel.hidden = !open;
    grip.ariaExpanded = String(open);
  };
  const grip = onClick('sheet', () => show(panel.hidden === true));
  setUpSwipe([grip, byId('lead', HTMLElement)], (up) => {
    if (narrow.matches) show(up);
  });
  // Beside the view there is no grip to open it again.
  narrow.addEventListener('change', () => show(!narrow.matches));
  show(!narrow.matches);
}

/** Calls back when a finger has gone up or down over one of these. */
function setUpSwipe(elements: readonly HTMLElement[], swiped: (up: boolean) => void): void {
  for (const element of elements) {
    let start: number | undefined;
    element.addEventListener('pointerdown', ({ clientY }) => {
      start = clientY;
    });
    element.addEventListener('pointerup', ({ clientY }) => {
      const distance = clientY - (start ?? clientY);
      start = undefined;
      if (Math.abs(distance) < swipeDistance) return;
      swiped(distance < 0);
      // It ends on what it began on, which is no click then.
      element.addEventListener('click', (event) => event.stopImmediatePropagation(), {
        capture: true,
        once: true,
      });
    });
    element.addEventListener('pointercancel', () => {
      start = undefined;
    });
  }
}
