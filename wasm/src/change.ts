// SPDX-License-Identifier: MIT
import type { DiagramChange, DiagramData, PointLists, SurfacePoints } from './types.js';

/** The sites after a change: `site` is where the one of `label` is now, undefined if it is gone. */
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
  return { face, bary };
}

/** The diagram after a change: what the change names is replaced, all else is kept. */
export function changedData(data: DiagramData, change: DiagramChange): DiagramData {
  return new Merge(data, change).run();
}

/** One of the two sources of a merged diagram: its arrays, and where its points went. */
interface Source {
  arrays: Omit<DiagramData, 'siteCount'>;
  pointOf: (point: number) => number;
}

class Merge {
  readonly #change: DiagramChange;
  readonly #old: Source;
  readonly #part: Source;
  readonly #siteCount: number;
  readonly #isChangedLabel: Uint8Array;
  readonly #isChangedFace: Uint8Array;
  readonly #points = new MergedPoints();

  constructor(data: DiagramData, change: DiagramChange) {
    this.#change = change;
    this.#siteCount = Math.max(data.siteCount, change.label + 1);
    this.#old = { arrays: data, pointOf: this.#points.from(data.points, change.part.points) };
    this.#part = { arrays: change.part, pointOf: this.#points.from(change.part.points) };
    this.#isChangedLabel = marks(this.#siteCount, change.labels);
    this.#isChangedFace = marks(data.faceLabel.length, change.faces);
  }

