// SPDX-License-Identifier: MIT
//
// Makes the files of the download menu. This code is fetched after the first diagram.

import type { AttributeSource, Diagram, DiagramData, PolygonMesh } from 'geodesic-voronoi';
import type { GeodesicVoronoiElement, Status } from '../../viewer/element.js';
import { linear } from '../../viewer/buffers/colour_vision.js';
import { counted } from '../base/numbers.js';
import { buffersOf } from '../../viewer/buffers/transfer.js';
import { downloadName, type Formats } from './download_rows.js';
import type { Encoding, EncodingRequest } from './encoding_worker.js';
import { outlinesSvg } from './outline_svg.js';
import { sitesCsv, sitesJson } from '../model/sites_file.js';
import { modelName } from '../state/page_state.js';
import { violationSentence } from '../controls/valid_dual.js';

/** What files are made of. */
interface Source {
  viewer: GeodesicVoronoiElement;
  diagram: Diagram;
  mesh: AttributeSource | undefined;
  /** Sentences on what makes the file an invalid mesh, which makers add. */
  violations: (string | undefined)[];
}

/** Makes the content of a file, or says what a worker is to write. */
type Maker = (source: Source) => Promise<string | Encoding>;

const mediaTypes = {
  csv: 'text/csv',
  glb: 'model/gltf-binary',
  json: 'application/json',
  obj: 'model/obj',
  ply: 'application/octet-stream',
  stl: 'model/stl',
  svg: 'image/svg+xml',
  zip: 'application/zip',
};

/** What makes the files, by the rows of the menu and their formats. */
const makers: Record<string, Record<string, Maker>> = {
  outlines: { svg: async ({ viewer, diagram }) => outlinesSvg(viewer, await diagram.fetchData()) },
  sites: {
    json: async ({ viewer }) => JSON.stringify(sitesJson(viewer)),
    csv: ({ viewer }) => sitesCsv(viewer),
  },
  diagram: {
    json: async ({ diagram }) => {
      const data = await diagram.fetchData();
      const { metric, sites } = diagram;
      return ['diagramJson', { metric, sites, data }];
    },
  },
  bisectors: {
    // Copies only the arrays that are needed.
    glb: async ({ diagram }) => {
      const { points, segments } = await bisectorsOf(diagram);
      return ['diagramGlb', { points, segments }];
    },
    obj: async ({ diagram }) => {
      const { points, arcs } = await bisectorsOf(diagram);
      return ['diagramObj', { points, arcs }];
    },
  },
  parts: {
    glb: async (source) => ['partitionGlb', ...(await colouredParts(source))],
    obj: async ({ diagram, mesh }) => ['partitionObj', await diagram.partition(), { mesh }],
    ply: async (source) => ['partitionPly', ...(await colouredParts(source))],
    stl: async ({ diagram }) => ['partitionStls', await diagram.partition()],
  },
  regions: { csv: async ({ diagram }) => ['partitionCsv', await diagram.partition()] },
  polygons: polygonMakers(regionPolygons),
  dual: polygonMakers(dualPolygons),
} satisfies { [Name in Exclude<keyof Formats, 'picture'>]: Record<Formats[Name], Maker> };

async function colouredParts({ viewer, diagram, mesh }: Source) {
  // Now: the viewer may have another diagram by the time the parts are there.
  const colours = coloursOf(viewer);
  return [await diagram.partition(), { mesh, colours }] as const;
}

/** The data of a diagram that has any bisectors: a file without content is of no use. */
async function bisectorsOf(diagram: Diagram): Promise<DiagramData> {
  const data = await diagram.fetchData();
  if (data.segments.points.length === 0) throw new Error('there are no bisectors');
  return data;
}

async function dualPolygons({ diagram, violations }: Source): Promise<PolygonMesh> {
  violations.push(violationSentence('The dual in the file is', await diagram.violations()));
  const dual = await diagram.dual();
  if (dual.faces.offset.length < 2) throw new Error('the dual has no polygons');
  return dual;
}

async function regionPolygons({ viewer, diagram, violations }: Source): Promise<PolygonMesh> {
  // Now: the viewer may have another diagram by the time the polygons are there.
  const areas = viewer.regionAreas;
  violations.push(violationSentence('The polygons in the file are', await diagram.violations()));
  const polygons = await diagram.dual({ primal: true });
  const { faceLabel, faces } = polygons;
  // Files leave out polygons of one or two corners.
  const drawn = new Set(faceLabel.filter((_, i) => faces.offset[i + 1] - faces.offset[i] > 2));
  if (drawn.size === 0) throw new Error('the regions have no polygons');
  const missing = areas.filter((area, label) => area > 0 && !drawn.has(label)).length;
  if (missing > 0)
    violations.push(
      `The file leaves out ${counted(missing, 'region')} of fewer than three corners.`,
    );
  return polygons;
}

