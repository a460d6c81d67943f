// SPDX-License-Identifier: MIT
//
// Sites as a file.

import type { SurfacePoints } from 'geodesic-voronoi';
import type { GeodesicVoronoiElement } from '../viewer/element.js';
import { readCsvPlaces } from '../../dist/input/csv_places.js';
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
  try {
    const sites = await mesh.readPoints(await contentOf(file));
    if (mesh === viewer.mesh) viewer.sites = present(sites);
  } catch (error) {
    showError(sentence(`${name} cannot be opened as sites`, error).message);
  }
}

/** The JSON of a file, or the places in a table of x, y and z. */
async function contentOf(file: File): Promise<unknown> {
  if (!/\.json$/i.test(file.name)) {
    return { position: readCsvPlaces(new Uint8Array(await file.arrayBuffer())) };
  }
  const text = await file.text();
  try {
    return JSON.parse(text);
  } catch (cause) {
    throw new Error('it is no JSON that can be read', { cause });
  }
}

/** A diagram's list of sites without the labels of removed ones. */
function present({ face, bary }: SurfacePoints): SurfacePoints {
  return {
    face: face.filter((f) => f >= 0),
    bary: bary.filter((_, i) => face[Math.floor(i / 3)] >= 0),
  };
}
