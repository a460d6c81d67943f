// SPDX-License-Identifier: MIT
//
// The colours of labels, as vertex attributes hold them.

import { css, linear } from './colour_vision.js';
import { dropped, unreachable } from './face_label.js';
import { toneColour } from './region_colours.js';

/** Faces without a region: dropped by the mesh builder, or before the first diagram. */
const neutralColour = 0xd9d6d0;
/** Faces that no site reaches. */
const unreachableColour = 0x9a9ca1;
/** The colours for the greatest and the least painted density. */
const denseColour = 0x560068;
const sparseColour = 0xffffff;
/** The opacity of these colours. */
const tintOpacity = 0.95;
/** The colour towards which regions fade under a density, so that its own colours stand out. */
const greyColour = 0xb4b4b4;
/** How far they fade, 0 … 1. */
const paleness = 0.7;

/** As CSS has them, over grey: the colours of a legend, from the least density to the greatest. */
export const tintColours = [-1, -0.75, -0.5, -0.25, 0, 0.25, 0.5, 0.75, 1].map((tint) => {
  const share = `${Math.round(100 * tintShare(tint))}%`;
  return `color-mix(in srgb-linear, ${css(tint < 0 ? sparseColour : denseColour)} ${share}, ${css(greyColour)})`;
});

/** Faces without one region have labels too. */
const lowestLabel = dropped;

/** Linear RGB, a byte per channel. */
export class LabelColours {
  /** Three bytes per label, from the lowest on: a table, since every face of a diagram needs it. */
  readonly #table: Uint8Array;
  readonly #dense = linearBytes(denseColour);
  readonly #sparse = linearBytes(sparseColour);
  readonly #grey = linearBytes(greyColour);

  /** Takes a tone per label; faces without a region are neutral. */
  constructor(tones: Uint16Array = new Uint16Array()) {
    this.#table = new Uint8Array(3 * (tones.length - lowestLabel));
    const ofTone: Uint8Array[] = [];
    const neutral = linearBytes(neutralColour);
    for (let label = lowestLabel; label < 0; ++label) this.#table.set(neutral, at(label));
    this.#table.set(linearBytes(unreachableColour), at(unreachable));
    tones.forEach((tone, label) => {
      this.#table.set((ofTone[tone] ??= linearBytes(toneColour(tone))), at(label));
    });
  }

  /** Writes a label's colour to `target[at…]`. */
  write(label: number, target: { [i: number]: number }, to: number): void {
    const from = at(label);
    target[to] = this.#table[from];
    target[to + 1] = this.#table[from + 1];
    target[to + 2] = this.#table[from + 2];
  }

  /** Writes a label's colour, faded, with a tint, -1 … 1, over it. */
  writeTinted(label: number, tint: number, target: { [i: number]: number }, to: number): void {
    const from = at(label);
    const over = tint < 0 ? this.#sparse : this.#dense;
    const share = tintShare(tint);
    for (let k = 0; k < 3; ++k) {
      const own = this.#table[from + k];
      const pale = own + paleness * (this.#grey[k] - own);
      target[to + k] = pale + share * (over[k] - pale);
    }
  }
}

/** The share of a density's colour: a root, so that a slight density is seen, too. */
function tintShare(tint: number): number {
  return tintOpacity * Math.sqrt(Math.abs(tint));
}

function at(label: number): number {
  return 3 * (label - lowestLabel);
}

function linearBytes(srgb: number): Uint8Array {
  return Uint8Array.from(linear(srgb), (channel) => Math.round(255 * channel));
}
