// SPDX-License-Identifier: MIT
//
// Waiting for the page to draw.

/** In milliseconds, after which work goes on although the page has drawn nothing. */
const longestFrame = 100;
/** In milliseconds: with the drawing after it, a slice fits into one of 60 frames per second. */
const longestSlice = 12;

/**
 * Lets the page draw and answer. If it draws nothing for a while, because it is hidden or the
 * graphics card is slow, the work goes on all the same.
 */
export function nextFrame(): Promise<void> {
  return new Promise((resolve) => {
    setTimeout(resolve, document.hidden ? 0 : longestFrame);
    requestAnimationFrame(() => resolve());
  });
}

/** Long work in slices, between which the page draws and answers. */
export class Slices {
  #end = performance.now() + longestSlice;

  /** Whether the present slice has been long enough. */
  get isDue(): boolean {
    return performance.now() >= this.#end;
  }

  async next(): Promise<void> {
    await nextFrame();
    this.#end = performance.now() + longestSlice;
  }
}
