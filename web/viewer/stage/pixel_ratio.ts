// SPDX-License-Identifier: MIT
//
// Notices that the page is zoomed, or has moved to another screen.

/** Calls back when a CSS pixel is another number of device pixels, until the signal ends it. */
export function watchPixelRatio(changed: () => void, signal: AbortSignal): void {
  const follow = () => {
    changed();
    watchPixelRatio(changed, signal);
  };
  const present = matchMedia(`(resolution: ${devicePixelRatio}dppx)`);
  present.addEventListener('change', follow, { once: true, signal });
}
