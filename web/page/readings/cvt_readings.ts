// SPDX-License-Identifier: MIT
//
// The panel's readings of a centroidal tessellation: its state, energy and moves.

import { attributeOf } from '../../viewer/attributes/attribute_defaults.js';
import type { CvtIteration, CvtStatus, GeodesicVoronoiElement } from '../../viewer/element.js';
import { byId, listen } from '../base/dom.js';
import { EnergyCurve } from './energy_curve.js';
import { integer, measure } from '../base/numbers.js';

/**
 * The progress of a centroidal tessellation, in plain text: a status region, read out at every
 * iteration, would be noise.
 */
export class CvtReadings {
  readonly #viewer: GeodesicVoronoiElement;
  readonly #curve = new EnergyCurve(byId('cvt-curve', HTMLElement));
  readonly #state = byId('cvt-state', HTMLElement);
  readonly #iteration = byId('cvt-iteration', HTMLElement);
  readonly #energy = byId('cvt-energy', HTMLElement);
  readonly #move = byId('cvt-move', HTMLElement);
  #reached = 0;

  constructor(viewer: GeodesicVoronoiElement) {
    this.#viewer = viewer;
    listen(viewer, 'cvt-iteration', (reached) => this.add(reached));
    listen(viewer, 'cvt-change', ({ status }) => this.tell(status));
  }

  add({ iteration, energy, relativeEnergy, largestMove }: CvtIteration): void {
    this.#reached = iteration;
    // Iteration 0 begins another tessellation.
    if (iteration === 0) this.#curve.clear();
    this.#curve.add(relativeEnergy);
    this.#iteration.textContent = integer(iteration);
    this.#energy.textContent = `${relativeEnergy.toFixed(4)} × hexagons`;
    this.#energy.title = `${measure(energy)} in the model's units`;
    this.#move.textContent = iteration === 0 ? '–' : measure(largestMove);
  }

  /** Shows the status. 'idle' clears the readings, because their sites have been replaced. */
  tell(status: CvtStatus): void {
    this.#state.textContent = this.#sentence(status);
    if (status !== 'idle') return;
    this.#reached = 0;
    this.#curve.clear();
    for (const reading of [this.#iteration, this.#energy, this.#move]) reading.textContent = '–';
    this.#energy.removeAttribute('title');
  }

  #sentence(status: CvtStatus): string {
    const tolerance = Number(attributeOf(this.#viewer, 'cvt-tolerance'));
    const planned = Number(attributeOf(this.#viewer, 'cvt-iterations'));
    switch (status) {
      case 'idle':
        return 'Not begun';
      case 'running':
        return 'Playing';
      case 'done':
        return tolerance > 0 ? `Converged: gains below ${100 * tolerance} %` : 'Converged';
      case 'paused':
        return this.#reached > 0 && this.#reached % planned === 0
          ? `Finished ${integer(planned)} iterations`
          : 'Paused';
    }
  }
}
