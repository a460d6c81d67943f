// SPDX-License-Identifier: MIT
import type { DiagramData } from 'geodesic-voronoi';

/**
 * Σ ∫ d² for the plane in as many regular hexagons as there are sites, of the same area in all:
 * A²/k · 5/(18√3).
 */
export function hexagonEnergy(diagram: DiagramData | undefined): number {
  if (!diagram) return NaN;
  const area = diagram.regionArea.reduce((sum, each) => sum + each, 0);
  return ((area * area) / diagram.siteCount) * (5 / (18 * Math.sqrt(3)));
}
