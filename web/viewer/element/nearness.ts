// SPDX-License-Identifier: MIT
//
// Watches whether an element is near the visible part of the page.

/** How far out of view an element counts as near, as a share of the view. */
const margin = '25%';

const listeners = new Map<Element, (isNear: boolean) => void>();
let observer: IntersectionObserver | undefined;

/** Calls back when an element comes near the view or leaves it; returns a function to stop that. */
export function watchNearness(element: Element, changed: (isNear: boolean) => void): () => void {
  observer ??= new IntersectionObserver(
    (entries) => {
      for (const { target, isIntersecting } of entries) listeners.get(target)?.(isIntersecting);
    },
    { rootMargin: margin },
  );
  listeners.set(element, changed);
  observer.observe(element);
  return () => {
    listeners.delete(element);
    observer?.unobserve(element);
  };
}
