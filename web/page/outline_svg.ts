// SPDX-License-Identifier: MIT
import type { DiagramData } from 'geodesic-voronoi';
import type { GeodesicVoronoiElement } from '../viewer/element.js';

/** The bisectors that are seen in the view, as a drawing of its size in CSS pixels. */
export function outlinesSvg(viewer: GeodesicVoronoiElement, data: DiagramData): string {
  const { clientWidth: width, clientHeight: height } = viewer;
  const places = viewer.project(data.points.position);
  const { points } = data.segments;
  const parts: string[] = [];
  let last = -1;
  for (let s = 0; s < points.length; s += 2) {
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

function numbers({ x, y }: { x: number; y: number }): string {
  return `${x.toFixed(1)} ${y.toFixed(1)}`;
}
