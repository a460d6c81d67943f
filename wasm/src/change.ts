// SPDX-License-Identifier: MIT
//
// Merges the change that an edit makes into the arrays of a diagram.
import { GrowingArray } from './input/growing_array.js';
import type { DiagramChange, DiagramData, PointLists, SurfacePoints } from './results.js';

/**
 * The sites after a change: `site` is the new place of `label`, undefined if it was removed. Labels
 * without a site are dropped from the end.
 */
export function changedSites(
  sites: SurfacePoints,
  label: number,
  site: SurfacePoints | undefined,
): SurfacePoints {
  const count = Math.max(sites.face.length, label + 1);
  const face = new Int32Array(count).fill(-1);
  const bary = new Float64Array(3 * count);
  face.set(sites.face);
  bary.set(sites.bary);
  face[label] = site ? site.face[0] : -1;
  bary.set(site ? site.bary : [0, 0, 0], 3 * label);
  let end = count;
  while (end > 0 && face[end - 1] < 0) --end;
  return end === count
    ? { face, bary }
    : { face: face.slice(0, end), bary: bary.slice(0, 3 * end) };
}

/** The diagram after a change: its regions and triangles are replaced, everything else is kept. */
export function changedData(
  data: DiagramData,
  change: DiagramChange,
  siteCount: number,
): DiagramData {
  const { part, labels, faces } = change;
  const regionArea = new Float64Array(siteCount);
  regionArea.set(data.regionArea.subarray(0, siteCount));
  labels.forEach((label, i) => {
    if (label < siteCount) regionArea[label] = part.regionArea[i];
  });
  const faceLabel = data.faceLabel.slice();
  faces.forEach((face, i) => (faceLabel[face] = part.faceLabel[i]));
  return { siteCount, ...new Merge(data, change).run(), regionArea, faceLabel };
}

/** Two changes as one: the second was made after the first. */
export function combinedChange(first: DiagramChange, second: DiagramChange): DiagramChange {
  const [labels, regionArea] = overlaid(
    [first.labels, first.part.regionArea],
    [second.labels, second.part.regionArea],
  );
  const [faces, faceLabel] = overlaid(
    [first.faces, first.part.faceLabel],
    [second.faces, second.part.faceLabel],
  );
  const part = {
    ...new Merge(first.part, second).run(),
    regionArea: Float64Array.from(regionArea),
    faceLabel: Int32Array.from(faceLabel),
  };
  return { label: second.label, labels, faces, part };
}

/**
 * Shortens a list of changes after one has been appended. Drops earlier changes that the newest one
 * fully overwrites, as happens during a drag, and combines it with those that are at most twice as
 * large.
 */
export function shortenChanges(changes: DiagramChange[]): void {
  let last = changes.pop();
  if (!last) return;
  for (let before = changes.at(-1); before; before = changes.at(-1)) {
    if (!isReplaced(before, last)) {
      if (sizeOf(before) > 2 * sizeOf(last)) break;
      last = combinedChange(before, last);
    }
    changes.pop();
  }
  changes.push(last);
}

/** Whether a second change overwrites all of a first one. */
function isReplaced(first: DiagramChange, second: DiagramChange): boolean {
  return isSubset(first.labels, second.labels) && isSubset(first.faces, second.faces);
}

function isSubset(some: Int32Array, all: Int32Array): boolean {
  if (some.length > all.length) return false;
  const set = new Set(all);
  return some.every((each) => set.has(each));
}

function sizeOf({ part }: DiagramChange): number {
  return part.points.face.length;
}

/** Values by ascending keys; where several layers have a key, the value of the last one. */
function overlaid(
  ...layers: [Int32Array, ArrayLike<number>][]
): [keys: Int32Array, values: number[]] {
  const valueByKey = new Map<number, number>();
  for (const [keys, values] of layers) keys.forEach((key, i) => valueByKey.set(key, values[i]));
  const keys = Int32Array.from(valueByKey.keys()).sort();
  return [keys, Array.from(keys, (key) => valueByKey.get(key)!)];
}

/** The arrays of a diagram or of a change's part, without the values per label and face. */
type Pieces = Omit<DiagramData, 'siteCount' | 'regionArea' | 'faceLabel'>;

/** One of the two sources of a merged diagram: its arrays, and where its points went. */
interface Source {
  arrays: Pieces;
  pointOf: (point: number) => number;
}

class Merge {
  readonly #old: Source;
  readonly #part: Source;
  readonly #changedLabels: ReadonlySet<number>;
  readonly #changedFaces: ReadonlySet<number>;
  readonly #points: MergedPoints;

