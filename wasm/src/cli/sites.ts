// SPDX-License-Identifier: MIT
//
// The mesh of a command and its sites: read from files, or sampled.

import { GeodesicVoronoiError } from '../api/errors.js';
import { toPoints } from '../library/arguments.js';
import { load } from '../node.js';
import { requireSameMesh } from '../input/points_file.js';
import type { SurfacePoints } from '../api/results.js';
import { counted, integer, repairSentences } from '../base/sentences.js';
import type { Density } from '../api/options.js';
import type { Mesh } from '../api/types.js';
import { endingOf, type Target } from './encoders.js';
import { FileError, type Output, readModel } from './files.js';
import { areRandom, standard, type Values } from './options.js';
import { nameOf, type NamedPoints, readPoints } from './points.js';
import { withProgress } from './progress.js';
import type { Lengths } from './values.js';

/** The options of every command with sites. (`Values<'info'>` are those of every command.) */
export type SiteValues = Values<'distances'>;
/** Whether standard error gets notes. */
export type Notices = Pick<Values, 'quiet'>;

/** Opens a mesh whose result goes to an output, which may be none of the model's files. */
export async function openMesh(
  path: string,
  output: Output,
  values: Values<'info'>,
): Promise<Mesh> {
  const { files, file } = await readModel(path);
  const gvd = await load();
  const { limits, weld, orientation } = values;
  const { 'max-edge': maxEdge, 'min-component': minComponent } = values;
  const options = { limits, file, maxEdge, weld, orientation, minComponent };
  const mesh = await gvd.mesh(files, options).catch((error: Error) => {
    // The library's option `file` is a part of the path here.
    const isUnclear = error instanceof GeodesicVoronoiError && error.code === 'several-models';
    const advice =
      path === standard ? ', as FILE#PATH of a file that is saved' : `, as ${path}#PATH`;
    throw new FileError(`${nameOf(path)}: ${error.message}${isUnclear ? advice : ''}`, {
      cause: error,
    });
  });
  output.requireNoModel();
  const { format } = mesh.info.origin;
  if (values.units.unit && format !== 'glTF')
    writeNotes([`${format} has no unit: lengths of the model are taken for metres`], values);
  writeNotes(roundingNotes(mesh, values), values);
  return mesh;
}

/** Notes that a model is so far from the origin that the numbers of an STL, of 32 bits, change it. */
function roundingNotes(
  { positions, info }: Mesh,
  { units, ...target }: Target & Pick<Values, 'units'>,
): string[] {
  if (endingOf(target) !== '.stl') return [];
  const visibleShare = 1e-6; // of the diagonal, as where open seams are looked for
  const rounding = 2 ** -24 * greatest(positions);
  if (rounding <= visibleShare * info.boundingDiagonal) return [];
  return [
    `an STL rounds positions to 32 bits, here by up to ${(units.scale * rounding).toPrecision(2)}; .ply and .obj keep all digits`,
  ];
}

function greatest(coordinates: Float64Array): number {
  return coordinates.reduce((most, x) => Math.max(most, Math.abs(x) || 0), 0);
}

/** What the lengths of a result are in: as --units says, or in the model's own unit, which glTF has. */
export function lengthsOf(mesh: Mesh, { units }: Pick<Values, 'units'>): Lengths {
  const isKnown = units.scale === 1 && mesh.info.origin.format === 'glTF';
  return { ...units, unit: units.unit ?? (isKnown ? 'm' : undefined) };
}

export async function openWithSites(
  path: string,
  output: Output,
  values: SiteValues,
  { density, addsSites }: { density?: Density | undefined; addsSites?: boolean } = {},
): Promise<{ mesh: Mesh; sites: SurfacePoints }> {
  const given = typeof values.sites === 'string' ? await readPoints(values.sites) : undefined;
  const mesh = await openMesh(path, output, values);
  const sites = given ? await onSurface(mesh, given, values) : await sampled(mesh, values, density);
  const bare = addsSites ? [] : await bareNotes(mesh, sites, given === undefined);
  writeNotes([...meshNotes(mesh), ...bare], values);
  return { mesh, sites };
}

/** How many sites there are, without the labels whose site was removed. */
export function countOf({ face }: SurfacePoints): number {
  return face.filter((each) => each >= 0).length;
}

