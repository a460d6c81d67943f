// SPDX-License-Identifier: MIT
//
// The colours of labels, as vertex attributes hold them.

import { linear } from './colour_vision.js';
import { toneColour } from './region_colours.js';

/** Faces without a region: dropped by the mesh builder, or before the first diagram. */
const neutralColour = 0xd9d6d0;
/** Faces that no site reaches. */
const unreachableColour = 0x9a9ca1;
/** The colours for the greatest and the least painted density. */
const denseColour = 0x4a1942;
const sparseColour = 0xffffff;
const tintOpacity = 0.75;

/** What a legend has instead of a region, about as bright as one. */
const greyColour = 0xa6a6a6;
/** As CSS has them: the least painted density, none, and the greatest, over grey. */
export const tintColours = [sparseColour, greyColour, denseColour].map(
  (colour) => `color-mix(in srgb-linear, ${css(colour)} ${100 * tintOpacity}%, ${css(greyColour)})`,
);

/** The label of what no site reaches. */
const unreachable = -1;
/** The lowest label that `DiagramData.faceLabel` has for faces without one region. */
const lowestLabel = -3;

/** Linear RGB, a byte per channel. */
export class LabelColours {
  /** Three bytes per label, from the lowest on: a table, since every face of a diagram needs it. */
  readonly #table: Uint8Array;
  readonly #dense = linearBytes(denseColour);
  readonly #sparse = linearBytes(sparseColour);

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

  /** Writes a label's colour with a tint, -1 … 1, over it. */
  writeTinted(label: number, tint: number, target: { [i: number]: number }, to: number): void {
    this.write(label, target, to);
    const over = tint < 0 ? this.#sparse : this.#dense;
    const share = tintOpacity * Math.abs(tint);
    for (let k = 0; k < 3; ++k) target[to + k] += share * (over[k] - target[to + k]);
  }
}

function css(srgb: number): string {
  return `#${srgb.toString(16).padStart(6, '0')}`;
}

function at(label: number): number {
  return 3 * (label - lowestLabel);
}

function linearBytes(srgb: number): Uint8Array {
  return Uint8Array.from(linear(srgb), (channel) => Math.round(255 * channel));
}
