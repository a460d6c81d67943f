// SPDX-License-Identifier: MIT
//
// What the colours and isolines of distances mean: the surface is drawn by it, the legend tells it.

/** sRGB, from the sites to the farthest point: ever darker, so that every reader sees the order. */
export const distanceColours = ['#fff4d6', '#f6c274', '#e27a72', '#9c4f96', '#44357f', '#171b45'];

export interface DistanceScale {
  /** The distance that has the last colour. */
  longest: number;
  /** Between two isolines. */
  step: number;
}

/** Isolines at round numbers, about a dozen of them. */
export function distanceScale(longest: number): DistanceScale {
  const rough = longest / 12 || 1;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((n) => n * power).find((each) => each >= rough) ?? rough;
  return { longest, step };
}
