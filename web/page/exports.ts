// SPDX-License-Identifier: MIT
//
// What makes the files of the download menu: fetched when the first of them is asked for.

import {
  type Diagram,
  diagramGlb,
  diagramJson,
  diagramObj,
  partitionGlb,
  partitionObj,
  partitionPly,
  type PolygonFileOptions,
  polygonGlb,
  polygonObj,
  polygonPly,
} from 'geodesic-voronoi';
import type { GeodesicVoronoiElement } from '../viewer/element.js';
import { outlinesSvg } from './outline_svg.js';
import { sitesJson } from './sites_file.js';

type Content = string | Uint8Array;
type Encoder = (
  diagram: Diagram,
  options: PolygonFileOptions,
  viewer: GeodesicVoronoiElement,
) => Content | Promise<Content>;

/** Of the diagram: by name, then by format. */
const encoders: Record<string, Record<string, Encoder>> = {
  outlines: { svg: ({ data }, _, viewer) => outlinesSvg(viewer, data) },
  sites: { json: (_, __, viewer) => JSON.stringify(sitesJson(viewer)) },
  diagram: { json: (diagram) => JSON.stringify(diagramJson(diagram)) },
  bisectors: { glb: ({ data }) => diagramGlb(data), obj: ({ data }) => diagramObj(data) },
  parts: {
    glb: async (diagram, options, viewer) =>
      partitionGlb(await diagram.partition(), {
        ...options,
        colourOf: (label) => linear(viewer.regionColour(label)),
      }),
    obj: async (diagram, options) => partitionObj(await diagram.partition(), options),
    ply: async (diagram, options) => partitionPly(await diagram.partition(), options),
  },
  polygons: polygonEncoders(true),
  dual: polygonEncoders(false),
};

function polygonEncoders(primal: boolean): Record<string, Encoder> {
  return {
    glb: async (diagram, options) => polygonGlb(await diagram.dual({ primal }), options),
    obj: async (diagram, options) => polygonObj(await diagram.dual({ primal }), options),
    ply: async (diagram, options) => polygonPly(await diagram.dual({ primal }), options),
  };
}

/** Of a colour as CSS has it: rgb(r, g, b), or #rrggbb. */
function linear(colour = 'rgb(120, 120, 120)'): number[] {
  const numbers = colour.startsWith('#')
    ? [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16))
    : (colour.match(/\d+/g) ?? []).slice(0, 3).map(Number);
  return numbers.map((x) => {
    const c = x / 255;
    return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
  });
}

const mediaTypes: Record<string, string> = {
  glb: 'model/gltf-binary',
  json: 'application/json',
  obj: 'model/obj',
  ply: 'application/octet-stream',
  svg: 'image/svg+xml',
};

/** A file by the name and the format of its row in the menu; a picture's format is its scale. */
export async function fileOf(
  viewer: GeodesicVoronoiElement,
  name: string,
  format: string,
): Promise<{ blob: Blob; ending: string }> {
  if (name === 'picture') {
    return { blob: await viewer.toBlob('image/png', undefined, parseInt(format, 10)), ending: 'png' };
  }
  const { diagram } = viewer;
  if (!diagram) throw new Error('there is no diagram');
  const content = await encoders[name][format](diagram, { mesh: viewer.mesh }, viewer);
  return { blob: new Blob([content as BlobPart], { type: mediaTypes[format] }), ending: format };
}
