// SPDX-License-Identifier: MIT
//
// Merges the changes that edits make into the arrays of a diagram.
import { GrowingArray } from '../base/growing_array.js';
import type { DiagramChange, DiagramData, PointLists, SurfacePoints } from '../api/results.js';

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

/**
 * The diagram after some changes, one after the other: of every region and triangle, it has the
 * pieces of the last change that replaced them, and otherwise its former ones.
 */
export function changedData(
  data: DiagramData,
  changes: readonly DiagramChange[],
  siteCount: number,
): DiagramData {
  const regionArea = new Float64Array(siteCount);
  regionArea.set(data.regionArea.subarray(0, siteCount));
  const faceLabel = data.faceLabel.slice();
  for (const { part, labels, faces } of changes) {
    labels.forEach((label, i) => {
      if (label < siteCount) regionArea[label] = part.regionArea[i];
    });
    faces.forEach((face, i) => (faceLabel[face] = part.faceLabel[i]));
  }
  return { siteCount, ...new Merge(data, changes).run(), regionArea, faceLabel };
}

/**
 * Appends a change to those that are still to be merged. Drops the ones before it that it fully
 * overwrites, as happens during a drag.
 */
export function appendChange(changes: DiagramChange[], change: DiagramChange): void {
  for (let last = changes.at(-1); last && isReplaced(last, change); last = changes.at(-1))
    changes.pop();
  changes.push(change);
}

/** Whether changes are so large that they are better merged than kept. */
export function areLarge(changes: readonly DiagramChange[], { points }: DiagramData): boolean {
  return changes.reduce((sum, { part }) => sum + part.points.face.length, 0) > points.face.length;
}

/** Whether a second change overwrites all of a first one. */
function isReplaced(first: DiagramChange, second: DiagramChange): boolean {
  return isSubset(first.labels, second.labels) && isSubset(first.faces, second.faces);
}

/** Whether an ascending list contains another one. */
function isSubset(some: Int32Array, all: Int32Array): boolean {
  let found = 0;
  for (const each of all) if (each === some[found]) ++found;
  return found === some.length;
}

/** The arrays of a diagram or of a change's part, without the values per label and face. */
type Pieces = Omit<DiagramData, 'siteCount' | 'regionArea' | 'faceLabel'>;

/** One of the sources of a merged diagram: its arrays, and where its points went. */
interface Source {
  /** 0: the diagram before; from 1, the changes in their order. */
  order: number;
  arrays: Pieces;
  pointOf: (point: number) => number;
}

class Merge {
  readonly #sources: Source[];
  /** The order of the last change that replaced a label's or a face's pieces; 0 if none did. */
  readonly #lastOfLabel: LastChange;
  readonly #lastOfFace: LastChange;
  readonly #points: MergedPoints;

  constructor(before: Pieces, changes: readonly DiagramChange[]) {
    const all = [before, ...changes.map(({ part }) => part)];
    this.#points = new MergedPoints(changes.map(({ part }) => part.points.face));
    this.#sources = all.map((arrays, order) => ({
      order,
      arrays,
      pointOf: this.#points.from(arrays.points),
    }));
    this.#lastOfLabel = new LastChange(changes.map(({ labels }) => labels));
    this.#lastOfFace = new LastChange(changes.map(({ faces }) => faces));
  }

  run(): Pieces {
    const pieces = {
      ...this.#lines(),
      voronoiPoints: this.#voronoiPoints(),
      loops: this.#loops(),
      indifferentFaces: this.#indifferentFaces(),
      cells: this.#cells(),
    };
    return { points: this.#points.arrays(), ...pieces };
  }

  #lines(): Pick<DiagramData, 'segments' | 'arcs'> {
    const arcs = new ListsBuilder();
    const arcLabels = integers();
    const points = integers();
    const labels = integers();
    const face = integers();
    const arc = integers();
    for (const { order, arrays, pointOf } of this.#sources) {
      const arcOf = new Int32Array(arrays.arcs.offset.length - 1).fill(-1);
      for (let i = 0; i < arcOf.length; ++i) {
        const [left, right] = [arrays.arcs.labels[2 * i], arrays.arcs.labels[2 * i + 1]];
        if (this.#lastOfLabel.of(left) > order || this.#lastOfLabel.of(right) > order) continue;
        arcOf[i] = arcs.count;
        arcs.add(arrays.arcs, i, pointOf);
        arcLabels.push(left);
        arcLabels.push(right);
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
    const point = integers();
    const labelOffset = integers();
    const labels = integers();
    labelOffset.push(0);
    for (const { order, arrays, pointOf } of this.#sources) {
      const { voronoiPoints } = arrays;
      for (let i = 0; i < voronoiPoints.point.length; ++i) {
        const around = voronoiPoints.labels.subarray(
          voronoiPoints.labelOffset[i],
          voronoiPoints.labelOffset[i + 1],
        );
        if (around.some((label) => this.#lastOfLabel.of(label) > order)) continue;
        point.push(pointOf(voronoiPoints.point[i]));
        for (const label of around) labels.push(label);
        labelOffset.push(labels.length);
      }
    }
    return {
      point: point.toArray(),
      labelOffset: labelOffset.toArray(),
      labels: labels.toArray(),
    };
  }

  #loops(): DiagramData['loops'] {
    const { lists, keys } = this.#inOrder(
      ({ loops }) => loops,
      ({ loops }) => loops.label,
      this.#lastOfLabel,
    );
    return { ...lists, label: keys };
  }

  #cells(): DiagramData['cells'] {
    const label = integers();
    const { lists, keys } = this.#inOrder(
      ({ cells }) => cells,
      ({ cells }) => cells.face,
      this.#lastOfFace,
      ({ cells }, i) => label.push(cells.label[i]),
    );
    return { ...lists, face: keys, label: label.toArray() };
  }

  #indifferentFaces(): Int32Array<ArrayBuffer> {
    const faces = integers();
    for (const { order, arrays } of this.#sources)
      for (const face of arrays.indifferentFaces)
        if (this.#lastOfFace.of(face) <= order) faces.push(face);
    return faces.toArray().sort();
  }

  /**
   * The lists of all sources, ascending by their keys, without those whose key a later source has
   * replaced. Calls `taken` with each list that is taken.
   */
  #inOrder(
    listsOf: (arrays: Pieces) => PointLists,
    keyOf: (arrays: Pieces) => Int32Array,
    last: LastChange,
    taken: (arrays: Pieces, i: number) => void = () => {},
  ): { lists: PointLists; keys: Int32Array<ArrayBuffer> } {
    const lists = new ListsBuilder();
    const keys = integers();
    const take = ({ arrays, pointOf }: Source, i: number) => {
      lists.add(listsOf(arrays), i, pointOf);
      keys.push(keyOf(arrays)[i]);
      taken(arrays, i);
    };
    const [before, ...changes] = this.#sources;
    const changed = changes
      .flatMap((source) =>
        Array.from(keyOf(source.arrays), (key, i) => ({ key, source, i })).filter(
          ({ key }) => last.of(key) === source.order,
        ),
      )
      .sort((a, b) => a.key - b.key);
    let next = 0;
    const takeChanged = (below: number) => {
      for (; next < changed.length && changed[next].key < below; ++next)
        take(changed[next].source, changed[next].i);
    };
    keyOf(before.arrays).forEach((key, i) => {
      takeChanged(key);
      if (last.of(key) === 0) take(before, i);
    });
    takeChanged(Infinity);
    return { lists: lists.lists(), keys: keys.toArray() };
  }
}

