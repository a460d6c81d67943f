// SPDX-License-Identifier: MIT
//
// A region of a diagram as callers see it.
import { listAt } from './lists.js';
import { inspectSymbol, tagSymbol } from './symbols.js';
import type { DiagramData } from '../api/results.js';
import type { Region } from '../api/types.js';

/** What regions share: where each one's loops begin, and who its neighbours are. */
interface RegionIndex {
  /** Loops of region i are `loopStart[i] … loopStart[i + 1] - 1`. */
  loopStart: Int32Array;
  neighbours: number[][];
}

function indexRegions({ siteCount, loops, arcs }: DiagramData): RegionIndex {
  const loopStart = new Int32Array(siteCount + 1);
  for (const label of loops.label) ++loopStart[label + 1];
  for (let i = 0; i < siteCount; ++i) loopStart[i + 1] += loopStart[i];

  const neighbours = Array.from({ length: siteCount }, () => new Set<number>());
  for (let i = 0; i < arcs.labels.length; i += 2) {
    const [left, right] = arcs.labels.subarray(i);
    neighbours[left].add(right);
    neighbours[right].add(left);
  }
  return { loopStart, neighbours: neighbours.map((set) => [...set].sort((a, b) => a - b)) };
}

class DataRegion implements Region {
  readonly label: number;
  readonly #data: DiagramData;
  readonly #index: () => RegionIndex;

  constructor(label: number, data: DiagramData, index: () => RegionIndex) {
    this.label = label;
    this.#data = data;
    this.#index = index;
  }

  get [tagSymbol](): string {
    return 'Region';
  }

  get area(): number {
    return this.#data.regionArea[this.label];
  }

  get loops(): Int32Array[] {
    const { loopStart } = this.#index();
    const loops = [];
    for (let i = loopStart[this.label]; i < loopStart[this.label + 1]; ++i)
      loops.push(listAt(this.#data.loops, i));
    return loops;
  }

  get neighbours(): number[] {
    return [...this.#index().neighbours[this.label]];
  }

  toJSON(): Record<keyof Region, unknown> {
    const { label, area, neighbours } = this;
    return { label, area, neighbours, loops: this.loops.map((loop) => [...loop]) };
  }

  [inspectSymbol](): object {
    const { label, area, neighbours, loops } = this;
    return { label, area, neighbours, loops };
  }
}

/** A region per site, over the diagram's arrays; nothing is computed before it is asked for. */
export function regionsOf(data: DiagramData): Region[] {
  let index: RegionIndex | undefined;
  const once = () => (index ??= indexRegions(data));
  return Array.from({ length: data.siteCount }, (_, label) => new DataRegion(label, data, once));
}
