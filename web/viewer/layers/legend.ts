// SPDX-License-Identifier: MIT
//
// The legend on the view: it tells what the colours of distances or of a density mean.

import { greatestDensity } from '../model/density_paint.js';
import { type DistanceScale, distanceColours } from '../drawing/distance_scale.js';
import { tintColours } from '../buffers/label_colours.js';
import { measure } from './measure.js';
import { english, make } from '../stage/make.js';

/** Part of the style sheet of the element. */
export const legendStyle = `
  .legend {
    position: absolute; inset: auto 16px 16px auto; width: 230px; padding: 9px 12px;
    font: 12px/1.4 system-ui, sans-serif; color: CanvasText; pointer-events: none;
    background: color-mix(in srgb, Canvas 88%, transparent); border-radius: 10px;
  }
  /* The exploded view has the colours of regions; distances and the file's own material cover the density. */
  .legend[hidden],
  :host([exploded]:not([exploded='0'])) .legend,
  :host(:is([layers~='distances'], [layers~='original'])) .density { display: none; }
  .scale { height: 10px; border-radius: 3px; forced-color-adjust: none; }
  .ends { display: flex; justify-content: space-between; }
  @container (max-width: 1000px) or (max-height: 400px) {
    .legend { width: 160px; padding: 5px 8px; font-size: 11px; }
    .legend .detail { display: none; }
  }
  @container (max-width: 340px) {
    .legend { inset: auto 8px 8px auto; width: 90px; padding: 4px 6px; }
    .legend .caption { display: none; }
  }
`;

export class Legend {
  readonly #distances = box('distances');
  readonly #density = box('density');

  /** Takes a shadow root that already has its content. */
  constructor(shadow: ShadowRoot) {
    fill(this.#density, {
      colours: tintColours,
      marks: [`1/${greatestDensity}`, '1', String(greatestDensity)],
      caption: [
        'Density: where it is large, regions become smaller',
        ' when sites are placed at random or evened out',
      ],
    });
    shadow.append(this.#distances, this.#density);
  }

  /** Takes a scale in the model's units; undefined if no distances are shown. */
  showDistances(scale: DistanceScale | undefined): void {
    this.#distances.hidden = scale === undefined;
    if (!scale) return;
    fill(this.#distances, {
      colours: distanceColours,
      marks: [measure(0), measure(scale.longest)],
      caption: [
        'Distance to the nearest site',
        ", in the model's units",
        `; a line every ${measure(scale.step)}`,
      ],
    });
  }

  showDensity(isShown: boolean): void {
    this.#density.hidden = !isShown;
  }
}

function box(name: string): HTMLElement {
  const element = make('div', { className: `legend ${name}`, hidden: true, ...english });
  element.setAttribute('part', name);
  return element;
}

interface Scale {
  colours: readonly string[];
  /** Numbers from the first colour to the last. */
  marks: readonly string[];
  /** In parts: small views leave out the second one. */
  caption: readonly string[];
}

function fill(element: HTMLElement, { colours, marks, caption }: Scale): void {
  const bar = make('div', { className: 'scale' });
  bar.style.background = `linear-gradient(to right, ${colours.join(', ')})`;
  const spans = (texts: readonly string[]) => texts.map((text) => make('span', {}, text));
  const text = make('div', { className: 'caption' }, ...spans(caption));
  text.children[1].className = 'detail';
  element.replaceChildren(bar, make('div', { className: 'ends' }, ...spans(marks)), text);
}
