// SPDX-License-Identifier: MIT
import type { CvtStatus, GeodesicVoronoiElement } from '../viewer/element.js';
import { byId, listen, onClick } from './dom.js';
import { EnergyCurve } from './energy_curve.js';
import { integer, measure } from './numbers.js';

const states: Record<CvtStatus, string> = {
  idle: 'Not begun',
  running: 'Running',
  paused: 'Paused',
  done: 'No further improvement',
};

/** The centroidal tessellation: playing it, and how far it has come. */
export function setUpCvtControls(viewer: GeodesicVoronoiElement): void {
  setUpPlaying(viewer);
  setUpReadings(viewer);
}

function setUpPlaying(viewer: GeodesicVoronoiElement): void {
  const fields = {
    'cvt-method': byId('cvt-method', HTMLSelectElement),
    'cvt-iterations': byId('cvt-iterations', HTMLInputElement),
    'cvt-tolerance': byId('cvt-tolerance', HTMLSelectElement),
  };
  for (const [name, field] of Object.entries(fields)) {
    field.addEventListener('change', () => {
      if (field.reportValidity()) viewer.setAttribute(name, field.value);
    });
  }
  const isRunning = () => viewer.cvtStatus === 'running';
  const play = onClick('cvt-play', () => {
    if (isRunning()) viewer.pauseCvt();
    else viewer.playCvt();
  });
  const step = onClick('cvt-step', () => viewer.stepCvt());
  const reset = onClick('cvt-reset', () => viewer.resetCvt());
  const update = () => {
    play.textContent = isRunning() ? 'Pause' : 'Play';
    play.disabled = step.disabled = viewer.sites.face.length === 0;
    reset.disabled = viewer.cvtStatus === 'idle';
  };
  listen(viewer, 'cvt-change', update);
  listen(viewer, 'sites-change', update);
}

/** In plain text: a status that is read out at every iteration would be noise. */
function setUpReadings(viewer: GeodesicVoronoiElement): void {
  const curve = new EnergyCurve(byId('cvt-curve', HTMLElement));
  const state = byId('cvt-state', HTMLElement);
  const iteration = byId('cvt-iteration', HTMLElement);
  const energy = byId('cvt-energy', HTMLElement);
  const move = byId('cvt-move', HTMLElement);
  listen(viewer, 'cvt-iteration', (reached) => {
    // Back at the start it is another tessellation.
    if (reached.iteration === 0) curve.clear();
    curve.add(reached.relativeEnergy);
    iteration.textContent = integer(reached.iteration);
    energy.textContent = `${reached.relativeEnergy.toFixed(4)} × hexagons`;
    energy.title = `${measure(reached.energy)} in the model's units`;
    move.textContent = reached.iteration === 0 ? '–' : measure(reached.largestMove);
  });
  listen(viewer, 'cvt-change', ({ status }) => {
    state.textContent = states[status];
    if (status !== 'idle') return;
    // What they told of is no more: the sites are others.
    curve.clear();
    for (const reading of [iteration, energy, move]) reading.textContent = '–';
    energy.removeAttribute('title');
  });
}
