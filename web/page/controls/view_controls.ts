// SPDX-License-Identifier: MIT
//
// The controls of the layers that are shown, and of the metric.

import { mostMislabelled } from 'geodesic-voronoi';
import { attributeOf } from '../../viewer/attributes/attribute_defaults.js';
import { type GeodesicVoronoiElement, type Layer, layers } from '../../viewer/element.js';
import { bindAttributes, byId, listen, onClick, watchAttributes } from '../base/dom.js';
import { hasNote, showNote } from '../base/messages.js';
import { make } from '../../viewer/stage/make.js';
import { repairDual, violationSentence } from './valid_dual.js';

/** The titles of the layers, and hints on what they show. */
const layerTexts: Record<Layer, { title: string; hint: string }> = {
  regions: { title: 'Regions', hint: 'A colour for each region' },
  bisectors: { title: 'Bisectors', hint: 'The lines between regions' },
  sites: { title: 'Sites', hint: 'The dots' },
  'voronoi-points': { title: 'Voronoi points', hint: 'Where three regions or more meet' },
  dual: { title: 'Dual', hint: 'Lines that join the sites of neighbouring regions' },
  distances: { title: 'Distances', hint: 'How far it is to the nearest site, along the surface' },
  original: { title: 'Original material', hint: 'The colours and textures of the file' },
  wireframe: { title: 'Wireframe', hint: 'The triangles of the model' },
};

/** Sets up the controls of layers and of the metric. */
export function setUpViewControls(viewer: GeodesicVoronoiElement): void {
  setUpLayers(viewer);
  setUpOriginal(viewer);
  setUpDual(viewer);
  setUpExploded(viewer);
  setUpDistance(viewer);
}

function setUpLayers(viewer: GeodesicVoronoiElement): void {
  const group = byId('layers', HTMLElement);
  const boxes = layers.map((layer) => {
    const box = make('input', { type: 'checkbox', value: layer });
    const { title, hint } = layerTexts[layer];
    group.append(make('label', { title: hint }, box, make('span', {}, title)));
    const late = lateLayers.find((each) => each === layer);
    if (late) markUntilDrawn(viewer, box, late);
    return box;
  });
  group.addEventListener('change', () => {
    viewer.layers = boxes.filter((box) => box.checked).map((box) => box.value as Layer);
  });
  // Painting a density ends the layers that cover it.
  watchAttributes(viewer, ['layers'], () => {
    for (const box of boxes) box.checked = viewer.layers.includes(box.value as Layer);
  });
}

/** Layers that take long to be drawn; an event of the same name tells of it. */
const lateLayers = ['dual', 'distances', 'original'] as const;

/** Marks the box of a layer that is asked for, until it is drawn. */
function markUntilDrawn(
  viewer: GeodesicVoronoiElement,
  box: HTMLInputElement,
  layer: (typeof lateLayers)[number],
): void {
  box.addEventListener('change', () => {
    box.ariaBusy = String(box.checked && (layer === 'original' || viewer.diagram !== undefined));
  });
  // The layer of another model is drawn once its diagram is there: without sites, there is none.
  listen(viewer, 'load', () => {
    const isComing = layer === 'original' || viewer.sites.face.length > 0;
    box.ariaBusy = String(box.checked && isComing);
  });
  const end = () => {
    box.ariaBusy = 'false';
  };
  listen(viewer, layer, end);
  listen(viewer, 'error', end);
}

/** Notes why the file's own material is not shown, if it is not. */
function setUpOriginal(viewer: GeodesicVoronoiElement): void {
  const note = byId('original-note', HTMLElement);
  listen(viewer, 'original', (original) => {
    note.hidden = original?.isFound ?? true;
    note.textContent = original?.problem
      ? `Its own material cannot be shown: ${original.problem}.`
      : 'This file has no colours to show: they are read from glTF and PLY files that have some.';
  });
}

/** Notes whether the dual has the topology of the surface, with a button to repair it. */
function setUpDual(viewer: GeodesicVoronoiElement): void {
  const note = byId('dual-note', HTMLElement);
  const repair = onClick('repair', async () => {
    repair.disabled = true;
    await repairDual(viewer);
    repair.disabled = false;
  });
  listen(viewer, 'dual', (dual) => {
    const violations = violationSentence('The dual is', dual?.violations ?? []);
    note.textContent = violations ?? 'The dual is a valid mesh of the surface.';
    note.hidden = dual === null;
    repair.hidden = violations === undefined;
  });
}

