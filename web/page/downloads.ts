// SPDX-License-Identifier: MIT
import {
  type Diagram,
  diagramGlb,
  diagramJson,
  partitionGlb,
  partitionObj,
  partitionPly,
  type PolygonFileOptions,
  polygonGlb,
  polygonObj,
  polygonPly,
} from 'geodesic-voronoi';
import type { GeodesicVoronoiElement } from '../viewer/element.js';
import { listen, onClick } from './dom.js';

type Content = string | Uint8Array;
type Encoder = (diagram: Diagram, options: PolygonFileOptions) => Promise<Content>;

/** What can be had as a mesh in several formats: by its name, then by its ending. */
const meshes: Record<string, Record<string, Encoder>> = {
  parts: {
    glb: async (diagram, options) => partitionGlb(await diagram.partition(), options),
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

const mediaTypes: Record<string, string> = {
  glb: 'model/gltf-binary',
  obj: 'model/obj',
  ply: 'application/octet-stream',
};

/** Files to take away, named after the model. */
export function setUpDownloads(viewer: GeodesicVoronoiElement): void {
  let model = 'model';
  listen(viewer, 'load', ({ name }) => {
    model = name.replace(/\.[^.]*$/, '') || 'model';
  });
  const json = (value: unknown) => new Blob([JSON.stringify(value)], { type: 'application/json' });

  const ofDiagram = [
    onClick('download-diagram', () => {
      if (viewer.diagram) save(json(diagramJson(viewer.diagram)), `${model}-diagram.json`);
    }),
    onClick('download-bisectors', () => {
      if (!viewer.diagram) return;
      const bytes = diagramGlb(viewer.diagram.data) as Uint8Array<ArrayBuffer>;
      save(new Blob([bytes], { type: 'model/gltf-binary' }), `${model}-bisectors.glb`);
    }),
  ];
  for (const [name, encoders] of Object.entries(meshes)) {
    for (const [ending, encode] of Object.entries(encoders)) {
      const button = onClick(`download-${name}-${ending}`, async () => {
        if (!viewer.diagram) return;
        const content = await encode(viewer.diagram, { mesh: viewer.mesh });
        const type = mediaTypes[ending];
        save(new Blob([content as BlobPart], { type }), `${model}-${name}.${ending}`);
      });
      ofDiagram.push(button);
    }
  }
  onClick('download-sites', () => {
    const { face, bary } = viewer.sites;
    save(json({ face: [...face], bary: [...bary] }), `${model}-sites.json`);
  });
  onClick('download-picture', async () => save(await viewer.toBlob(), `${model}.png`));
  const update = () => {
    for (const button of ofDiagram) button.disabled = viewer.diagram === undefined;
  };
  listen(viewer, 'diagram', update);
  listen(viewer, 'cvt-iteration', update);
}

function save(blob: Blob, name: string): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  // The browser has begun to read it by the next task at the latest; some begin only then.
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
