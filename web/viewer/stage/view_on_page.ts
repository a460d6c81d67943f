// SPDX-License-Identifier: MIT
//
// Where the view is on the page: CSS may move, scale, turn and skew it.

import { make } from './make.js';

/** Elements without extent at three corners of the view, which browsers tell the places of. */
export class ViewOnPage {
  readonly #corners: HTMLElement[];

  constructor(canvas: HTMLCanvasElement) {
    this.#corners = ['0 auto auto 0', '0 0 auto auto', 'auto auto 0 0'].map((inset) => {
      const corner = make('span', {});
      Object.assign(corner.style, { position: 'absolute', inset });
      return corner;
    });
    canvas.before(...this.#corners);
  }

  /** From device coordinates (-1 … 1) to places on the page. */
  get toPage(): DOMMatrix {
    const [topLeft, topRight, bottomLeft] = this.#corners.map((corner) =>
      corner.getBoundingClientRect(),
    );
    return new DOMMatrix([
      (topRight.x - topLeft.x) / 2,
      (topRight.y - topLeft.y) / 2,
      (topLeft.x - bottomLeft.x) / 2,
      (topLeft.y - bottomLeft.y) / 2,
      (topRight.x + bottomLeft.x) / 2,
      (topRight.y + bottomLeft.y) / 2,
    ]);
  }
}
