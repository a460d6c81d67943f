// SPDX-License-Identifier: MIT
//
// An SVG drawing of the outlines of regions that are visible in the view.

import type { DiagramData } from 'geodesic-voronoi';
import type { GeodesicVoronoiElement } from '../../viewer/element.js';
import { shallowEqual } from '../../viewer/session/shallow_equal.js';
import { Slices } from '../../viewer/stage/next_frame.js';

/** A point of the surface as it is seen in the view, in CSS pixels; none if it is hidden. */
type SeenPoint = { x: number; y: number } | undefined;

/** Points tested between two looks at the clock; each test for visibility casts a ray. */
const pointsPerStep = 256;

/** What is seen of bisectors and of the mesh boundary, as a drawing of the view's size in CSS pixels. */
export async function outlinesSvg(
  viewer: GeodesicVoronoiElement,
  data: DiagramData,
): Promise<string> {
  const { clientWidth: width, clientHeight: height, exploded } = viewer;
  if (exploded > 0)
    throw new Error('the outlines are those of the whole model: end the exploded view first');
  const work = new Slices();
  const places = await seenPoints(viewer, data.points.position, work);
  const parts: string[] = [];
  for (const chain of chainsOf(data)) {
    if (work.isDue) await work.next();
    if (!chain) continue;
    // A line for every stretch of the chain that is seen.
    let stretch: string[] = [];
    for (let i = 0; i <= chain.length; ++i) {
      const place = i < chain.length ? places[chain[i]] : undefined;
      if (place) stretch.push(numbers(place));
      else {
        if (stretch.length > 1) parts.push(`M${stretch.join('L')}`);
        stretch = [];
      }
    }
  }
  if (parts.length === 0) throw new Error('no outline of a region is seen in this view');
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}">` +
    `<path d="${parts.join('')}" fill="none" stroke="#1f2933" stroke-width="1.2" ` +
    'stroke-linecap="round" stroke-linejoin="round"/></svg>\n'
  );
}

/** The bisectors, then the boundary, as chains of points. */
function* chainsOf(data: DiagramData): Generator<ArrayLike<number> | undefined> {
  const { points, offset } = data.arcs;
  for (let arc = 0; arc + 1 < offset.length; ++arc)
    yield points.subarray(offset[arc], offset[arc + 1]);
  yield* boundaryChains(data);
}

/**
 * The sides of the regions' loops that are on no bisector, as chains of points; in between,
 * undefined, where the work may pause.
 */
function* boundaryChains({
  loops,
  segments,
  points: { face },
}: DiagramData): Generator<number[] | undefined> {
  const keyOf = (a: number, b: number) => Math.min(a, b) * face.length + Math.max(a, b);
  const bisectors = new Set<number>();
  for (let i = 0; i < segments.points.length; i += 2) {
    bisectors.add(keyOf(segments.points[i], segments.points[i + 1]));
    if (i % pointsPerStep === 0) yield undefined;
  }
  for (let loop = 0; loop + 1 < loops.offset.length; ++loop) {
    const corners = loops.points.subarray(loops.offset[loop], loops.offset[loop + 1]);
    let chain: number[] = [];
    for (const [i, corner] of corners.entries()) {
      const next = corners[(i + 1) % corners.length];
      if (!bisectors.has(keyOf(corner, next))) {
        if (chain.length === 0) chain.push(corner);
        chain.push(next);
      } else if (chain.length > 0) {
        yield chain;
        chain = [];
      }
      if (i % pointsPerStep === 0) yield undefined;
    }
    if (chain.length > 0) yield chain;
  }
}

/** The places of points of the surface in the view, which has to stay as it is meanwhile. */
async function seenPoints(
  viewer: GeodesicVoronoiElement,
  positions: Float64Array,
  work: Slices,
): Promise<SeenPoint[]> {
  const places: SeenPoint[] = [];
  const view = viewOf(viewer);
  for (let i = 0; i < positions.length; i += 3 * pointsPerStep) {
    places.push(...viewer.project(positions.subarray(i, i + 3 * pointsPerStep)));
    if (!work.isDue) continue;
    await work.next();
    if (!shallowEqual(viewOf(viewer), view)) throw new Error('the view has changed meanwhile');
  }
  return places;
}

function viewOf({ mesh, cameraOrbit, clientWidth, clientHeight }: GeodesicVoronoiElement) {
  return { mesh, cameraOrbit, clientWidth, clientHeight };
}

function numbers({ x, y }: { x: number; y: number }): string {
  return `${x.toFixed(1)} ${y.toFixed(1)}`;
}
