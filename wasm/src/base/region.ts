// SPDX-License-Identifier: MIT
//
// A region of a diagram as callers see it.

import { listAt } from './lists.js';
import type { DiagramData } from '../api/results.js';
import type { Region } from '../api/types.js';

/** Its properties are its own, so that `{ ...region }` has them, and so has a message to a worker. */
class DataRegion implements Region {
  readonly label: number;
  readonly area: number;
  readonly neighbours: number[];
  readonly loops: Int32Array[];

  constructor({ label, area, neighbours, loops }: Region) {
    this.label = label;
    this.area = area;
    this.neighbours = neighbours;
    this.loops = loops;
  }

  toJSON(): Record<keyof Region, unknown> {
    return { ...this, loops: this.loops.map((loop) => [...loop]) };
  }
}

/** A region per site. Their loops are views of the diagram's arrays. */
export function regionsOf({ regionArea, arcs, loops }: DiagramData): Region[] {
  const neighbours = Array.from(regionArea, (): number[] => []);
  for (let i = 0; i < arcs.labels.length; i += 2) {
    const left = arcs.labels[i];
    const right = arcs.labels[i + 1];
    neighbours[left].push(right);
    neighbours[right].push(left);
  }
  const outlines = Array.from(regionArea, (): Int32Array[] => []);
  loops.label.forEach((label, i) => outlines[label].push(listAt(loops, i)));
  return Array.from(regionArea, (area, label) => {
    const sorted = neighbours[label].sort((a, b) => a - b);
    const others = sorted.filter((other, i) => other !== sorted[i - 1]);
    return new DataRegion({ label, area, neighbours: others, loops: outlines[label] });
  });
}
