// SPDX-License-Identifier: MIT
//
// Sites as a file.

import type { GeodesicVoronoiElement } from '../viewer/element.js';
import { showError } from './feedback.js';

/** The JSON form of a list of surface points, as the page and the command write it. */
interface SitesJson {
  face: number[];
  bary: number[];
}

export function sitesJson({ sites }: GeodesicVoronoiElement): SitesJson {
  return { face: [...sites.face], bary: [...sites.bary] };
}

/** Replaces the sites by those of a file, a step to undo. Shows an error if the file has none. */
export async function openSites(viewer: GeodesicVoronoiElement, file: File): Promise<void> {
  const { name } = file;
  let sites: unknown;
  try {
    sites = JSON.parse(await file.text());
  } catch {
    showError(`${name} is no JSON that can be read.`);
    return;
  }
  const faces = viewer.info?.faces ?? 0;
  if (!isSites(sites)) {
    showError(`${name} is no list of sites: it needs "face" and, three numbers for each, "bary".`);
  } else if (sites.face.some((face) => face >= faces)) {
    showError(`${name} belongs to another model: this one has ${faces} triangles.`);
  } else {
    viewer.sites = sites;
  }
}

function isSites(value: unknown): value is SitesJson {
  const { face, bary } = (value ?? {}) as Partial<SitesJson>;
  return (
    Array.isArray(face) &&
    Array.isArray(bary) &&
    bary.length === 3 * face.length &&
    face.every((each) => Number.isInteger(each) && each >= 0) &&
    bary.every(Number.isFinite)
  );
}
