// SPDX-License-Identifier: MIT
//
// An SVG drawing of the bisectors that are visible in the view.

import type { DiagramData } from 'geodesic-voronoi';
import type { GeodesicVoronoiElement } from '../viewer/element.js';
import { Slices } from '../viewer/next_frame.js';

/** A point of the surface as it is seen in the view, in CSS pixels; none if it is hidden. */
type SeenPoint = { x: number; y: number } | undefined;

/** Points tested between two looks at the clock; each test for visibility casts a ray. */
const pointsPerStep = 256;

/** The bisectors that are seen in the view, as a drawing of its size in CSS pixels. */
export async function outlinesSvg(
  viewer: GeodesicVoronoiElement,
  data: DiagramData,
): Promise<string> {
  const { clientWidth: width, clientHeight: height } = viewer;
  const work = new Slices();
  const places = await seenPoints(viewer, data.points.position, work);
  const { points } = data.segments;
  const parts: string[] = [];
  let last = -1;
  for (let s = 0; s < points.length; s += 2) {
    if (work.isDue) await work.next();
    const [a, b] = [points[s], points[s + 1]];
    const [from, to] = [places[a], places[b]];
    if (!from || !to) continue;
    // Segments of an arc follow each other.
    parts.push(a === last ? `L${numbers(to)}` : `M${numbers(from)}L${numbers(to)}`);
    last = b;
  }
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}">` +
    `<path d="${parts.join('')}" fill="none" stroke="#1f2933" stroke-width="1.2" ` +
    'stroke-linecap="round" stroke-linejoin="round"/></svg>\n'
  );
}

async function seenPoints(
  viewer: GeodesicVoronoiElement,
  positions: Float64Array,
  work: Slices,
): Promise<SeenPoint[]> {
  const places: SeenPoint[] = [];
  for (let i = 0; i < positions.length; i += 3 * pointsPerStep) {
    places.push(...viewer.project(positions.subarray(i, i + 3 * pointsPerStep)));
    if (work.isDue) await work.next();
  }
  return places;
}

function numbers({ x, y }: { x: number; y: number }): string {
  return `${x.toFixed(1)} ${y.toFixed(1)}`;
}
