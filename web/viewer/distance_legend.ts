// SPDX-License-Identifier: MIT
//
// The scale of distances on the view: it tells what the colours mean.

import { distanceColours } from './distance_surface.js';

/** In the model's units. */
export interface DistanceRange {
  longest: number;
  /** Between two isolines. */
  step: number;
}

/** Isolines at round numbers, about a dozen of them. */
export function distanceRange(longest: number): DistanceRange {
  const rough = longest / 12 || 1;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((n) => n * power).find((each) => each >= rough) ?? rough;
  return { longest, step };
}

const style = `
  .distances {
    position: absolute; inset: auto 16px 16px auto; width: 230px; padding: 9px 12px;
    font: 12px/1.4 system-ui, sans-serif; color: CanvasText; pointer-events: none;
    background: color-mix(in srgb, Canvas 88%, transparent); border-radius: 10px;
  }
  .distances[hidden] { display: none; }
  .scale { height: 10px; border-radius: 3px; }
  .ends { display: flex; justify-content: space-between; font-variant-numeric: tabular-nums; }
`;

export class DistanceLegend {
  readonly #box = document.createElement('div');
  readonly #sheet = new CSSStyleSheet();
  readonly #shadow: ShadowRoot;

  /** Takes a shadow root that already has its content. */
  constructor(shadow: ShadowRoot) {
    this.#shadow = shadow;
    this.#sheet.replaceSync(style);
    shadow.adoptedStyleSheets = [...shadow.adoptedStyleSheets, this.#sheet];
    this.#box.className = 'distances';
    this.#box.setAttribute('part', 'distances');
    this.#box.hidden = true;
    shadow.append(this.#box);
  }

  dispose(): void {
    this.#box.remove();
    const sheets = this.#shadow.adoptedStyleSheets;
    this.#shadow.adoptedStyleSheets = sheets.filter((sheet) => sheet !== this.#sheet);
  }

  /** Undefined if no distances are shown. */
  show(range: DistanceRange | undefined): void {
    this.#box.hidden = range === undefined;
    if (!range) return;
    const { longest, step } = range;
    const bar = document.createElement('div');
    bar.className = 'scale';
    bar.style.background = `linear-gradient(to right, ${distanceColours.join(', ')})`;
    const ends = document.createElement('div');
    ends.className = 'ends';
    for (const value of [0, longest]) {
      const end = document.createElement('span');
      end.textContent = numeral(value);
      ends.append(end);
    }
    const caption = document.createElement('div');
    caption.textContent = `Distance to the nearest site, in the model's units; a line every ${numeral(step)}`;
    this.#box.replaceChildren(bar, ends, caption);
  }
}

function numeral(value: number): string {
  return Number(value.toPrecision(3)).toLocaleString('en', { maximumSignificantDigits: 3 });
}
