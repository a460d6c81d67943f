// SPDX-License-Identifier: MIT
//
// Placing all sites anew: only the latest request counts.
import type { Mesh } from 'geodesic-voronoi';
import { type PointList, type Scattering, scatterSites } from './mesh_opening.js';

export class ScatterTask {
  #wanted: Scattering | undefined;

  get isRunning(): boolean {
    return this.#wanted !== undefined;
  }

  /** The sites; undefined if another request followed, or a cancel. */
  async run(mesh: Mesh, scattering: Scattering): Promise<PointList | undefined> {
    this.#wanted = scattering;
    const isWanted = () => this.#wanted === scattering;
    try {
      const sites = await scatterSites(mesh, scattering);
      return isWanted() ? sites : undefined;
    } catch (error) {
      if (isWanted()) throw error;
      return undefined;
    } finally {
      if (isWanted()) this.#wanted = undefined;
    }
  }

  cancel(): void {
    this.#wanted = undefined;
  }
}
