// SPDX-License-Identifier: MIT
//
// Plays centroidal tessellations of the sites that are edited.

import type { Mesh, Metric } from 'geodesic-voronoi';
import { CvtRun, type CvtSettings, type PreparedIteration } from './cvt_run.js';
import type { LiveDiagram } from './live_diagram.js';
import type { CvtStatus, SessionListener } from './session_listener.js';
import { shallowEqual } from './shallow_equal.js';
import type { PrepareDiagram, ShownDiagram } from './shown_diagram.js';
import { placeOf, type SiteHistory, type Sites } from './site_history.js';

/** What the session does about a tessellation. */
interface CvtUse {
  /** The status may be another one. */
  statusChanged(): void;
  failed(error: unknown): void;
}

/**
 * Moves the sites to the centroids of their regions, and shows every iteration. All iterations from
 * one `play` to the pause after it are one step to undo. Whoever changes the sites otherwise stops it;
 * the next tessellation begins with the sites as they are then.
 */
export class CvtPlayer {
  readonly #history: SiteHistory;
  readonly #diagram: LiveDiagram;
  readonly #prepare: PrepareDiagram;
  readonly #listener: SessionListener;
  readonly #use: CvtUse;
  #run: CvtRun | undefined;
  /** What the run was begun with. */
  #settings: CvtSettings = {};
  /** The sites from before the tessellation. */
  #before: Sites = [];
  /** Whether the next iteration begins a step to undo. */
  #beginsStep = false;

  constructor(
    history: SiteHistory,
    diagram: LiveDiagram,
    prepare: PrepareDiagram,
    listener: SessionListener,
    use: CvtUse,
  ) {
    this.#history = history;
    this.#diagram = diagram;
    this.#prepare = prepare;
    this.#listener = listener;
    this.#use = use;
  }

  get status(): CvtStatus {
    return this.#run?.status ?? 'idle';
  }

  get isPlaying(): boolean {
    return this.status === 'running';
  }

  /** Plays up to the iteration that `until` names, given how many are done. */
  play(settings: CvtSettings, until: (iterationsDone: number) => number): void {
    const { mesh } = this.#diagram;
    if (!mesh || this.#history.present.length === 0) return;
    this.#history.endMove();
    const wanted = { ...settings, metric: this.#diagram.settings.metric };
    const goesOn = this.status !== 'done' && shallowEqual(wanted, this.#settings);
    if (this.#run && !goesOn) this.stop();
    this.#run ??= this.#newRun(mesh, wanted);
    this.#beginsStep ||= !this.isPlaying;
    this.#run.play(until(this.#run.latest.iteration));
    this.#diagram.cancel();
    this.#use.statusChanged();
  }

  pause(): void {
    this.#run?.pause();
  }

  /** Ends the tessellation, if there is one, and goes back to the sites from before; returns whether. */
  reset(): boolean {
    if (!this.#run) return false;
    this.stop();
    this.#history.returnTo(this.#before);
    return true;
  }

  /** Ends the tessellation; the sites stay where they are. */
  stop(): void {
    this.#run?.stop();
    this.#run = undefined;
    this.#use.statusChanged();
  }

  #newRun(mesh: Mesh, settings: CvtSettings & { metric: Metric }): CvtRun {
    this.#settings = settings;
    this.#before = this.#history.present;
    return new CvtRun(mesh, this.#before, settings, this.#prepare, {
      iterated: (iteration) => this.#showIteration(iteration, settings.metric),
      paused: () => this.#rest(),
      failed: (error) => {
        this.stop();
        this.#use.failed(error);
      },
    });
  }

  #showIteration({ state, prepared }: PreparedIteration, metric: Metric): void {
    if (state.iteration > 0) {
      const { present } = this.#history;
      const sites = present.map(({ id }, i) => ({ id, ...placeOf(state.sites, i) }));
      if (this.#beginsStep) this.#history.record(sites);
      else this.#history.revise(sites);
      this.#beginsStep = false;
      this.#listener.sitesChanged();
    }
    const shown: ShownDiagram = {
      sites: this.#history.present,
      metric,
      detail: 0,
      summary: prepared?.summary,
      diagram: state.diagram,
    };
    this.#diagram.shown = shown;
    this.#listener.cvtIterated(shown, state, { prepared });
  }

  /**
   * After a pause, the last iteration shown becomes the diagram, without waiting for one under way.
   * It is computed anew only if its metric or detail differs from those wanted. Before the first
   * iteration nothing has been drawn, so nobody is told.
   */
  #rest(): void {
    const { shown, settings } = this.#diagram;
    const { present } = this.#history;
    const isWanted = shown?.metric === settings.metric && shown.detail === settings.detail;
    if (!shown?.diagram || shown.sites !== present || !isWanted) {
      this.#diagram.request(present);
      return;
    }
    this.#use.statusChanged();
    const { milliseconds } = this.#run?.latest ?? {};
    queueMicrotask(() => {
      if (milliseconds !== undefined && shown === this.#diagram.shown && !this.isPlaying)
        this.#listener.cvtRested(shown, milliseconds);
    });
  }
}
