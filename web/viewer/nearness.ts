// SPDX-License-Identifier: MIT
//
// Whether an element is near what is seen of the page.

/** An element so far out of view, in shares of the view, is near. */
const margin = '25%';

const listeners = new Map<Element, (isNear: boolean) => void>();
let observer: IntersectionObserver | undefined;

/** Calls back when the element has come near the view, or has left it; returns what ends that. */
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