function setUpExploded(viewer: GeodesicVoronoiElement): void {
  const slider = byId('exploded', HTMLInputElement);
  const chips = byId('layers', HTMLFieldSetElement);
  let isDrawn = false;
  slider.addEventListener('input', () => {
    viewer.exploded = Number(slider.value) / 100;
    slider.ariaBusy = String(viewer.exploded > 0 && !isDrawn);
  });
  listen(viewer, 'exploded', (parts) => {
    isDrawn = parts !== null;
    slider.ariaBusy = 'false';
  });
  listen(viewer, 'error', () => {
    slider.ariaBusy = 'false';
  });
  const update = () => {
    slider.disabled = viewer.diagram === undefined;
  };
  for (const type of ['load', 'diagram', 'cvt-iteration'] as const) listen(viewer, type, update);
  // The note explains why a click on these regions does nothing, and ends with the view.
  const end = { title: 'End the exploded view', act: () => (viewer.exploded = 0) };
  let endNote = () => {};
  // A press that turns the model is followed by a click, too.
  let pressedOrbit = '';
  viewer.addEventListener('pointerdown', () => (pressedOrbit = viewer.cameraOrbit));
  viewer.addEventListener('click', () => {
    if (viewer.exploded > 0 && viewer.diagram && viewer.cameraOrbit === pressedOrbit) {
      endNote = showNote('No site can be edited in the exploded view.', end);
    }
  });
  // A link may have set it, and playing a tessellation ends it.
  const show = () => {
    const value = String(Math.round(100 * viewer.exploded));
    if (slider.value !== value) slider.value = value;
    chips.disabled = viewer.exploded > 0;
    chips.title = chips.disabled ? 'The exploded view shows regions alone' : '';
    if (viewer.exploded === 0) endNote();
  };
  watchAttributes(viewer, ['exploded'], show);
}

function setUpDistance(viewer: GeodesicVoronoiElement): void {
  const radios = [...document.querySelectorAll<HTMLInputElement>('input[name="metric"]')];
  for (const radio of radios) {
    radio.addEventListener('change', () => viewer.setAttribute('metric', radio.value));
  }
  // The viewer goes back to what it shows if the choice fails or is cancelled.
  watchAttributes(viewer, ['metric'], () => {
    const metric = attributeOf(viewer, 'metric');
    for (const radio of radios) radio.checked = radio.value === metric;
  });
  bindAttributes(viewer, 'detail');
  offerFinerTriangles(viewer);
}

/**
 * Offers smaller triangles for as long as those of a model are too coarse for its sites, unless another
 * note is shown or the offer has been closed. Sites that only move are not asked for: that would
 * slow down every drag.
 */
function offerFinerTriangles(viewer: GeodesicVoronoiElement): void {
  let asked = '';
  let isTold = false;
  let endNote = () => {};
  listen(viewer, 'load', () => {
    asked = '';
    isTold = false;
  });
  const update = async (about: string) => {
    const { diagram } = viewer;
    // A diagram that is gone needs no offer, and neither does one without sites.
    const accuracy = await diagram?.accuracy().catch(() => undefined);
    if (viewer.diagram !== diagram) return;
    asked = about;
    const hadNote = hasNote();
    endNote();
    const isShown = hadNote && !hasNote();
    const { mislabelled, maxEdge } = accuracy ?? { mislabelled: 0 };
    if (mislabelled <= mostMislabelled) isTold = false;
    else if (!hasNote() && (isShown || !isTold)) {
      isTold = true;
      const share = Number((100 * mislabelled).toPrecision(1));
      endNote = showNote(
        `The triangles are coarse: about ${share} % of the area lies in the wrong region.`,
        {
          title: 'Finer triangles',
          act: () => {
            viewer.setAttribute('max-edge', String(maxEdge));
            if (Number(attributeOf(viewer, 'detail')) === 0) viewer.setAttribute('detail', '1');
          },
        },
      );
    }
  };
  listen(viewer, 'diagram', ({ sites, detail }) => {
    const about = `${sites} ${detail}`;
    if (about !== asked) void update(about);
  });
}
