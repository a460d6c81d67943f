// SPDX-License-Identifier: MIT
//
// The colours of labels, as vertex attributes hold them.

import { linear } from './colour_vision.js';
import { toneColour } from './region_colours.js';

/** Faces without a region: those the mesh builder dropped, and all before the first diagram. */
const neutralColour = 0xd9d6d0;
/** Faces that no site reaches. */
const unreachableColour = 0x9a9ca1;
/** Where the painted density is greatest and least. */
const denseColour = 0x4a1942;
const sparseColour = 0xffffff;
const tintOpacity = 0.75;

/** The label of what no site reaches. */
const unreachable = -1;

/** Linear RGB, a byte per channel. */
export class LabelColours {
  readonly #ofTone: Uint8Array[] = [];
  readonly #tones: Uint16Array | undefined;
  readonly #neutral = linearBytes(neutralColour);
  readonly #unreachable = linearBytes(unreachableColour);
  readonly #dense = linearBytes(denseColour);
  readonly #sparse = linearBytes(sparseColour);

  /** By the tones of labels; without, all is neutral. */
  constructor(tones: Uint16Array | undefined) {
    this.#tones = tones;
  }

  /** Writes a label's colour to `target[at…]`, with a tint, -1 … 1, over it. */
  write(label: number, tint: number, target: { [i: number]: number }, at: number): void {
    const bytes = this.of(label);
    if (tint === 0) {
      for (let k = 0; k < 3; ++k) target[at + k] = bytes[k];
      return;
    }
    const over = tint < 0 ? this.#sparse : this.#dense;
    const share = tintOpacity * Math.abs(tint);
    for (let k = 0; k < 3; ++k) target[at + k] = bytes[k] + share * (over[k] - bytes[k]);
  }

  of(label: number): Uint8Array {
    if (label === unreachable) return this.#unreachable;
    if (label < 0 || !this.#tones) return this.#neutral;
    const tone = this.#tones[label];
    return (this.#ofTone[tone] ??= linearBytes(toneColour(tone)));
  }
}

function linearBytes(srgb: number): Uint8Array {
  return Uint8Array.from(linear(srgb), (channel) => Math.round(255 * channel));
}
