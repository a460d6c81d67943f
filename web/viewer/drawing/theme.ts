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

const darkTheme: Theme = {
  ink: 0xf6f8fb,
  paper: 0x12161c,
  accent: 0xff8ab8,
  surfaceShade: 0.52,
};

const darkPages = '(prefers-color-scheme: dark)';

/**
 * The theme of a part of a page, by an element there whose colour is the system's of text: light text
 * is on a dark page. So `color-scheme` counts, in styles and in a `<meta>` of the page.
 */
export function themeOf(element: Element): Theme {
  const [red] = /\d+/.exec(getComputedStyle(element).color) ?? ['0'];
  return Number(red) > 127 ? darkTheme : lightTheme;
}

/**
 * Calls back when the theme may be another, until the signal ends it: when the reader's preference
 * changes, and the attributes of the page's root or body, by which pages switch between themes.
 */
export function watchTheme(changed: () => void, signal: AbortSignal): void {
  matchMedia(darkPages).addEventListener('change', changed, { signal });
  const observer = new MutationObserver(changed);
  for (const element of [document.documentElement, document.body])
    observer.observe(element, { attributes: true });
  signal.addEventListener('abort', () => observer.disconnect());
}
