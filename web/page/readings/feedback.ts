// SPDX-License-Identifier: MIT
//
// The page's feedback: the status line, progress, errors of the viewer and times.

import type { GeodesicVoronoiElement, Status, ViewerEvents } from '../../viewer/element.js';
import { byId, listen, onClick } from '../base/dom.js';
import { hideError, hideNote, showError, showNote } from '../base/messages.js';
import { counted, duration, integer, measure } from '../base/numbers.js';

/** Work that is done sooner shows no progress bar: it would only flicker. */
const patienceMilliseconds = 300;
/** Status messages for screen readers wait for the last of several changes. */
const statusMilliseconds = 250;

/** Work that is waited for, by the viewer's status. */
const works: Partial<Record<Status, string>> = {
  loading: 'Opening the model',
  computing: 'Computing the diagram',
};

/** Sets up the status line, progress, errors, times, and facts of the point under the pointer. */
export function setUpFeedback(viewer: GeodesicVoronoiElement): void {
  setUpStatus(viewer);
  setUpProgress(viewer);
  setUpErrors(viewer);
  setUpReadout(viewer);
  setUpTimes(viewer);
  onClick('note-close', hideNote);
  listen(viewer, 'load', hideNote);
}

function setUpStatus(viewer: GeodesicVoronoiElement): void {
  const status = byId('status', HTMLElement);
  let shown = '';
  let waiting = 0;
  const tellSoon = (text: string) => {
    clearTimeout(waiting);
    waiting = window.setTimeout(() => {
      status.textContent = text;
    }, statusMilliseconds);
  };
  listen(viewer, 'diagram', (diagram) => {
    shown = sentenceOf(diagram);
    tellSoon(shown);
  });
  // A model has no diagram if computing the first one fails or is cancelled.
  let endNote = () => {};
  listen(viewer, 'status-change', ({ status: now }) => {
    endNote();
    clearTimeout(waiting);
    const work = works[now];
    if (work) tellSoon(`${work}…`);
    else if (now === 'iterating') tellSoon('Evening out regions…');
    else if (now === 'empty') tellSoon('No model is open.');
    else if (shown) tellSoon(shown);
    if (now !== 'ready' || viewer.diagram || viewer.sites.face.length === 0) return;
    clearTimeout(waiting);
    shown = '';
    status.textContent = 'No diagram: its computation has ended early.';
    const { sites } = viewer;
    const again = { title: 'Compute it', act: () => (viewer.sites = sites) };
    endNote = showNote('The diagram of this model was not computed to its end.', again);
  });
}

function sentenceOf({ sites, milliseconds }: ViewerEvents['diagram']): string {
  if (sites === 0) return 'No sites: add one on the model.';
  return `${counted(sites, 'region')}, computed in ${duration(milliseconds)}`;
}

function setUpProgress(viewer: GeodesicVoronoiElement): void {
  const box = byId('progress', HTMLElement);
  const label = byId('progress-label', HTMLElement);
  const bar = byId('progress-bar', HTMLProgressElement);
  const cancel = onClick('cancel', () => viewer.cancel());
  let waiting = 0;
  listen(viewer, 'status-change', ({ status }) => {
    clearTimeout(waiting);
    const work = works[status];
    if (!work) {
      box.hidden = true;
      cancel.hidden = false;
      return;
    }
    label.textContent = work;
    // Until the first model is there, `early.ts` sets the bar.
    if (!cancel.hidden) bar.removeAttribute('value');
    waiting = window.setTimeout(() => {
      box.hidden = false;
    }, patienceMilliseconds);
  });
  listen(viewer, 'progress', ({ totalProgress }) => {
    if (cancel.hidden) return;
    // What has been computed is still to be made ready for drawing, of which no share is known.
    const isComputed = totalProgress === 1;
    label.textContent = isComputed ? 'Getting ready to draw' : (works[viewer.status] ?? '');
    if (isComputed) bar.removeAttribute('value');
    else bar.value = totalProgress;
  });
}

