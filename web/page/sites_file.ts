// SPDX-License-Identifier: MIT
//
// Sites as a file.

import type { SurfacePoints } from 'geodesic-voronoi';
import type { GeodesicVoronoiElement } from '../viewer/element.js';
import { sentence } from '../viewer/failure.js';
import { hideError, showError } from './feedback.js';

/** The JSON form of sites, as the page and the command write it. */
interface SitesJson {
  mesh: { faces: number };
  face: number[];
  bary: number[];
}

export function sitesJson({ sites, info }: GeodesicVoronoiElement): SitesJson {
  return {
    mesh: { faces: info?.inputFaces ?? 0 },
    face: [...sites.face],
    bary: [...sites.bary],
  };
}

/**
 * Replaces the sites by those of a file, a step to undo. Shows an error if the file has none, or
 * those of another model.
 */
export async function openSites(viewer: GeodesicVoronoiElement, file: File): Promise<void> {
  hideError();
  const { mesh } = viewer;
  const { name } = file;
  if (!mesh) {
    showError(`${name} holds sites: open their model first.`);
    return;
  }
  let json: unknown;
  try {
    json = JSON.parse(await file.text());
  } catch {
    showError(`${name} is no JSON that can be read.`);
    return;
  }
  try {
    const sites = await mesh.readPoints(json);
    if (mesh === viewer.mesh) viewer.sites = present(sites);
  } catch (error) {
    showError(sentence(`${name} cannot be opened as sites`, error).message);
  }
}

/** A diagram's list of sites without the labels of removed ones. */
function present({ face, bary }: SurfacePoints): SurfacePoints {
  return {
    face: face.filter((f) => f >= 0),
    bary: bary.filter((_, i) => face[Math.floor(i / 3)] >= 0),
  };
}
