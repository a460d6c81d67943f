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
  const { points, offset } = data.arcs;
  const parts: string[] = [];
  for (let arc = 0; arc + 1 < offset.length; ++arc) {
    if (work.isDue) await work.next();
    // A line for every stretch of the arc that is seen.
    let stretch: string[] = [];
    for (let i = offset[arc]; i <= offset[arc + 1]; ++i) {
      const place = i < offset[arc + 1] ? places[points[i]] : undefined;
      if (place) stretch.push(numbers(place));
      else {
        if (stretch.length > 1) parts.push(`M${stretch.join('L')}`);
        stretch = [];
      }
    }
  }
  if (parts.length === 0) throw new Error('no bisector is seen in this view');
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
