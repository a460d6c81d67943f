// SPDX-License-Identifier: MIT
//
// What an element follows in its page, until a signal ends it.

/** How far out of view an element counts as near, as a share of the view. */
const margin = '25%';

/** Calls back when an element comes near the visible part of the page or leaves it. */
export function watchNearness(
  element: Element,
  changed: (isNear: boolean) => void,
  signal: AbortSignal,
): void {
  const observer = new IntersectionObserver(
    (entries) => {
      for (const { isIntersecting } of entries) changed(isIntersecting);
    },
    { rootMargin: margin },
  );
  observer.observe(element);
  signal.addEventListener('abort', () => observer.disconnect());
}

/** Calls back when a CSS pixel is another number of device pixels: by zoom, on another screen. */
export function watchPixelRatio(changed: () => void, signal: AbortSignal): void {
  const follow = () => {
    changed();
    watchPixelRatio(changed, signal);
  };
  const present = matchMedia(`(resolution: ${devicePixelRatio}dppx)`);
  present.addEventListener('change', follow, { once: true, signal });
}
