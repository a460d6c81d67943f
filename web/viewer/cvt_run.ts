// SPDX-License-Identifier: MIT
import type { CvtMethod, CvtState, Mesh } from 'geodesic-voronoi';
import { type Sites, surfacePointsOf } from './site_history.js';

/** How sites move to the centroids of their regions; see `CvtOptions` of the library. */
export interface CvtSettings {
  method?: CvtMethod;
  /** Per input vertex. */
  density?: ArrayLike<number>;
}

export interface CvtRunListener {
  iterated(state: CvtState): void;
  /** It plays no more, by itself or because it was told so. */
  paused(): void;
  failed(error: unknown): void;
}

/**
 * A centroidal tessellation on its way: plays until some iteration and pauses. The next iteration is
 * computed while one is drawn; a pause takes effect at once, and what was asked for by then is not
 * lost but shown first when it plays again.
 */
export class CvtRun {
  readonly settings: CvtSettings;
  readonly #listener: CvtRunListener;
  readonly #stopping = new AbortController();
  readonly #states: AsyncGenerator<CvtState, void, void>;
  #asked: Promise<IteratorResult<CvtState, void>> | undefined;
  #playing: { until: number } | undefined;
  #latest: CvtState | undefined;
  #done = false;

  constructor(mesh: Mesh, sites: Sites, settings: CvtSettings, listener: CvtRunListener) {
    this.settings = settings;
    this.#listener = listener;
    this.#states = mesh.cvt(surfacePointsOf(sites), {
      ...settings,
      // Whoever plays decides when it ends.
      iterations: 2 ** 31 - 1,
      data: true,
      signal: this.#stopping.signal,
    });
  }

  get playing(): boolean {
    return this.#playing !== undefined;
  }

  /** Whether no iteration lowers the energy any more. */
  get done(): boolean {
    return this.#done;
  }

  get latest(): CvtState | undefined {
    return this.#latest;
  }

  /** The number of the last iteration; 0 also before it. */
  get iteration(): number {
    return this.#latest?.iteration ?? 0;
  }

  play(until: number): void {
    const isPlaying = this.playing;
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
  }

  async #play(playing: { until: number }): Promise<void> {
    try {
      while (this.#playing === playing) {
        const { value: state } = await this.#ask();
        if (this.#playing !== playing) return;
        this.#asked = undefined;
        if (state && state.iteration < playing.until) void this.#ask();
        if (state) {
          this.#latest = state;
          this.#listener.iterated(state);
        } else {
          this.#done = true;
        }
        if (this.#playing !== playing) return;
        if (!state || state.iteration >= playing.until) this.pause();
        else await nextFrame();
      }
    } catch (error) {
      if (this.#playing !== playing) return;
      this.#playing = undefined;
      this.#listener.failed(error);
    }
  }

  #ask(): Promise<IteratorResult<CvtState, void>> {
    if (!this.#asked) {
      this.#asked = this.#states.next();
      // Nobody may be waiting when it is stopped.
      this.#asked.catch(() => {});
    }
    return this.#asked;
  }
}

/** Lets the page draw and answer; in a hidden page, which draws nothing, just answer. */
function nextFrame(): Promise<void> {
  return new Promise((resolve) => {
    if (document.hidden) setTimeout(resolve);
    else requestAnimationFrame(() => resolve());
  });
}
