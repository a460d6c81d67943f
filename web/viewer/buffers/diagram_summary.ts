// SPDX-License-Identifier: MIT
//
// A diagram without its geometry.

import type { DiagramChange, DiagramData } from 'geodesic-voronoi';

type Lines = Pick<DiagramData, 'segments' | 'arcs' | 'voronoiPoints'>;

/**
 * Counts, areas and adjacency of a diagram, from which its colours follow. It is small and quickly
 * updated after a change, unlike `Diagram.data`, which would have to be put together.
 */
export class DiagramSummary {
  /** Per label. */
  readonly regionArea: Float64Array<ArrayBuffer>;
  /** Two labels per arc. */
  readonly arcs: { readonly labels: readonly number[] };
  /** Per arc. */
  readonly #segments: readonly number[];
  readonly voronoiPointCount: number;
  /** The labels around every Voronoi point, computed only for changes. */
  readonly #around: () => readonly Int32Array[];

  private constructor(
    regionArea: Float64Array<ArrayBuffer>,
    labels: readonly number[],
    segments: readonly number[],
    voronoiPointCount: number,
    around: () => readonly Int32Array[],
  ) {
    this.regionArea = regionArea;
    this.arcs = { labels };
    this.#segments = segments;
    this.voronoiPointCount = voronoiPointCount;
    this.#around = around;
  }

  static of(data: DiagramData): DiagramSummary {
    const labels = [...data.arcs.labels];
    const { voronoiPoints } = data;
    const around = () => labelsAround({ voronoiPoints });
    const { length } = voronoiPoints.point;
    return new DiagramSummary(data.regionArea, labels, segmentCounts(data), length, around);
  }

  get siteCount(): number {
    return this.regionArea.length;
  }

  get regionCount(): number {
    return this.regionArea.reduce((count, area) => count + (area > 0 ? 1 : 0), 0);
  }

  get arcCount(): number {
    return this.#segments.length;
  }

  get segmentCount(): number {
    return this.#segments.reduce((sum, count) => sum + count, 0);
  }

  /** The summary after a change that leaves this many sites. */
  after({ labels: changedLabels, part }: DiagramChange, siteCount: number): DiagramSummary {
    const regionArea = new Float64Array(siteCount);
    regionArea.set(this.regionArea.subarray(0, siteCount));
    const isChanged = new Uint8Array(1 + changedLabels[changedLabels.length - 1]);
    changedLabels.forEach((each, i) => {
      isChanged[each] = 1;
      if (each < siteCount) regionArea[each] = part.regionArea[i];
    });
    const labels: number[] = [];
    const segments: number[] = [];
    for (let arc = 0; arc < this.#segments.length; ++arc) {
      const [left, right] = [this.arcs.labels[2 * arc], this.arcs.labels[2 * arc + 1]];
      if (isChanged[left] || isChanged[right]) continue;
      labels.push(left, right);
      segments.push(this.#segments[arc]);
    }
    for (const label of part.arcs.labels) labels.push(label);
    for (const count of segmentCounts(part)) segments.push(count);
    const around = this.#around().filter((each) => !each.some((label) => isChanged[label] > 0));
    for (const each of labelsAround(part)) around.push(each);
    return new DiagramSummary(regionArea, labels, segments, around.length, () => around);
  }
}

function segmentCounts({ arcs, segments }: Lines): number[] {
  const counts: number[] = new Array(arcs.labels.length / 2).fill(0);
  for (const arc of segments.arc) ++counts[arc];
  return counts;
}

/** The labels around every Voronoi point. */
export function labelsAround({ voronoiPoints }: Pick<Lines, 'voronoiPoints'>): Int32Array[] {
  const { point, labelOffset, labels } = voronoiPoints;
  return Array.from(point, (_, i) => labels.subarray(labelOffset[i], labelOffset[i + 1]));
}
