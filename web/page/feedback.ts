// SPDX-License-Identifier: MIT
import type { GeodesicVoronoiElement, ViewerEvents } from '../viewer/element.js';
import { byId, listen, onClick } from './dom.js';
import { counted, duration, measure } from './numbers.js';

/** Work that is done sooner shows no progress bar: it would only flicker. */
const patienceMilliseconds = 300;

/** What the page says back: the status line, progress, errors, and what is under the pointer. */
export function setUpFeedback(viewer: GeodesicVoronoiElement): void {
  setUpStatus(viewer);
  setUpProgress(viewer);
  setUpErrors(viewer);
  setUpReadout(viewer);
}

function setUpStatus(viewer: GeodesicVoronoiElement): void {
  const status = byId('status', HTMLElement);
  listen(viewer, 'diagram', (diagram) => {
    status.textContent = sentenceOf(diagram);
  });
}

function sentenceOf({ sites, arcs, voronoiPoints, milliseconds }: ViewerEvents['diagram']): string {
  if (sites === 0) return 'No sites yet: click the model to add one.';
  const parts = [
    counted(sites, 'region'),
    counted(arcs, 'bisector arc'),
    counted(voronoiPoints, 'Voronoi point'),
  ];
  return `${parts.join(', ')} in ${duration(milliseconds)}`;
}

function setUpProgress(viewer: GeodesicVoronoiElement): void {
  const box = byId('progress', HTMLElement);
  const label = byId('progress-label', HTMLElement);
  const bar = byId('progress-bar', HTMLProgressElement);
  onClick('cancel', () => viewer.cancel());
  let waiting = 0;
  listen(viewer, 'status-change', ({ status }) => {
    clearTimeout(waiting);
    const busy = status === 'loading' || status === 'computing';
    if (!busy) {
      box.hidden = true;
      return;
    }
    label.textContent = status === 'loading' ? 'Opening the model' : 'Computing the diagram';
    bar.removeAttribute('value');
    waiting = window.setTimeout(() => {
      box.hidden = false;
    }, patienceMilliseconds);
  });
  listen(viewer, 'progress', ({ totalProgress }) => {
    bar.value = totalProgress;
  });
}

function setUpErrors(viewer: GeodesicVoronoiElement): void {
  const box = byId('error', HTMLElement);
  const text = byId('error-text', HTMLElement);
  const close = () => {
    box.hidden = true;
  };
  onClick('error-close', close);
  listen(viewer, 'error', ({ message }) => {
    text.textContent = message;
    box.hidden = false;
  });
  listen(viewer, 'load', close);
}

function setUpReadout(viewer: GeodesicVoronoiElement): void {
  const box = byId('readout', HTMLElement);
  const colour = byId('readout-colour', HTMLElement);
  const text = byId('readout-text', HTMLElement);
  listen(viewer, 'hover', (point) => {
    box.hidden = point === null;
    if (!point) return;
    colour.style.background = point.colour ?? 'gray';
    text.textContent =
      point.region < 0
        ? 'No site reaches this part'
        : `Region ${point.region + 1} · area ${measure(point.area)} · ${measure(point.distance)} from its site`;
  });
}
