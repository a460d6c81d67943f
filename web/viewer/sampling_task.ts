// SPDX-License-Identifier: MIT
//
// Placing all sites anew: only the latest request counts.

import type { Mesh } from 'geodesic-voronoi';
import { type PointList, type SiteSampling, sampleSites } from './mesh_opening.js';

export class SamplingTask {
  #running: AbortController | undefined;

  get isRunning(): boolean {
    return this.#running !== undefined;
  }

  /** The sites; undefined if another request followed, or a cancel. Either ends this one. */
  async run(
    mesh: Mesh,
    siteSampling: SiteSampling,
    onProgress: (share: number) => void,
  ): Promise<PointList | undefined> {
    this.cancel();
    this.#running = new AbortController();
    const { signal } = this.#running;
    try {
      const sites = await sampleSites(mesh, siteSampling, { signal, onProgress });
      return signal.aborted ? undefined : sites;
    } catch (error) {
      if (!signal.aborted) throw error;
      return undefined;
    } finally {
      if (!signal.aborted) this.#running = undefined;
    }
  }

  cancel(): void {
    this.#running?.abort();
    this.#running = undefined;
  }
}
