// SPDX-License-Identifier: MIT
//
// Watches whether an element is near the visible part of the page.

/** How far out of view an element counts as near, as a share of the view. */
const margin = '25%';

/** Calls back when an element comes near the view or leaves it; returns a function to stop that. */
export function watchNearness(element: Element, changed: (isNear: boolean) => void): () => void {
  const observer = new IntersectionObserver(
    (entries) => {
      for (const { isIntersecting } of entries) changed(isIntersecting);
    },
    { rootMargin: margin },
  );
  observer.observe(element);
  return () => observer.disconnect();
}