  constructor(old: Pieces, { part, labels, faces }: DiagramChange) {
    this.#points = new MergedPoints(old.points.face.length + part.points.face.length);
    this.#old = { arrays: old, pointOf: this.#points.from(old.points, part.points) };
    this.#part = { arrays: part, pointOf: this.#points.from(part.points) };
    this.#changedLabels = new Set(labels);
    this.#changedFaces = new Set(faces);
  }

  run(): Pieces {
    const kept = this.#old.arrays.indifferentFaces.filter((face) => !this.#changedFaces.has(face));
    const pieces = {
      ...this.#lines(),
      voronoiPoints: this.#voronoiPoints(),
      loops: this.#loops(),
      indifferentFaces: Int32Array.from([...kept, ...this.#part.arrays.indifferentFaces]).sort(),
      cells: this.#cells(),
    };
    return { points: this.#points.arrays(), ...pieces };
  }

  /** Whether a bisector of two labels is replaced. */
  #isChangedPair(labels: Int32Array, i: number): boolean {
    return this.#changedLabels.has(labels[2 * i]) || this.#changedLabels.has(labels[2 * i + 1]);
  }

  #lines(): Pick<DiagramData, 'segments' | 'arcs'> {
    const arcs = this.#lists((arrays) => arrays.arcs);
    const arcLabels = this.#numbers((arrays) => arrays.arcs.labels);
    const points = this.#numbers((arrays) => arrays.segments.points);
    const labels = this.#numbers((arrays) => arrays.segments.labels);
    const face = this.#numbers((arrays) => arrays.segments.face);
    const arc = this.#numbers((arrays) => arrays.segments.arc);
    for (const { arrays, pointOf } of [this.#old, this.#part]) {
      const isKept = (i: number) =>
        arrays !== this.#old.arrays || !this.#isChangedPair(arrays.arcs.labels, i);
      const arcOf = new Int32Array(arrays.arcs.offset.length - 1).fill(-1);
      for (let i = 0; i < arcOf.length; ++i) {
        if (!isKept(i)) continue;
        arcOf[i] = arcs.count;
        arcs.add(arrays.arcs, i, pointOf);
        arcLabels.push(arrays.arcs.labels[2 * i]);
        arcLabels.push(arrays.arcs.labels[2 * i + 1]);
      }
      const { segments } = arrays;
      for (let s = 0; s < segments.face.length; ++s) {
        if (arcOf[segments.arc[s]] < 0) continue;
        for (let end = 2 * s; end < 2 * s + 2; ++end) {
          points.push(pointOf(segments.points[end]));
          labels.push(segments.labels[end]);
        }
        face.push(segments.face[s]);
        arc.push(arcOf[segments.arc[s]]);
      }
    }
    return {
      segments: {
        points: points.toArray(),
        labels: labels.toArray(),
        face: face.toArray(),
        arc: arc.toArray(),
      },
      arcs: { ...arcs.lists(), labels: arcLabels.toArray() },
    };
  }

  #voronoiPoints(): DiagramData['voronoiPoints'] {
    const point: number[] = [];
    const labelOffset = [0];
    const labels: number[] = [];
    for (const { arrays, pointOf } of [this.#old, this.#part]) {
      const { voronoiPoints } = arrays;
      for (let i = 0; i < voronoiPoints.point.length; ++i) {
        const around = voronoiPoints.labels.subarray(
          voronoiPoints.labelOffset[i],
          voronoiPoints.labelOffset[i + 1],
        );
        if (arrays === this.#old.arrays && around.some((label) => this.#changedLabels.has(label))) {
          continue;
        }
        point.push(pointOf(voronoiPoints.point[i]));
        labels.push(...around);
        labelOffset.push(labels.length);
      }
    }
    return {
      point: Int32Array.from(point),
      labelOffset: Int32Array.from(labelOffset),
      labels: Int32Array.from(labels),
    };
  }

  #loops(): DiagramData['loops'] {
    const { lists, keys } = this.#inOrder(
      ({ loops }) => loops,
      ({ loops }) => loops.label,
      this.#changedLabels,
    );
    return { ...lists, label: keys };
  }