export function writeNotes(notes: string[], { quiet }: Notices): void {
  if (!quiet) for (const note of notes) process.stderr.write(`note: ${note}\n`);
}

/** Points that were given; of places in space, the closest points, however far these are. */
export async function onSurface(
  mesh: Mesh,
  given: NamedPoints,
  values: Pick<Values<'diagram'>, 'quiet' | 'units'>,
): Promise<SurfacePoints> {
  try {
    const { name, points, faces } = given;
    const list = toPoints('points', points);
    if ('position' in list) {
      requireSameMesh(given, mesh.info);
      return await closestOf(mesh, name, list.position, values);
    }
    return await mesh.readPoints(faces === undefined ? points : { mesh: { faces }, sites: points });
  } catch (error) {
    throw new FileError(`${given.name}: ${(error as Error).message}`, { cause: error });
  }
}

/** The same of points that all have to be there: none is a label whose site was removed. */
export async function allOnSurface(
  ...[mesh, given, values]: Parameters<typeof onSurface>
): Promise<SurfacePoints> {
  const points = await onSurface(mesh, given, values);
  const removed = points.face.indexOf(-1);
  if (removed < 0) return points;
  throw new FileError(`${given.name}: point ${removed} is a site that was removed`);
}

/** The points closest to places, which messages call by their name. */
async function closestOf(
  mesh: Mesh,
  name: string,
  places: Float64Array,
  { quiet, units }: Pick<Values<'diagram'>, 'quiet' | 'units'>,
): Promise<SurfacePoints> {
  const closest = await mesh.closestPoints(places);
  const farthest = closest.distance.reduce((most, d) => Math.max(most, d), 0);
  const { boundingDiagonal } = mesh.info;
  const isFar = farthest > boundingDiagonal; // of another model, or in another unit
  const rounding = 2 * Number.EPSILON * Math.max(boundingDiagonal, greatest(places));
  if (isFar || (!quiet && farthest > rounding)) {
    const count = closest.face.length;
    const places = count === 1 ? 'the place is' : `the farthest of ${count} places is`;
    process.stderr.write(
      `${isFar ? 'warning' : 'note'}: ${name}: ${places} ${(units.scale * farthest).toPrecision(4)} from the surface\n`,
    );
  }
  return closest;
}

async function sampled(
  mesh: Mesh,
  values: SiteValues,
  wantedDensity: Density | undefined,
): Promise<SurfacePoints> {
  const { sites, radius, sampling, seed, 'per-component': perComponent, units } = values;
  const wanted = radius === undefined ? (sites as number) : { radius: radius / units.scale };
  const density = areRandom(values) ? wantedDensity : undefined;
  const found = await withProgress(values, (onProgress) =>
    mesh.sampleSites(wanted, { sampling, seed, perComponent, density, onProgress }),
  );
  const count = found.face.length;
  if (typeof wanted === 'number' && count < wanted)
    writeNotes([`${integer(count)} of ${counted(wanted, 'site')}: every vertex has one`], values);
  return found;
}

/** Notes what the reader passed over, and where the surface is not the one that its triangles seem to make. */
export function meshNotes({ info: { notes, repairs } }: Mesh): string[] {
  const { nonFiniteTriangles, nonManifoldEdges, orientationCuts } = repairs;
  // Cut edges split vertices, too.
  const splitVertices = nonManifoldEdges + orientationCuts > 0 ? 0 : repairs.splitVertices;
  const told = { nonFiniteTriangles, nonManifoldEdges, orientationCuts, splitVertices };
  return [...notes, ...repairSentences(told)];
}

/** Notes the components that no site is on, if there are any, and options that leave none. */
async function bareNotes(mesh: Mesh, sites: SurfacePoints, areSampled: boolean): Promise<string[]> {
  const { components, area } = mesh.info;
  const bare = await mesh.bareComponents(sites);
  if (bare.components === 0) return [];
  const share = Number(((100 * bare.area) / area).toPrecision(2));
  const enough = Math.max(sites.face.length, components);
  const sampling = `--sites ${enough} --per-component 1 samples one on each, `;
  return [
    `${bare.components} of ${components} components, ${share} % of the area, have no site ` +
      `(${areSampled ? sampling : ''}--min-component drops small ones)`,
  ];
}
