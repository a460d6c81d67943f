// SPDX-License-Identifier: MIT
//
// Sites as a file.

import type { Mesh, SurfacePoints } from 'geodesic-voronoi';
import type { GeodesicVoronoiElement } from '../viewer/element.js';
import { readCsvPlaces } from '../../dist/input/csv_places.js';
import { toSizeLimits } from '../../dist/input/limits.js';
import { maxHeaderBytes, readPlyHeader } from '../../dist/input/ply_header.js';
import { readPlyPlaces } from '../../dist/input/ply_reader.js';
import { inSlices } from '../../dist/slices.js';
import { sentence } from '../viewer/failure.js';
import { byId } from './dom.js';
import { hideError, showError, showNoteOnSites } from './feedback.js';
import { counted, integer, measure } from './numbers.js';

/** How far places are from the surface before it is told, in diagonals of the model. */
const mostFar = 0.05;

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

/** A table of coordinates, as the command writes it. */
export async function sitesCsv({ sites, mesh }: GeodesicVoronoiElement): Promise<string> {
  const places = await mesh?.positionsOf(sites);
  const rows = Array.from(sites.face, (_, i) => places?.slice(3 * i, 3 * i + 3).join(','));
  return ['x,y,z', ...rows, ''].join('\n');
}

/** A folder's files of these kinds may be anything; those that are opened one by one are sites. */
export async function isSitesFile(file: File): Promise<boolean> {
  if (file.webkitRelativePath) return false;
  return /\.(json|csv|xyz)$/i.test(file.name) || (isPly(file) && (await isWithoutFaces(file)));
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
    const content = await contentOf(file);
    const sites = await mesh.readPoints(content);
    const far = await farthestFrom(mesh, content);
    if (mesh !== viewer.mesh) return;
    viewer.sites = present(sites);
    tellOfPoints(viewer, file, far);
  } catch (error) {
    showError(sentence(`${name} cannot be opened as sites`, error).message);
  }
}

/**
 * Tells what a file was taken for: a .ply is often meant to be a model, and places far from the surface are
 * often those of another one, or in another unit.
 */
function tellOfPoints(viewer: GeodesicVoronoiElement, file: File, far: number): void {
  const isFar = far > mostFar * (viewer.info?.boundingDiagonal ?? 0);
  if (!isFar && !isPly(file)) return;
  const what = isPly(file) ? `${file.name} has no triangles: the` : 'The';
  const points = counted(viewer.sites.face.length, 'point');
  const how = isFar ? `, up to ${measure(far)} away from the surface` : '';
  showNoteOnSites(viewer, `${what} sites are now where the ${points} of the file are${how}.`, {
    title: 'Undo',
    act: () => viewer.undo(),
  });
}

/** The largest distance from the surface, where points are given by their places. */
async function farthestFrom(mesh: Mesh, content: unknown): Promise<number> {
  type Points = { position?: ArrayLike<number>; face?: unknown; sites?: Points };
  const given = (content ?? {}) as Points;
  const { position, face } = given.sites ?? given;
  // Points on triangles may come with their places, in another unit.
  if (!position || face) return 0;
  const { distance } = await mesh.closestPoints(position);
  return distance.reduce((most, each) => Math.max(most, each), 0);
}

/** The JSON of a file, or the places in a PLY, or in a table of x, y and z. */
async function contentOf(file: File): Promise<unknown> {
  if (!/\.json$/i.test(file.name)) {
    const bytes = new Uint8Array(await file.arrayBuffer());
    const position = isPly(file)
      ? await inSlices(readPlyPlaces(bytes, toSizeLimits({})), {})
      : readCsvPlaces(bytes);
    if (position.length === 0) throw new Error('it has no points');
    const most = Number(byId('count', HTMLInputElement).max);
    if (position.length > 3 * most) {
      const points = integer(position.length / 3);
      throw new Error(`it has ${points} points without triangles, more than ${integer(most)}`);
    }
    return { position };
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
