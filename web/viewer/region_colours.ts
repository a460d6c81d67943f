// SPDX-License-Identifier: MIT

/** As much of a diagram as colouring looks at: two labels per arc. */
interface Adjacency {
  readonly siteCount: number;
  readonly arcs: { readonly labels: ArrayLike<number> };
}

/**
 * sRGB. Found by a search for the eight tones, pale enough for dark bisectors on top, whose least
 * distance in Oklab is greatest to readers with and without protanopia, deuteranopia and tritanopia
 * (as simulated by Machado et al. 2009), lightness counted less since shading changes it: 0.087,
 * where well-known palettes of this size and lightness have 0.04.
 */
const palette: readonly number[] = [
  0xa5e6fe, 0xebce74, 0xb1b3fd, 0x60cdbf, 0xd27b82, 0xd9ecc6, 0x9890c5, 0xc1a94d,
];
const fewestTones = palette.length;

/**
 * A tone for every site so that neighbours differ. A site keeps its tone from diagram to diagram
 * while it can: colours that jump would be all one sees of a drag.
 */
export class RegionColours {
  readonly #toneOfSite = new Map<number, number>();

  /**
   * Tones per label of the diagram, whose sites have these identities. Where two neighbours have had
   * the same tone, one in `yielding` takes another; those beyond the palette do so if they can.
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
      const taken = new Set(neighbours[label].map((other) => tones[other]));
      give(label, leastUsedTone(usage, taken));
    }
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

/** Of the tones not taken the one that is used least, a new one if all are. */
function leastUsedTone(usage: readonly number[], taken: ReadonlySet<number>): number {
  let best = -1;
  usage.forEach((count, tone) => {
    if (!taken.has(tone) && (best < 0 || count < usage[best])) best = tone;
  });
  if (best >= 0) return best;
  let tone = usage.length;
  while (taken.has(tone)) ++tone;
  return tone;
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
