// SPDX-License-Identifier: MIT
//
// Sites as a file.

import { pointsJson } from 'geodesic-voronoi';
import type { GeodesicVoronoiElement } from '../../viewer/element.js';
import { maxHeaderBytes, readPlyHeader } from '../../../dist/input/ply_header.js';
import { readPointsFile } from '../../../dist/input/points_reader.js';
import { pointsFile } from '../../../dist/input/points_file.js';
import { byId } from '../base/dom.js';
import { hideError, showError, showFailure, showNoteOnSites } from '../base/messages.js';
import { counted, integer, measure } from '../base/numbers.js';
import { isSame } from '../base/same_sites.js';

/** How far places are from the surface before it is told, in diagonals of the model. */
const mostFar = 0.05;

/** Sites as the page and the command write them. */
export function sitesJson({ sites, info }: GeodesicVoronoiElement): object {
  return { mesh: { faces: info?.inputFaces }, ...pointsJson(sites) };
}

/** A table of coordinates, as the command writes it. */
export async function sitesCsv({ sites, mesh }: GeodesicVoronoiElement): Promise<string> {
  const places = await mesh?.positionsOf(sites);
  const rows = Array.from(sites.face, (_, i) => places?.slice(3 * i, 3 * i + 3).join(','));
  return ['x,y,z', ...rows, ''].join('\n');
}

/** A folder's files of these kinds may be anything; those that are opened one by one are sites. */
export async function isSitesFile(file: File): Promise<boolean> {
  if (file.webkitRelativePath) return false;
  return /\.(json|f?csv|xyz)$/i.test(file.name) || (isPly(file) && (await isWithoutFaces(file)));
}

function isPly({ name }: File): boolean {
  return /\.ply$/i.test(name);
}

/** Whether a PLY has points only. False for one that is damaged, which opening it will report. */
async function isWithoutFaces(file: File): Promise<boolean> {
  try {
    const head = await file.slice(0, maxHeaderBytes).arrayBuffer();
    const { elements } = readPlyHeader(new Uint8Array(head));
    return elements.every(({ name, count }) => name === 'vertex' || count === 0);
  } catch {
    return false;
  }
}

/**
 * Replaces the sites by those of a file, a step to undo. Shows an error if it has no list of points, or
 * has those of another model.
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
    const content = await readPointsFile(new Uint8Array(await file.arrayBuffer()));
    const places = placesIn(content);
    const sites = await mesh.readPoints(content);
    const { distance } = await mesh.closestPoints(places);
    if (mesh !== viewer.mesh) return;
    const before = viewer.sites;
    viewer.sites = sites;
    if (isSame(before, viewer.sites))
      showNoteOnSites(viewer, `${name} has the sites that are shown.`);
    else
      tellOfPoints(
        viewer,
        file,
        distance.reduce((most, d) => Math.max(most, d), 0),
      );
  } catch (error) {
    showFailure(`${name} cannot be opened as sites`, error);
  }
}

/**
 * Tells what a file was taken for: a .ply is often meant to be a model, and places far from the surface are
 * often those of another one, or in another unit.
 */
function tellOfPoints(viewer: GeodesicVoronoiElement, file: File, far: number): void {
  const isFar = far > mostFar * (viewer.info?.boundingDiagonal ?? 0);
  const what = isPly(file) ? `${file.name} has no triangles: the` : 'The';
  const points = counted(viewer.sites.face.length, 'point');
  const how = isFar ? `, up to ${measure(far)} away from the surface` : '';
  showNoteOnSites(viewer, `${what} sites have been replaced by the ${points} of the file${how}.`, {
    title: 'Undo',
    act: () => viewer.undo(),
  });
}

/** The places of points that are given by these alone, of which there may not be too many. */
function placesIn(content: unknown): ArrayLike<number> {
  const { points } = pointsFile(content);
  // Points on triangles may come with their places, in another unit.
  if (!('position' in points) || 'face' in points) return [];
  const { position } = points;
  const most = Number(byId('count', HTMLInputElement).max);
  // JSON may have anything there, which `mesh.readPoints` refuses.
  if (position?.length > 3 * most)
    throw new Error(
      `it has ${integer(position.length / 3)} points without triangles, more than ${integer(most)}`,
    );
  return position;
}