/** By label or face, which of several changes was the last to replace its pieces. */
class LastChange {
  readonly #order: Int32Array;

  /** Of the keys that each change has replaced, ascending. */
  constructor(changes: readonly Int32Array[]) {
    this.#order = new Int32Array(Math.max(0, ...changes.map((keys) => (keys.at(-1) ?? -1) + 1)));
    for (const [i, keys] of changes.entries()) for (const key of keys) this.#order[key] = i + 1;
  }

  /** The changes count from 1; 0 if none did. */
  of(key: number): number {
    return this.#order[key] ?? 0;
  }
}

function integers(): GrowingArray<Int32Array<ArrayBuffer>> {
  return new GrowingArray(Int32Array);
}

/** A point that several sources may have, and the one before with the same key. */
interface SharedPoint {
  point: number;
  face: number;
  b0: number;
  b1: number;
  before: SharedPoint | undefined;
}

/** Collects the points that a merged diagram refers to, each place once. */
class MergedPoints {
  readonly #face = integers();
  readonly #bary = new GrowingArray<Float64Array<ArrayBuffer>>(Float64Array);
  readonly #position = new GrowingArray<Float64Array<ArrayBuffer>>(Float64Array);
  /** The faces in which several sources may have points at the same place. */
  readonly #sharedFaces = new Set<number>();
  /** The points in these so far, by `placeKey`: one face may have those of thousands of regions. */
  readonly #shared = new Map<number, SharedPoint>();

  /** Only in faces that changes have points in may two sources share one. */
  constructor(changedFaces: readonly Int32Array[]) {
    for (const faces of changedFaces) for (const face of faces) this.#sharedFaces.add(face);
  }

  /** Numbers the points of a source in the merged diagram, each when it is first asked for. */
  from(points: DiagramData['points']): (point: number) => number {
    const merged = new Int32Array(points.face.length).fill(-1);
    return (point) => {
      if (merged[point] < 0) merged[point] = this.#number(points, point);
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

  #number(points: DiagramData['points'], i: number): number {
    const face = points.face[i];
    if (!this.#sharedFaces.has(face)) return this.#add(points, i);
    const [b0, b1] = [points.bary[3 * i], points.bary[3 * i + 1]];
    const key = placeKey(face, b0, b1);
    const last = this.#shared.get(key);
    for (let each = last; each; each = each.before)
      if (each.face === face && each.b0 === b0 && each.b1 === b1) return each.point;
    const point = this.#add(points, i);
    this.#shared.set(key, { point, face, b0, b1, before: last });
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

/** A whole number that points at the same place share, and few others have; engines keep 30 bits unboxed. */
function placeKey(face: number, b0: number, b1: number): number {
  return (Math.imul(face, 65599) + 2 ** 28 * (b0 + b1 / 3)) & (2 ** 30 - 1);
}

class ListsBuilder {
  readonly #offset = integers();
  readonly #points = integers();

  constructor() {
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
