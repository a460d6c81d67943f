// SPDX-License-Identifier: MIT
import type { CvtStatus, GeodesicVoronoiElement } from '../viewer/element.js';
import { byId, listen, onClick } from './dom.js';
import { EnergyCurve } from './energy_curve.js';
import { integer, measure } from './numbers.js';

/** The centroidal tessellation: playing it, and how far it has come. */
export function setUpCvtControls(viewer: GeodesicVoronoiElement): void {
  setUpPlaying(viewer);
  setUpReadings(viewer);
}

/** What the button that plays says. */
const actions: Record<CvtStatus, string> = {
  idle: 'Even out regions',
  running: 'Pause',
  paused: 'Go on',
  done: 'Even out regions',
};

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
  // Regions that are apart hide what playing does.
  const together = () => {
    if (viewer.exploded > 0) viewer.exploded = 0;
  };
  const play = onClick('cvt-play', () => {
    together();
    if (isRunning()) viewer.pauseCvt();
    else viewer.playCvt();
  });
  const step = onClick('cvt-step', () => {
    together();
    viewer.stepCvt();
  });
  const reset = onClick('cvt-reset', () => viewer.resetCvt());
  const update = () => {
    play.textContent = actions[viewer.cvtStatus];
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
  let reachedIteration = 0;
  listen(viewer, 'cvt-iteration', (reached) => {
    reachedIteration = reached.iteration;
    // Back at the start it is another tessellation.
    if (reached.iteration === 0) curve.clear();
    curve.add(reached.relativeEnergy);
    iteration.textContent = integer(reached.iteration);
    energy.textContent = `${reached.relativeEnergy.toFixed(4)} × hexagons`;
    energy.title = `${measure(reached.energy)} in the model's units`;
    move.textContent = reached.iteration === 0 ? '–' : measure(reached.largestMove);
  });
  const sentence = (status: CvtStatus): string => {
    const tolerance = Number(viewer.getAttribute('cvt-tolerance') ?? 0);
    const planned = Number(viewer.getAttribute('cvt-iterations'));
    switch (status) {
      case 'idle':
        return 'Not begun';
      case 'running':
        return 'Playing';
      case 'done':
        return tolerance > 0 ? `Converged: gains below ${100 * tolerance} %` : 'Converged';
      case 'paused':
        return reachedIteration > 0 && reachedIteration % planned === 0
          ? `Finished ${integer(planned)} iterations`
          : 'Paused';
    }
  };
  listen(viewer, 'cvt-change', ({ status }) => {
    state.textContent = sentence(status);
    if (status !== 'idle') return;
    // What they told of is no more: the sites are others.
    reachedIteration = 0;
    curve.clear();
    for (const reading of [iteration, energy, move]) reading.textContent = '–';
    energy.removeAttribute('title');
  });
}
