// SPDX-License-Identifier: MIT
//
// A small drawing of the energy by iteration. Its axis is logarithmic: with a painted density,
// energies begin far above their end, where the important differences are small.

import { counted } from '../base/numbers.js';

const svg = 'http://www.w3.org/2000/svg';

/** In units of the drawing, which is as wide as the panel. */
const width = 284;
const height = 104;
const plot = { left: 42, right: width - 6, top: 20, bottom: height - 20 };

/** The least distance of two numbers on the axis of energies: about the height of their text. */
const tickDistance = 12;

/** Round numbers for that axis, by their importance. */
const roundNumbers = [10, 100, 1000, 2, 5, 1.5, 3, 1.2];

/** The least width of the axis, in iterations: with fewer, the line would be too steep to read. */
const fewestIterations = 10;

/** The curve of energies, in multiples of that of regular hexagons in the plane. */
export class EnergyCurve {
  readonly #drawing: SVGElement;
  readonly #energies: number[] = [];

  constructor(parent: HTMLElement) {
    this.#drawing = make('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img' });
    parent.append(this.#drawing);
    this.#draw();
  }

  add(energy: number): void {
    this.#energies.push(energy);
    this.#draw();
  }

  clear(): void {
    this.#energies.length = 0;
    this.#draw();
  }

  #draw(): void {
    const energies = this.#energies;
    const last = energies.length - 1;
    this.#drawing.setAttribute('aria-label', descriptionOf(energies));
    const lastIteration = Math.max(last, fewestIterations);
    const lowest = Math.min(1, ...energies.slice(-1));
    const greatest = Math.max(1, ...energies.slice(0, 1));
    const highest = greatest > lowest ? greatest : lowest + 1;
    const x = (i: number) => plot.left + ((plot.right - plot.left) * i) / lastIteration;
    const scale = (plot.top - plot.bottom) / Math.log(highest / lowest);
    const y = (energy: number) => plot.bottom + scale * Math.log(energy / lowest);

    const parts = [
      line('axis', plot.left, plot.bottom, plot.right, plot.bottom),
      line('axis', plot.left, plot.top, plot.left, plot.bottom),
      text('start', plot.left, plot.bottom + 14, '0'),
      text('start', plot.left, plot.top - 9, 'energy (log)'),
    ];
    const middle = (plot.left + plot.right) / 2;
    if (last < 0) {
      parts.push(text('middle', middle, 0.6 * plot.bottom, 'falls as regions become even'));
    } else {
      parts.push(
        text('end', plot.right, plot.bottom + 14, `${lastIteration} iterations`),
        line('hexagons', plot.left, y(1), plot.right, y(1)),
        ...apart([1, highest, ...roundNumbers.filter((tick) => tick < highest)], y).map((tick) =>
          text('end', plot.left - 6, y(tick) + 4, String(Number(tick.toPrecision(3)))),
        ),
        make('polyline', { points: energies.map((e, i) => `${x(i)},${y(e)}`).join(' ') }),
        make('circle', { cx: x(last), cy: y(energies[last]), r: 3 }),
      );
    }
    this.#drawing.replaceChildren(...parts);
  }
}

/** The ticks without those that are too near to one before them in the list to be read. */
function apart(ticks: readonly number[], y: (tick: number) => number): number[] {
  const kept: number[] = [];
  for (const tick of ticks)
    if (kept.every((other) => Math.abs(y(other) - y(tick)) >= tickDistance)) kept.push(tick);
  return kept;
}

function descriptionOf(energies: readonly number[]): string {
  if (energies.length === 0) return 'Energy by iteration: none yet';
  const from = energies[0].toFixed(3);
  const to = energies[energies.length - 1].toFixed(3);
  return `Energy after ${counted(energies.length - 1, 'iteration')}, as a multiple of that of hexagons: from ${from} to ${to}`;
}

function line(className: string, x1: number, y1: number, x2: number, y2: number): SVGElement {
  return make('line', { class: className, x1, y1, x2, y2 });
}

function text(
  anchor: 'start' | 'middle' | 'end',
  x: number,
  y: number,
  content: string,
): SVGElement {
  const element = make('text', { x, y, 'text-anchor': anchor });
  element.textContent = content;
  return element;
}

function make(tag: string, attributes: Record<string, string | number>): SVGElement {
  const element = document.createElementNS(svg, tag) as SVGElement;
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  return element;
}
