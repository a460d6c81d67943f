// SPDX-License-Identifier: MIT
import { type GeodesicVoronoiElement, type Layer, layers } from '../viewer/element.js';
import { byId } from './dom.js';

const layerTitles: Record<Layer, string> = {
  regions: 'Regions',
  bisectors: 'Bisectors',
  sites: 'Sites',
  'voronoi-points': 'Voronoi points',
  wireframe: 'Wireframe',
};

/** What is shown, and by which distance. */
export function setUpViewControls(viewer: GeodesicVoronoiElement): void {
  setUpLayers(viewer);
  setUpDistance(viewer);
}

function setUpLayers(viewer: GeodesicVoronoiElement): void {
  const group = byId('layers', HTMLElement);
  const boxes = layers.map((layer) => {
    const box = document.createElement('input');
    box.type = 'checkbox';
    box.value = layer;
    box.checked = viewer.layers.includes(layer);
    const title = document.createElement('span');
    title.textContent = layerTitles[layer];
    const label = document.createElement('label');
    label.append(box, title);
    group.append(label);
    return box;
  });
  group.addEventListener('change', () => {
    viewer.layers = boxes.filter((box) => box.checked).map((box) => box.value as Layer);
  });
}

function setUpDistance(viewer: GeodesicVoronoiElement): void {
  const radios = [...document.querySelectorAll<HTMLInputElement>('input[name="metric"]')];
  const detail = byId('detail', HTMLSelectElement);
  for (const radio of radios) {
    radio.addEventListener('change', () => viewer.setAttribute('metric', radio.value));
  }
  detail.addEventListener('change', () => viewer.setAttribute('detail', detail.value));

  // The viewer goes back to what it shows if the choice fails or is cancelled.
  new MutationObserver(() => {
    const metric = viewer.getAttribute('metric') ?? 'dgpc';
    for (const radio of radios) radio.checked = radio.value === metric;
    detail.value = viewer.getAttribute('detail') ?? '0';
  }).observe(viewer, { attributeFilter: ['metric', 'detail'] });
}
