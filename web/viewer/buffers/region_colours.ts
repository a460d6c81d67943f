// SPDX-License-Identifier: MIT
//
// Chooses the colours of regions.

import { leastDistance } from './colour_vision.js';

/** The part of a diagram that colouring needs: two labels per arc. */
interface Adjacency {
  readonly siteCount: number;
  readonly arcs: { readonly labels: ArrayLike<number> };
}

/**
 * sRGB. Found by a search for seven bright tones of moderate chroma, at least 36° of hue apart,
 * whose least distance (`leastDistance`) is greatest. Only seven, since fewer tones differ more.
 */
const palette: readonly number[] = [
  0x85b1ff, 0xd0a243, 0x9cddbb, 0xe27d83, 0xcce383, 0xb48fbe, 0x62e4f8,
];
const fewestTones = palette.length;

/** Neighbours that differ less than this for some reader get other tones where there are any. */
const comfortableDistance = 0.08;

/** Of so many sites that are gone the tones are kept: undoing brings them back. */
const mostGone = 20_000;

/**
 * Chooses a tone for every site so that neighbours differ. A site keeps its tone from diagram to
 * diagram if possible, because jumping colours would drown out everything else in a drag.
 */
export class RegionColours {
  #toneOfSite = new Map<number, number>();

  /**
   * A tone per label of the diagram, whose sites have these identities. Labels in `yielding` get
   * another tone if a neighbour has the same one, or if theirs is beyond the palette.
   */
  assign(
    diagram: Adjacency,
    siteIds: readonly number[],
    yielding: ReadonlySet<number> = new Set(),
  ): Uint16Array {
    const neighbours = neighboursOf(diagram);
    const unset = 0xffff;
    const labels = [...neighbours.keys()];
    const tones = new Uint16Array(diagram.siteCount).fill(unset);
    const usage: number[] = new Array(fewestTones).fill(0);
    const give = (label: number, tone: number) => {
      tones[label] = tone;
      usage[tone] = (usage[tone] ?? 0) + 1;
      this.#toneOfSite.set(siteIds[label], tone);
    };

    const firmFirst = [
      ...labels.filter((label) => !yielding.has(label)),
      ...labels.filter((label) => yielding.has(label)),
    ];
    for (const label of firmFirst) {
      const kept = this.#toneOfSite.get(siteIds[label]);
      if (kept === undefined || neighbours[label].some((other) => tones[other] === kept)) continue;
      if (kept >= fewestTones && yielding.has(label)) continue;
      give(label, kept);
    }
    for (const label of hardestFirst(neighbours)) {
      if (tones[label] !== unset) continue;
      const around = neighbours[label]
        .map((other) => tones[other])
        .filter((tone) => tone !== unset);
      give(label, bestTone(usage, around));
    }
    if (this.#toneOfSite.size > siteIds.length + mostGone)
      this.#toneOfSite = new Map(siteIds.map((id, label) => [id, tones[label]]));
    return tones;
  }
}

/** sRGB of a tone. Those beyond the palette repeat it, darker each time. */
export function toneColour(tone: number): number {
  const shade = 0.78 ** Math.floor(tone / palette.length);
  const base = palette[tone % palette.length];
  const channel = (shift: number) => Math.round(((base >> shift) & 0xff) * shade) << shift;
  return channel(16) | channel(8) | channel(0);
}

/**
 * The tone used least of those that differ comfortably from the ones around, else the one that
 * differs most.
 */
function bestTone(usage: readonly number[], around: readonly number[]): number {
  let best = usage.length; // a new one
  let bestDistance = 0;
  for (let tone = 0; tone < usage.length; ++tone) {
    let distance = comfortableDistance;
    for (const other of around) distance = Math.min(distance, toneDistance(tone, other));
    const isBetter =
      distance > bestDistance || (distance === bestDistance && usage[tone] < usage[best]);
    if (distance === 0 || !isBetter) continue;
    best = tone;
    bestDistance = distance;
  }
  while (around.includes(best)) ++best;
  return best;
}

/** By tones: a row per tone, filled when asked for. */
const toneDistances: number[][] = [];

function toneDistance(a: number, b: number): number {
  const row = (toneDistances[a] ??= []);
  return (row[b] ??= leastDistance(toneColour(a), toneColour(b)));
}

function neighboursOf({ siteCount, arcs }: Adjacency): number[][] {
  const sets = Array.from({ length: siteCount }, () => new Set<number>());
  for (let i = 0; i + 1 < arcs.labels.length; i += 2) {
    sets[arcs.labels[i]].add(arcs.labels[i + 1]);
    sets[arcs.labels[i + 1]].add(arcs.labels[i]);
  }
  return sets.map((set) => [...set]);
}

/**
 * The order in which greedy colouring needs few colours: taking away the label with the fewest
 * neighbours left, again and again, from the last to the first ("smallest last"). On a sphere no
 * label then has more than five neighbours before it.
 */
function hardestFirst(neighbours: readonly (readonly number[])[]): number[] {
  const left = neighbours.map((list) => list.length);
  const buckets: number[][] = [];
  const put = (label: number) => (buckets[left[label]] ??= []).push(label);
  neighbours.forEach((_, label) => put(label));
  const removed = new Uint8Array(neighbours.length);
  const order: number[] = [];
  let degree = 0;
  while (order.length < neighbours.length) {
    const label = buckets[degree]?.pop();
    if (label === undefined) {
      ++degree;
      continue;
    }
    // A label is put into a lower bucket each time it loses a neighbour; older entries are stale.
    if (removed[label] || left[label] !== degree) continue;
    removed[label] = 1;
    order.push(label);
    for (const other of neighbours[label]) {
      if (removed[other]) continue;
      --left[other];
      put(other);
      degree = Math.min(degree, left[other]);
    }
  }
  return order.reverse();
}
