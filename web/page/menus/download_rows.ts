// SPDX-License-Identifier: MIT
//
// The rows of the menu of downloads, and the names of its files.

/** A row of the menu: a result and the formats it comes in. */
export interface Row {
  title: string;
  hint: string;
  /** The middle of the files' names, `model-name.format`. */
  name: string;
  formats: readonly string[];
}

const meshFormats = ['glb', 'obj', 'ply', 'stl'] as const;

export const rows = [
  {
    title: 'Picture',
    hint: 'The view, as large as it is or larger',
    name: 'picture',
    formats: ['1×', '2×', '3×', '4×'],
  },
  {
    title: 'Outlines',
    hint: 'What is seen of bisectors and the mesh boundary, as lines',
    name: 'outlines',
    formats: ['svg'],
  },
  {
    title: 'Sites',
    hint: 'On triangles, or a table of x, y, z; can be dropped on this page again',
    name: 'sites',
    formats: ['json', 'csv'],
  },
  {
    title: 'Diagram',
    hint: 'Regions, outlines, bisectors, Voronoi points',
    name: 'diagram',
    formats: ['json'],
  },
  {
    title: 'Table of regions',
    hint: 'Area, perimeter, centroid and topology of each',
    name: 'regions',
    formats: ['csv'],
  },
  { title: 'Bisectors', hint: 'As lines in space', name: 'bisectors', formats: ['glb', 'obj'] },
  {
    title: 'Regions as meshes',
    hint: 'The model, cut along the bisectors; STL as a zip, a file for each',
    name: 'parts',
    formats: meshFormats,
  },
  {
    title: 'Regions as polygons',
    hint: 'One each, with Voronoi points as corners; in GLB and STL cut into triangles',
    name: 'polygons',
    formats: meshFormats,
  },
  {
    title: 'Dual',
    hint: 'A vertex per site, a polygon per Voronoi point; in GLB and STL cut into triangles',
    name: 'dual',
    formats: meshFormats,
  },
] as const satisfies readonly Row[];

/** The formats of each name, which `exports.ts` makes. */
export type Formats = { [Each in (typeof rows)[number] as Each['name']]: Each['formats'][number] };

/** What a downloaded file is called, after the file of its model. */
export function downloadName(model: string, name: string, ending: string): string {
  return `${model.replace(/\.[^.]*$/, '') || 'model'}-${name}.${ending}`;
}
