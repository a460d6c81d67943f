// SPDX-License-Identifier: MIT
//
// A centroidal tessellation that plays, pauses and goes on.

import type { CvtOptions, CvtState, Mesh } from 'geodesic-voronoi';
import type { PreparedDiagram } from '../buffers/diagram_geometry.js';
import type { PrepareDiagram } from './shown_diagram.js';
import { nextFrame } from '../stage/next_frame.js';
import { type Sites, surfacePointsOf } from './site_history.js';

/** How sites move to the centroids of their regions. */
export type CvtSettings = Pick<CvtOptions, 'method' | 'metric' | 'energyTolerance' | 'density'>;

/** An iteration, ready to be drawn. */
export interface PreparedIteration {
  state: CvtState;
  /** Its diagram. */
  prepared: PreparedDiagram | undefined;
  /** From asking for it to having it. */
  milliseconds: number;
}

/** A state, or none after the last one. */
interface TimedState {
  state: CvtState | undefined;
  milliseconds: number;
}

interface CvtRunListener {
  iterated(iteration: PreparedIteration): void;
  /** Called when it stops playing, by itself or on request. */
  paused(): void;
  failed(error: unknown): void;
}

/**
 * A centroidal tessellation that plays up to some iteration and pauses. The next iteration is
 * computed while one is prepared and drawn. A pause takes effect at once: no further iteration is
 * reported, and one that was under way is kept, and reported first when it plays again.
 */
export class CvtRun {
  readonly #listener: CvtRunListener;
  readonly #stopping = new AbortController();
  readonly #sites: Sites;
  readonly #prepare: PrepareDiagram;
  readonly #states: AsyncGenerator<CvtState, void, void>;
  /** The iteration after the last one reported. */
  #asked: Promise<PreparedIteration | undefined> | undefined;
  /** The state after that one. */
  #coming: Promise<TimedState> | undefined;
  #playing: { until: number } | undefined;
  #latest: { iteration: number; milliseconds?: number } = { iteration: 0 };
  #done = false;

  constructor(
    mesh: Mesh,
    sites: Sites,
    settings: CvtSettings,
    prepare: PrepareDiagram,
    listener: CvtRunListener,
  ) {
    this.#sites = sites;
    this.#prepare = prepare;
    this.#listener = listener;
    this.#states = mesh.cvt(surfacePointsOf(sites), {
      ...settings,
      // The caller of `play` decides when it ends.
      iterations: 2 ** 31 - 1,
      diagrams: true,
      signal: this.#stopping.signal,
    });
  }

  /** 'done': no iteration lowers the energy any more. */
  get status(): 'running' | 'paused' | 'done' {
    if (this.#playing) return 'running';
    return this.#done ? 'done' : 'paused';
  }

  /** The number of the last iteration, and from asking for it to having it; 0 also before the first. */
  get latest(): { iteration: number; milliseconds?: number } {
    return this.#latest;
  }

  play(until: number): void {
    const isPlaying = this.#playing !== undefined;
    this.#playing ??= { until };
    this.#playing.until = until;
    if (!isPlaying) void this.#play(this.#playing);
  }

  pause(): void {
    if (!this.#playing) return;
    this.#playing = undefined;
    this.#listener.paused();
  }

  /** Ends it for good; the listener hears nothing any more. */
  stop(): void {
    this.#playing = undefined;
    this.#stopping.abort();
    void this.#states.return();
    // Diagrams that were computed but never reported.
    this.#asked?.then((next) => next?.state.diagram?.dispose()).catch(() => {});
    this.#coming?.then(({ state }) => state?.diagram?.dispose()).catch(() => {});
  }

  async #play(playing: { until: number }): Promise<void> {
    try {
      while (this.#playing === playing) {
        const next = await this.#ask();
        if (this.#playing !== playing) return;
        this.#asked = undefined;
        if (next) {
          this.#latest = { iteration: next.state.iteration, milliseconds: next.milliseconds };
          this.#listener.iterated(next);
        } else {
          this.#done = true;
        }
        if (this.#playing !== playing) return;
        if (!next || next.state.iteration >= playing.until) this.pause();
        else await nextFrame();
      }
    } catch (error) {
      if (this.#playing !== playing) return;
      this.#playing = undefined;
      this.#listener.failed(error);
    }
  }

  #ask(): Promise<PreparedIteration | undefined> {
    if (!this.#asked) {
      this.#asked = this.#prepareNext();
      // After a stop nobody may be waiting to handle a rejection.
      this.#asked.catch(() => {});
    }
    return this.#asked;
  }

  async #prepareNext(): Promise<PreparedIteration | undefined> {
    const { state, milliseconds } = await (this.#coming ?? this.#nextState());
    this.#coming = undefined;
    if (!state) return undefined;
    if (this.#playing && state.iteration < this.#playing.until) {
      this.#coming = this.#nextState();
      this.#coming.catch(() => {});
    }
    const isWanted = !this.#stopping.signal.aborted;
    const prepared =
      state.data && isWanted ? await this.#prepare(state.data, this.#sites) : undefined;
    return { state, prepared, milliseconds };
  }

  async #nextState(): Promise<TimedState> {
    const start = performance.now();
    const { value: state } = await this.#states.next();
    return { state: state ?? undefined, milliseconds: performance.now() - start };
  }
}
