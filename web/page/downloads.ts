// SPDX-License-Identifier: MIT
import type { Diagram, Mesh } from 'geodesic-voronoi';
import type { GeodesicVoronoiElement } from '../viewer/element.js';
import { listen, onClick } from './dom.js';
import { encode } from './encoding.js';

type Source = Pick<Mesh, 'positions' | 'indices' | 'normals' | 'uvs'>;
type Encoder = (diagram: Diagram, options: { mesh?: Source }) => Promise<Blob>;

const mediaTypes = {
  json: 'application/json',
  glb: 'model/gltf-binary',
  obj: 'model/obj',
  ply: 'application/octet-stream',
};

/** What can be had as a mesh in several formats: by its name, then by its ending. */
const meshes: Record<string, Record<string, Encoder>> = {
  parts: {
    glb: async (diagram, options) =>
      encode(mediaTypes.glb, 'partitionGlb', await diagram.partition(), options),
    obj: async (diagram, options) =>
      encode(mediaTypes.obj, 'partitionObj', await diagram.partition(), options),
    ply: async (diagram, options) =>
      encode(mediaTypes.ply, 'partitionPly', await diagram.partition(), options),
  },
  polygons: polygonEncoders(true),
  dual: polygonEncoders(false),
};

function polygonEncoders(primal: boolean): Record<string, Encoder> {
  return {
    glb: async (diagram, options) =>
      encode(mediaTypes.glb, 'polygonGlb', await diagram.dual({ primal }), options),
    obj: async (diagram, options) =>
      encode(mediaTypes.obj, 'polygonObj', await diagram.dual({ primal }), options),
    ply: async (diagram, options) =>
      encode(mediaTypes.ply, 'polygonPly', await diagram.dual({ primal }), options),
  };
}

/** As much of a mesh as files need; what is not needed is not copied. */
function sourceOf({ mesh }: GeodesicVoronoiElement): Source | undefined {
  if (!mesh) return undefined;
  const { positions, indices, normals, uvs } = mesh;
  return { positions, indices, normals, uvs };
}

/** Files to take away, named after the model. */
export function setUpDownloads(viewer: GeodesicVoronoiElement): void {
  let model = 'model';
  listen(viewer, 'load', ({ name }) => {
    model = name.replace(/\.[^.]*$/, '') || 'model';
  });
  const json = (value: unknown) => new Blob([JSON.stringify(value)], { type: 'application/json' });

  const ofDiagram = [
    onClick('download-diagram', async () => {
      if (!viewer.diagram) return;
      const { metric, sites, data } = viewer.diagram;
      const diagram = { metric, sites, data };
      save(await encode(mediaTypes.json, 'diagramJson', diagram), `${model}-diagram.json`);
    }),
    onClick('download-bisectors', async () => {
      if (!viewer.diagram) return;
      const { data } = viewer.diagram;
      save(await encode(mediaTypes.glb, 'diagramGlb', data), `${model}-bisectors.glb`);
    }),
  ];
  for (const [name, encoders] of Object.entries(meshes)) {
    for (const [ending, make] of Object.entries(encoders)) {
      const button = onClick(`download-${name}-${ending}`, async () => {
        if (!viewer.diagram) return;
        const file = await make(viewer.diagram, { mesh: sourceOf(viewer) });
        save(file, `${model}-${name}.${ending}`);
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
