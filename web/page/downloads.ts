// SPDX-License-Identifier: MIT
import { diagramGlb, diagramJson } from 'geodesic-voronoi';
import type { GeodesicVoronoiElement } from '../viewer/element.js';
import { listen, onClick } from './dom.js';

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