  run(): DiagramData {
    const old = this.#old.arrays;
    const { part, labels, faces } = this.#change;
    const lines = this.#lines();
    const regionArea = new Float64Array(this.#siteCount);
    regionArea.set(old.regionArea);
    labels.forEach((label, i) => (regionArea[label] = part.regionArea[i]));
    const faceLabel = old.faceLabel.slice();
    faces.forEach((face, i) => (faceLabel[face] = part.faceLabel[i]));
    const kept = old.indifferentFaces.filter((face) => !this.#isChangedFace[face]);
    const result = {
      siteCount: this.#siteCount,
      ...lines,
      voronoiPoints: this.#voronoiPoints(),
      loops: this.#loops(),
      regionArea,
      faceLabel,
      indifferentFaces: Int32Array.from([...kept, ...part.indifferentFaces]).sort(),
      cells: this.#cells(),
    };
    return { ...result, points: this.#points.arrays() };
  }

  /** Whether a bisector of two labels is replaced. */
  #isChangedPair(labels: Int32Array, i: number): boolean {
    return !!this.#isChangedLabel[labels[2 * i]] || !!this.#isChangedLabel[labels[2 * i + 1]];
  }

  #lines(): Pick<DiagramData, 'segments' | 'arcs'> {
    const arcs = new ListsBuilder();
    const arcLabels: number[] = [];
    const points: number[] = [];
    const labels: number[] = [];
    const face: number[] = [];
    const arc: number[] = [];
    for (const { arrays, pointOf } of [this.#old, this.#part]) {
      const isKept = (i: number) => arrays !== this.#old.arrays || !this.#isChangedPair(arrays.arcs.labels, i);
      const arcOf = new Int32Array(arrays.arcs.offset.length - 1).fill(-1);
      for (let i = 0; i < arcOf.length; ++i) {
        if (!isKept(i)) continue;
        arcOf[i] = arcs.count;
        arcs.add(arrays.arcs, i, pointOf);
        arcLabels.push(arrays.arcs.labels[2 * i], arrays.arcs.labels[2 * i + 1]);
      }
      const { segments } = arrays;
      for (let s = 0; s < segments.face.length; ++s) {
        if (arcOf[segments.arc[s]] < 0) continue;
        points.push(pointOf(segments.points[2 * s]), pointOf(segments.points[2 * s + 1]));
        labels.push(segments.labels[2 * s], segments.labels[2 * s + 1]);
        face.push(segments.face[s]);
        arc.push(arcOf[segments.arc[s]]);
      }
    }
    return {
      segments: {
        points: Int32Array.from(points),
        labels: Int32Array.from(labels),
        face: Int32Array.from(face),
        arc: Int32Array.from(arc),
      },
      arcs: { ...arcs.lists(), labels: Int32Array.from(arcLabels) },
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
        if (arrays === this.#old.arrays && around.some((label) => this.#isChangedLabel[label])) {
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
    return this.#inOrder(
      ({ loops }) => loops,
      ({ loops }) => loops.label,
      this.#isChangedLabel,
      (lists, order) => ({ ...lists, label: Int32Array.from(order, ([source, i]) => source.loops.label[i]) }),
    );
  }

  #cells(): DiagramData['cells'] {
    return this.#inOrder(
      ({ cells }) => cells,
      ({ cells }) => cells.face,
      this.#isChangedFace,
      (lists, order) => ({
        ...lists,
        face: Int32Array.from(order, ([source, i]) => source.cells.face[i]),
        label: Int32Array.from(order, ([source, i]) => source.cells.label[i]),
      }),
    );
  }

  /** Lists of both sources, ascending by a key; those of the old one only if theirs is unchanged. */
  #inOrder<Result>(
    listsOf: (arrays: Source['arrays']) => PointLists,
    keyOf: (arrays: Source['arrays']) => Int32Array,
    isChanged: Uint8Array,
    build: (lists: PointLists, order: readonly (readonly [Source['arrays'], number])[]) => Result,
  ): Result {
    const lists = new ListsBuilder();
    const order: [Source['arrays'], number][] = [];
    const oldKey = keyOf(this.#old.arrays);
    const newKey = keyOf(this.#part.arrays);
    const take = ({ arrays, pointOf }: Source, i: number) => {
      lists.add(listsOf(arrays), i, pointOf);
      order.push([arrays, i]);
    };
    let next = 0;
    for (let i = 0; i <= oldKey.length; ++i) {
      while (next < newKey.length && (i === oldKey.length || newKey[next] <= oldKey[i])) {
        take(this.#part, next++);
      }
      if (i < oldKey.length && !isChanged[oldKey[i]]) take(this.#old, i);
    }
    return build(lists.lists(), order);
  }
}

/** The points of a merged diagram that are named, each place once. */
class MergedPoints {
  readonly #face: number[] = [];
  readonly #bary: number[] = [];
  readonly #position: number[] = [];
  readonly #shared = new Map<string, number>();

  /**
   * The merged index of a source's point, given when first asked for. Points at a place of the
   * `other` source are one with those.
   */
  from(
    points: DiagramData['points'],
    other?: DiagramData['points'],
  ): (point: number) => number {
    const merged = new Int32Array(points.face.length).fill(-1);
    const faces = other && new Set(other.face);
    return (point) => {
      if (merged[point] < 0) {
        const mayBeShared = !faces || faces.has(points.face[point]);
        const key = mayBeShared ? placeKey(points, point) : undefined;
        const known = key === undefined ? undefined : this.#shared.get(key);
        merged[point] = known ?? this.#add(points, point);
        if (key !== undefined) this.#shared.set(key, merged[point]);
      }
      return merged[point];
    };
  }

  arrays(): DiagramData['points'] {
    return {
      face: Int32Array.from(this.#face),
      bary: Float64Array.from(this.#bary),
      position: Float64Array.from(this.#position),
    };
  }

  #add({ face, bary, position }: DiagramData['points'], i: number): number {
    for (let k = 3 * i; k < 3 * i + 3; ++k) {
      this.#bary.push(bary[k]);
      this.#position.push(position[k]);
    }
    return this.#face.push(face[i]) - 1;
  }
}

function placeKey({ face, bary }: DiagramData['points'], i: number): string {
  return `${face[i]} ${bary[3 * i]} ${bary[3 * i + 1]}`;
}

class ListsBuilder {
  readonly #offset = [0];
  readonly #points: number[] = [];

  get count(): number {
    return this.#offset.length - 1;
  }

  add({ offset, points }: PointLists, list: number, pointOf: (point: number) => number): void {
    for (let i = offset[list]; i < offset[list + 1]; ++i) this.#points.push(pointOf(points[i]));
    this.#offset.push(this.#points.length);
  }

  lists(): PointLists {
    return { offset: Int32Array.from(this.#offset), points: Int32Array.from(this.#points) };
  }
}

function marks(count: number, indices: Int32Array): Uint8Array {
  const marked = new Uint8Array(count);
  for (const i of indices) marked[i] = 1;
  return marked;
}