/** What makes files of polygons, which may be no valid mesh. */
function polygonMakers(
  polygons: (source: Source) => Promise<PolygonMesh>,
): Record<Formats['dual'], Maker> {
  return {
    glb: async (source) => ['polygonGlb', await polygons(source), { mesh: source.mesh }],
    obj: async (source) => ['polygonObj', await polygons(source), { mesh: source.mesh }],
    ply: async (source) => ['polygonPly', await polygons(source), { mesh: source.mesh }],
    stl: async (source) => ['polygonStl', await polygons(source)],
  };
}

/**
 * Writes a file in a worker of its own. Partitions and polygons are transferred, since nobody else
 * has them; other arguments are copied.
 */
function encoded(encoding: Encoding, type: string): Promise<Blob> {
  const worker = new Worker(new URL('./encoding_worker.ts', import.meta.url), { type: 'module' });
  return new Promise<Blob>((resolve, reject) => {
    worker.onmessage = ({ data }: MessageEvent<Blob | string>) =>
      typeof data === 'string' ? reject(new Error(data)) : resolve(data);
    worker.onerror = ({ message }) => reject(new Error(message || 'its worker cannot be started'));
    worker.addEventListener('messageerror', () =>
      reject(new Error('what its worker has made cannot be received')),
    );
    const [name, result] = encoding;
    const given = name.startsWith('diagram') ? [] : [...buffersOf(result)];
    worker.postMessage({ encoding, type } satisfies EncodingRequest, given);
  }).finally(() => worker.terminate());
}

/** The arrays of a mesh that files need; no others, to avoid copies. */
function sourceOf({ mesh }: GeodesicVoronoiElement): AttributeSource | undefined {
  if (!mesh) return undefined;
  const { positions, indices, normals, uvs } = mesh;
  return { positions, indices, normals, uvs };
}

/** The colours of the regions as they are drawn, in linear RGB. */
function coloursOf(viewer: GeodesicVoronoiElement): number[][] {
  return Array.from(viewer.regionAreas, (_, label) => {
    const colour = viewer.regionColour(label) ?? '#787878';
    return [...linear(parseInt(colour.slice(1), 16))];
  });
}

interface ExportedFile {
  blob: Blob;
  name: string;
  /** The violations of the mesh in it, as sentences; empty if there are none. */
  violations: string;
}

/** The diagram, once it is the one that is asked for. A tessellation that plays is paused. */
async function restingDiagram(viewer: GeodesicVoronoiElement): Promise<Diagram | undefined> {
  if (viewer.cvtStatus === 'running') viewer.pauseCvt();
  const busy: readonly Status[] = ['loading', 'computing', 'iterating'];
  while (busy.includes(viewer.status)) {
    await new Promise((resolve) => {
      viewer.addEventListener('status-change', resolve, { once: true });
    });
  }
  return viewer.diagram;
}

/** A file by the name and the format of its row in the menu; a picture's format is its scale. */
export async function fileOf(
  viewer: GeodesicVoronoiElement,
  name: string,
  format: string,
): Promise<ExportedFile> {
  if (name === 'picture') {
    const scale = parseInt(format, 10);
    const file = downloadName(modelName(viewer), scale === 1 ? name : `${name}@${scale}x`, 'png');
    return { blob: await viewer.toBlob('image/png', undefined, scale), name: file, violations: '' };
  }
  const diagram = await restingDiagram(viewer);
  if (!diagram) throw new Error('there is no diagram');
  // Another model may be opened while the file is made.
  const [model, mesh] = [modelName(viewer), sourceOf(viewer)];
  const violations: string[] = [];
  const made = await makers[name][format]({ viewer, diagram, mesh, violations });
  const ending = name === 'parts' && format === 'stl' ? 'zip' : format;
  const type = mediaTypes[ending as keyof typeof mediaTypes];
  const blob = typeof made === 'string' ? new Blob([made], { type }) : await encoded(made, type);
  return { blob, name: downloadName(model, name, ending), violations: violations.join(' ') };
}
