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
    const tones = new Uint16Array(diagram.siteCount).fill(unset);
    const usage: number[] = new Array(fewestTones).fill(0);
    const give = (label: number, tone: number) => {
      tones[label] = tone;
      usage[tone] = (usage[tone] ?? 0) + 1;
      this.#toneOfSite.set(siteIds[label], tone);
    };

    const isAround = (label: number, tone: number) => {
      for (let i = neighbours.begin[label]; i < neighbours.end[label]; ++i)
        if (tones[neighbours.labels[i]] === tone) return true;
      return false;
    };
    const keep = (label: number, isYielding: boolean) => {
      const kept = this.#toneOfSite.get(siteIds[label]);
      if (kept === undefined || isAround(label, kept)) return;
      if (!(isYielding && kept >= fewestTones)) give(label, kept);
    };
    for (let label = 0; label < tones.length; ++label) if (!yielding.has(label)) keep(label, false);
    for (const label of [...yielding].sort((a, b) => a - b)) keep(label, true);
    const order = tones.includes(unset) ? hardestFirst(neighbours) : [];
    for (const label of order) {
      if (tones[label] !== unset) continue;
      const others = neighbours.labels.subarray(neighbours.begin[label], neighbours.end[label]);
      const around = Array.from(others, (other) => tones[other]).filter((tone) => tone !== unset);
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

/** The labels beside each label, once: `labels[begin[i]] … labels[end[i] - 1]`. */
interface Neighbours {
  begin: Int32Array;
  end: Int32Array;
  labels: Int32Array;
}

/** In a few arrays, since a list for each of thousands of labels takes far longer. */
function neighboursOf({ siteCount, arcs }: Adjacency): Neighbours {
  const offset = new Int32Array(siteCount + 1);
  for (let i = 0; i < arcs.labels.length; ++i) ++offset[arcs.labels[i] + 1];
  for (let label = 0; label < siteCount; ++label) offset[label + 1] += offset[label];
  const begin = offset.subarray(0, siteCount);
  const end = begin.slice();
  const labels = new Int32Array(arcs.labels.length);
  for (let i = 0; i < arcs.labels.length; ++i) labels[end[arcs.labels[i]]++] = arcs.labels[i ^ 1]; // the other one of the arc
  const lastBeside = new Int32Array(siteCount).fill(-1);
  for (let label = 0; label < siteCount; ++label) {
    end[label] = begin[label];
    for (let i = begin[label]; i < offset[label + 1]; ++i) {
      if (lastBeside[labels[i]] === label) continue;
      lastBeside[labels[i]] = label;
      labels[end[label]++] = labels[i];
    }
  }
  return { begin, end, labels };
}

/**
 * The order in which greedy colouring needs few colours: taking away the label with the fewest
 * neighbours left, again and again, from the last to the first ("smallest last"). On a sphere no
 * label then has more than five neighbours before it.
 */
function hardestFirst({ begin, end, labels }: Neighbours): number[] {
  const left = end.map((at, label) => at - begin[label]);
  const buckets: number[][] = [];
  const put = (label: number) => (buckets[left[label]] ??= []).push(label);
  for (const label of left.keys()) put(label);
  const removed = new Uint8Array(left.length);
  const order: number[] = [];
  let degree = 0;
  while (order.length < left.length) {
    const label = buckets[degree]?.pop();
    if (label === undefined) {
      ++degree;
      continue;
    }
    // A label is put into a lower bucket each time it loses a neighbour; older entries are stale.
    if (removed[label] || left[label] !== degree) continue;
    removed[label] = 1;
    order.push(label);
    for (let i = begin[label]; i < end[label]; ++i) {
      const other = labels[i];
      if (removed[other]) continue;
      --left[other];
      put(other);
      degree = Math.min(degree, left[other]);
    }
  }
  return order.reverse();
}
