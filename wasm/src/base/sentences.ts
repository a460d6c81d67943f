// SPDX-License-Identifier: MIT
//
// Counts for people, and what the command and the page say of a mesh in the same words.

import { toResult } from './checks.js';
import type { MeshRepairs } from '../api/results.js';

const integers = new Intl.NumberFormat('en');

/** "1,200", for people. */
export function integer(value: number): string {
  return integers.format(value);
}

/** "1 site", "1,200 sites". */
export function counted(count: number, one: string, many = `${one}s`): string {
  return `${integer(count)} ${count === 1 ? one : many}`;
}

/** What is said of each kind of repair, by its count. */
const repairTexts: Record<
  Exclude<keyof MeshRepairs, 'mollification'>,
  (count: number, mollification: string) => string
> = {
  weldedVertices: (n) => `${vertices(n)} welded to ${n === 1 ? 'an earlier one' : 'earlier ones'}`,
  joinedVertices: (n) =>
    `${vertices(n)} joined to ${n === 1 ? 'a side that it lies' : 'sides that they lie'} within, by ${n === 1 ? 'a flat triangle' : 'flat triangles'}`,
  isolatedVertices: (n) => `${vertices(n)} without a triangle`,
  nonFiniteTriangles: (n) =>
    `${triangles(n)} with a corner that is not finite, dropped: the surface may have a hole there`,
  degenerateTriangles: (n) => `${triangles(n)} with two equal corners, dropped`,
  duplicateTriangles: (n) => `${triangles(n)} given twice, dropped`,
  nonManifoldEdges: (n) =>
    `${counted(n, 'edge')} of three or more triangles, where components are cut apart: no path leads across`,
  orientationCuts: (n) =>
    `${counted(n, 'edge')} cut because ${n === 1 ? 'its' : 'their'} two triangles disagree in orientation: no path leads across`,
  flippedTriangles: (n) => `${triangles(n)} turned over to agree with the neighbours`,
  smallComponents: (n) => `${counted(n, 'component')} with fewer triangles than asked for, dropped`,
  smallComponentTriangles: (n) => `${triangles(n)} of these, dropped with them`,
  splitVertices: (n) =>
    `${vertices(n)} split where separate fans of triangles touch: no path leads across`,
  mollifiedTriangles: (n, by) =>
    `${triangles(n)} flat or tiny: for distances, all edges are longer by ${by}, and flat triangles become a little higher`,
};

/** Advice for a mesh with open seams or T-junctions. */
export const weldAdvice =
  'some boundary vertices nearly coincide, or lie within sides of other triangles (T-junctions): joined within 0.0001 % of the diagonal (the option weld, 1e-6), paths would lead across';

const vertices = (count: number) => counted(count, 'vertex', 'vertices');
const triangles = (count: number) => counted(count, 'triangle');

/**
 * A sentence for each kind of repair that was made, without its capital and full stop. `length`
 * writes the one length among the numbers.
 */
export function repairSentences(
  repairs: Partial<MeshRepairs>,
  length: (value: number) => string = String,
): string[] {
  toResult('repairs', repairs);
  const by = length(repairs.mollification ?? 0);
  const names = Object.keys(repairTexts) as (keyof typeof repairTexts)[];
  return names.flatMap((name) => {
    const count = repairs[name] ?? 0;
    return count > 0 ? [repairTexts[name](count, by)] : [];
  });
}
