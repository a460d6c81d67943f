// SPDX-License-Identifier: MIT
//
// The colours of what is drawn besides the regions, on light pages and on dark ones.

export interface Theme {
  /** Bisectors, outlines and the middle of markers. */
  readonly ink: number;
  /** The rim of markers. */
  readonly paper: number;
  /** The selected site, the dual, paths and the brush. */
  readonly accent: number;
  /** The factor for the colours of regions, so that lines stand out. */
  readonly surfaceShade: number;
}

export const lightTheme: Theme = {
  ink: 0x1b2430,
  paper: 0xffffff,
  accent: 0xd6336c,
  surfaceShade: 1,
};

export const darkTheme: Theme = {
  ink: 0xf6f8fb,
  paper: 0x12161c,
  accent: 0xff8ab8,
  surfaceShade: 0.52,
};

const darkPages = '(prefers-color-scheme: dark)';

/** The theme of a part of a page, by its `color-scheme`: dark only where that allows it. */
export function themeOf(host: Element): Theme {
  const schemes = getComputedStyle(host).colorScheme.split(' ');
  if (!schemes.includes('dark')) return lightTheme;
  const isDark = !schemes.includes('light') || matchMedia(darkPages).matches;
  return isDark ? darkTheme : lightTheme;
}

/** Calls back when the reader's preference changes, until the signal ends it. */
export function watchTheme(changed: () => void, signal: AbortSignal): void {
  matchMedia(darkPages).addEventListener('change', changed, { signal });
}
