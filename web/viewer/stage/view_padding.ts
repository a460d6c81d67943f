// SPDX-License-Identifier: MIT
//
// The CSS padding of an element that holds a view. The view takes the whole element, but the framed
// model keeps clear of the padding, where a page may lay buttons and sentences.

/** In CSS pixels. */
export interface Padding {
  top: number;
  right: number;
  bottom: number;
  left: number;
}

/** The padding of the element in whose shadow the canvas is. */
export function paddingAround(canvas: HTMLCanvasElement): Padding {
  const style = getComputedStyle((canvas.getRootNode() as ShadowRoot).host);
  return {
    top: parseFloat(style.paddingTop),
    right: parseFloat(style.paddingRight),
    bottom: parseFloat(style.paddingBottom),
    left: parseFloat(style.paddingLeft),
  };
}
