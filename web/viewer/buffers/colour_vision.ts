// SPDX-License-Identifier: MIT
//
// Colours: as CSS has them, in linear RGB, and how different two look, to all readers.

type Triple = readonly [number, number, number];
type Matrix = readonly [Triple, Triple, Triple];

/**
 * Matrices from a colour to the one that a reader sees, in linear RGB: with full colour vision,
 * with protanopia, deuteranopia and tritanopia (Machado, Oliveira, Fernandes. A
 * Physiologically-based Model for Simulation of Color Vision Deficiency. 2009).
 */
const visions: readonly Matrix[] = [
  [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
  [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
  [
    [1.255528, -0.076749, -0.178779],
    [-0.078411, 0.930809, 0.147602],
    [0.004733, 0.691367, 0.3039],
  ],
];

/** Lightness counts less than hue and chroma: shading changes it. */
const lightnessWeight = 0.6;

/**
 * The distance in Oklab (Ottosson 2020) of two sRGB colours for the reader who distinguishes them
 * least. Two colours side by side can be distinguished from about 0.02 on.
 */
export function leastDistance(a: number, b: number): number {
  const [first, second] = [linear(a), linear(b)];
  return visions.reduce((least, vision) => {
    const [p, q] = [oklab(times(vision, first)), oklab(times(vision, second))];
    const distance = Math.hypot(lightnessWeight * (p[0] - q[0]), p[1] - q[1], p[2] - q[2]);
    return Math.min(least, distance);
  }, Infinity);
}

/** Linear RGB, 0 … 1, of an sRGB colour. */
export function linear(srgb: number): Triple {
  const channel = (shift: number) => {
    const value = ((srgb >> shift) & 0xff) / 255;
    return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  };
  return [channel(16), channel(8), channel(0)];
}

/** An sRGB colour as CSS has it. */
export function css(srgb: number): string {
  return `#${srgb.toString(16).padStart(6, '0')}`;
}

function times(matrix: Matrix, [r, g, b]: Triple): Triple {
  const row = ([x, y, z]: Triple) => Math.max(0, x * r + y * g + z * b);
  return [row(matrix[0]), row(matrix[1]), row(matrix[2])];
}

function oklab([r, g, b]: Triple): Triple {
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}
