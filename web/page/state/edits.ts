// SPDX-License-Identifier: MIT
//
// What was done with the model, and whether it is lost when the model is left.

import type { GeodesicVoronoiElement } from '../../viewer/element.js';
import { listen } from '../base/dom.js';
import { modelName, notHeld } from './page_state.js';

/** Tells whether sites or density were edited, as far as it would be lost. */
export class Edits {
  readonly #viewer: GeodesicVoronoiElement;
  /** Whether there were any before the mesh was built anew: they can no longer be undone. */
  #wereMade = false;
  #areMade = false;

  constructor(viewer: GeodesicVoronoiElement) {
    this.#viewer = viewer;
    listen(viewer, 'load', () => {
      this.#wereMade = this.#areMade;
    });
    listen(viewer, 'sites-change', ({ canUndo }) => {
      this.#areMade = canUndo || this.#wereMade;
    });
  }

  /** Forgets them, since another model has been opened. */
  forget(): void {
    this.#wereMade = this.#areMade = false;
  }

  /** Whether anything was done that the address does not hold. */
  get areLost(): boolean {
    return this.#viewer.loaded && this.#areMade && notHeld(this.#viewer).length > 0;
  }

  /** Whether the model may be left: asks, if anything would be lost. */
  mayBeLeft(): boolean {
    const question = `Leave ${modelName(this.#viewer)}? Not all that was done with it can be brought back.`;
    return !this.areLost || confirm(question);
  }
}