/** The error of a model that refers to a file that was not opened with it. */
const isIncomplete = /needs the file .+, which is missing\.$/;

function setUpErrors(viewer: GeodesicVoronoiElement): void {
  onClick('error-close', hideError);
  // Without a model, or a diagram, the view itself says why there is none, for as long as that is so.
  const tellNone = (advice: string) => {
    byId('progress', HTMLElement).hidden = true;
    byId('status', HTMLElement).textContent = `No model is open.${advice}`;
  };
  // The element may have found that there is no WebGL before anything listened to it.
  if (viewer.status === 'failed') tellNone('');
  listen(viewer, 'error', ({ type, message }) => {
    if (type === 'webglcontextlost') return; // what is under way goes on
    byId('progress', HTMLElement).hidden = true;
    if (!viewer.loaded) {
      tellNone(type === 'nowebgl' ? '' : ' Reload the page to try again, or open another model.');
    } else if (type === 'loadfailure' || viewer.diagram) {
      const advice = isIncomplete.test(message) ? ' Open both together, or their folder.' : '';
      showError(message + advice);
    }
  });
  // The next attempt shows its own error, if any.
  listen(viewer, 'status-change', ({ status }) => {
    if (status === 'loading') hideError();
  });
}

function setUpReadout(viewer: GeodesicVoronoiElement): void {
  const box = byId('readout', HTMLElement);
  const colour = byId('readout-colour', HTMLElement);
  const text = byId('readout-text', HTMLElement);
  listen(viewer, 'hover', (point) => {
    box.hidden = point === null;
    if (!point) return;
    colour.style.background = point.colour ?? 'gray';
    const { region, area } = point;
    // At the site itself, rounding leaves a tiny distance: far less than a pixel of the region.
    const distance = point.distance < 1e-4 * Math.sqrt(area) ? 0 : point.distance;
    text.textContent =
      region < 0
        ? 'No site reaches this part'
        : `Region ${region} · area ${measure(area)} · ${measure(distance)} from its site`;
  });
}

/** The least and the greatest of areas, as multiples of their mean. */
function spreadOf(areas: Float64Array): string {
  if (areas.length === 0) return '–';
  const mean = areas.reduce((sum, area) => sum + area) / areas.length;
  const sorted = areas.map((area) => area / mean).sort();
  return `${sorted[0].toFixed(2)} to ${sorted.at(-1)!.toFixed(2)} × mean`;
}

/** Shows the counts and areas of the diagram, and the time that each stage took last. */
function setUpTimes(viewer: GeodesicVoronoiElement): void {
  const arcCount = byId('arc-count', HTMLElement);
  const voronoiPointCount = byId('voronoi-point-count', HTMLElement);
  const areas = byId('region-areas', HTMLElement);
  const opening = byId('time-open', HTMLElement);
  const diagram = byId('time-diagram', HTMLElement);
  const drawing = byId('time-draw', HTMLElement);
  const showAreas = () => {
    areas.textContent = spreadOf(viewer.regionAreas);
  };
  let start = performance.now();
  listen(viewer, 'status-change', ({ status }) => {
    if (status === 'loading') start = performance.now();
  });
  listen(viewer, 'load', () => {
    opening.textContent = duration(performance.now() - start);
    for (const cell of [arcCount, voronoiPointCount, areas, diagram, drawing])
      cell.textContent = '–';
  });
  listen(viewer, 'diagram', ({ arcs, voronoiPoints, milliseconds }) => {
    arcCount.textContent = integer(arcs);
    voronoiPointCount.textContent = integer(voronoiPoints);
    showAreas();
    diagram.textContent = duration(milliseconds);
    const drawn = performance.now();
    requestAnimationFrame(() =>
      setTimeout(() => {
        drawing.textContent = duration(performance.now() - drawn);
      }),
    );
  });
  listen(viewer, 'cvt-iteration', showAreas);
}