  #cells(): DiagramData['cells'] {
    const label = this.#numbers(({ cells }) => cells.label);
    const { lists, keys } = this.#inOrder(
      ({ cells }) => cells,
      ({ cells }) => cells.face,
      this.#changedFaces,
      ({ cells }, i) => label.push(cells.label[i]),
    );
    return { ...lists, face: keys, label: label.toArray() };
  }

  /** An array with room for all numbers of both sources. */
  #numbers(of: (arrays: Pieces) => Int32Array): GrowingArray<Int32Array> {
    return new GrowingArray(Int32Array, of(this.#old.arrays).length + of(this.#part.arrays).length);
  }

  /** Lists with room for all of both sources. */
  #lists(of: (arrays: Pieces) => PointLists): ListsBuilder {
    return new ListsBuilder(
      this.#numbers((arrays) => of(arrays).offset),
      this.#numbers((arrays) => of(arrays).points),
    );
  }

  /**
   * The lists of both sources, ascending by their keys; those of the old one whose key has changed
   * are left out. Calls `taken` with each list that is taken.
   */
  #inOrder(
    listsOf: (arrays: Pieces) => PointLists,
    keyOf: (arrays: Pieces) => Int32Array,
    changed: ReadonlySet<number>,
    taken: (arrays: Pieces, i: number) => void = () => {},
  ): { lists: PointLists; keys: Int32Array } {
    const lists = this.#lists(listsOf);
    const oldKey = keyOf(this.#old.arrays);
    const newKey = keyOf(this.#part.arrays);
    const keys = this.#numbers(keyOf);
    const take = ({ arrays, pointOf }: Source, key: number, i: number) => {
      lists.add(listsOf(arrays), i, pointOf);
      keys.push(key);
      taken(arrays, i);
    };
    let next = 0;
    for (let i = 0; i <= oldKey.length; ++i) {
      while (next < newKey.length && (i === oldKey.length || newKey[next] <= oldKey[i])) {
        take(this.#part, newKey[next], next);
        ++next;
      }
      if (i < oldKey.length && !changed.has(oldKey[i])) take(this.#old, oldKey[i], i);
    }
    return { lists: lists.lists(), keys: keys.toArray() };
  }
}

/** Collects the points that a merged diagram refers to, each place once. */
class MergedPoints {
  readonly #face: GrowingArray<Int32Array>;
  readonly #bary: GrowingArray<Float64Array>;
  readonly #position: GrowingArray<Float64Array>;
  /** By face, the points that another source may have at the same place. */
  readonly #shared = new Map<number, { point: number; b0: number; b1: number }[]>();

  constructor(most: number) {
    this.#face = new GrowingArray(Int32Array, most);
    this.#bary = new GrowingArray(Float64Array, 3 * most);
    this.#position = new GrowingArray(Float64Array, 3 * most);
  }

  /**
   * Numbers the points of a source in the merged diagram, each when it is first asked for. A point
   * at the same place as one of the `other` source gets the same number.
   */
  from(points: DiagramData['points'], other?: DiagramData['points']): (point: number) => number {
    const merged = new Int32Array(points.face.length).fill(-1);
    const faces = other && new Set(other.face);
    return (point) => {
      if (merged[point] < 0) {
        const mayBeShared = !faces || faces.has(points.face[point]);
        merged[point] = mayBeShared ? this.#share(points, point) : this.#add(points, point);
      }
      return merged[point];
    };
  }

  arrays(): DiagramData['points'] {
    return {
      face: this.#face.toArray(),
      bary: this.#bary.toArray(),
      position: this.#position.toArray(),
    };
  }

  #share(points: DiagramData['points'], i: number): number {
    const face = points.face[i];
    let here = this.#shared.get(face);
    if (!here) this.#shared.set(face, (here = []));
    const [b0, b1] = [points.bary[3 * i], points.bary[3 * i + 1]];
    const known = here.find((each) => each.b0 === b0 && each.b1 === b1);
    if (known) return known.point;
    const point = this.#add(points, i);
    here.push({ point, b0, b1 });
    return point;
  }

  #add({ face, bary, position }: DiagramData['points'], i: number): number {
    for (let k = 3 * i; k < 3 * i + 3; ++k) {
      this.#bary.push(bary[k]);
      this.#position.push(position[k]);
    }
    this.#face.push(face[i]);
    return this.#face.length - 1;
  }
}

class ListsBuilder {
  readonly #offset: GrowingArray<Int32Array>;
  readonly #points: GrowingArray<Int32Array>;

  /** Of two empty arrays. */
  constructor(offset: GrowingArray<Int32Array>, points: GrowingArray<Int32Array>) {
    this.#offset = offset;
    this.#points = points;
    this.#offset.push(0);
  }

  get count(): number {
    return this.#offset.length - 1;
  }

  add({ offset, points }: PointLists, list: number, pointOf: (point: number) => number): void {
    for (let i = offset[list]; i < offset[list + 1]; ++i) this.#points.push(pointOf(points[i]));
    this.#offset.push(this.#points.length);
  }

  lists(): PointLists {
    return { offset: this.#offset.toArray(), points: this.#points.toArray() };
  }
}
