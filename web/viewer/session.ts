// SPDX-License-Identifier: MIT
//
// The state of a viewer: model, sites, diagram, tessellation, history.

import type { Mesh, Metric } from 'geodesic-voronoi';
import { type PreparedIteration, CvtRun, type CvtSettings } from './cvt_run.js';
import type { PrepareDiagram } from './diagram_geometry.js';
import type { FailureType } from './events.js';
import { sentence } from './failure.js';
import { LatestTask } from './latest_task.js';
import { LibraryLease } from './library_pool.js';
import {
  type OpenedMesh,
  type Opening,
  openMesh,
  type Reader,
  sampleSites,
  type SiteSampling,
} from './mesh_opening.js';
import { RestartableTask } from './restartable_task.js';
import type { CvtStatus, SessionListener, Status } from './session_listener.js';
import {
  changeDiagram,
  computeDiagram,
  type DiagramRequest,
  type DiagramSettings,
  shownDiagram,
  type ShownDiagram,
} from './shown_diagram.js';
import {
  placeOf,
  type PointList,
  SiteHistory,
  type SitePlace,
  type Sites,
  type Tints,
} from './site_history.js';
import { without } from './site_step.js';

/**
 * A model with its sites and their diagram, computed in a worker that starts with the first model.
 * Sites change at once and the diagram follows; if it fails, the sites go back to those of the last
 * diagram. After a change of one site, only its surroundings are computed.
 */
export class Session {
  readonly #prepare: PrepareDiagram;
  readonly #listener: SessionListener;
  readonly #onProgress = (share: number) => this.#listener.progressed(share);
  readonly #history = new SiteHistory();
  readonly #opening = new RestartableTask();
  readonly sampling = new RestartableTask();
  readonly #task = new LatestTask<DiagramRequest>(this.#compute.bind(this));
  #settings: DiagramSettings;
  #lease: LibraryLease | undefined;
  #mesh: Mesh | undefined;
  #shown: ShownDiagram | undefined;
  #cvt: CvtRun | undefined;
  #cvtStatus: CvtStatus = 'idle';
  #computing = false;
  #hasFailed = false;
  #status: Status = 'empty';

  /** `prepare` gets diagrams of the present model. */
  constructor(settings: DiagramSettings, prepare: PrepareDiagram, listener: SessionListener) {
    this.#settings = settings;
    this.#prepare = prepare;
    this.#listener = listener;
  }

  get status(): Status {
    return this.#status;
  }

  get mesh(): Mesh | undefined {
    return this.#mesh;
  }

  get shown(): ShownDiagram | undefined {
    return this.#shown;
  }

  get sites(): Sites {
    return this.#history.present;
  }

  get canUndo(): boolean {
    return this.#history.canUndo;
  }

  get canRedo(): boolean {
    return this.#history.canRedo;
  }

  /** Whether a site is being moved: until `endMove` or `cancelMove`. */
  get isMoving(): boolean {
    return this.#history.isMoving;
  }

  /** Opens a model with so many sites sampled; resolves to whether it is there now. */
  open(read: Reader, how: Opening): Promise<boolean> {
    this.#hasFailed = false;
    return this.#outcome(this.#opening, 'loadfailure', async (signal) => {
      this.#lease ??= new LibraryLease();
      const library = await this.#lease.library.catch((error) => {
        throw sentence('Nothing can be computed', error);
      });
      this.#adopt(await openMesh(library, read, how, { signal, onProgress: this.#onProgress }));
    });
  }

  configure(settings: DiagramSettings): void {
    const { metric, detail } = this.#settings;
    if (settings.metric === metric && settings.detail === detail) return;
    this.#settings = settings;
    // A tessellation under way has its own diagrams; after its pause one has these settings.
    if (!this.#cvt?.playing) this.#request();
  }

  /** Replaces the sites by new ones in new places; resolves to whether they are there now. */
  async sampleSites(siteSampling: SiteSampling): Promise<boolean> {
    const mesh = this.#mesh;
    if (!mesh) return false;
    return this.#outcome(this.sampling, 'computefailure', async (signal) => {
      const task = { signal, onProgress: this.#onProgress };
      const sites = this.#history.createAll(await sampleSites(mesh, siteSampling, task));
      signal.throwIfAborted();
      this.#record(sites);
    });
  }

  /** Resolves to whether a task is carried out. If not, the attributes go back to what is shown. */
  async #outcome(
    task: RestartableTask,
    failure: FailureType,
    work: (signal: AbortSignal) => Promise<void>,
  ): Promise<boolean> {
    const mesh = this.#mesh;
    const outcome = task.run(work);
    this.#updateStatus();
    const isDone = await outcome.catch((error) => {
      this.#fail(error, failure);
      return false;
    });
    if (!isDone && mesh && mesh === this.#mesh && !task.isRunning)
      this.#listener.settingsRestored(this.#settings);
    this.#updateStatus();
    return isDone;
  }

  replaceSites(sites: PointList): void {
    if (this.#mesh) this.#record(this.#history.createAll(sites));
  }

  /** Returns the identity of the new site. */
  addSite(place: SitePlace): number {
    const site = this.#history.create(place);
    this.#record([...this.sites, site]);
    return site.id;
  }

  /** The last of the sites takes its place in the list. */
  removeSite(id: number): void {
    const rest = without(this.sites, id);
    if (rest !== this.sites) this.#record(rest);
  }

  /** Moves a site, if it is there; all moves until `endMove` are one step to undo, or still the last. */
  moveSite(id: number, place: SitePlace, isSameStep = false): void {
    if (!this.#history.move(id, place, isSameStep)) return;
    this.#stopCvt();
    this.#listener.sitesChanged();
    this.#request({ patient: true });
  }

  endMove(): void {
    this.#history.endMove();
    this.#task.hurry();
  }

  /** Puts a site that is being moved back to where it was. */
  cancelMove(): void {
    if (this.#history.cancelMove()) this.#sitesReplaced();
  }

  undo(): void {
    if (!this.isMoving && this.canUndo) this.#step(() => this.#history.undo());
  }

  redo(): void {
    if (!this.isMoving && this.canRedo) this.#step(() => this.#history.redo());
  }

  /** Records a painted density, a step to undo. Ends a tessellation; the next one uses it. */
  recordDensity(tints: Tints): void {
    if (!this.#mesh || (!tints && !this.#history.tints)) return;
    this.#stopCvt();
    this.#history.recordTints(tints);
    this.#listener.sitesChanged();
  }

  // --- Centroidal tessellation ----------------------------------------------------------------
  // All iterations from the first to the last are one step to undo. Any other change of the sites
  // ends the tessellation; the next one begins with the sites as they are then.

  get cvtStatus(): CvtStatus {
    return this.#cvtStatus;
  }

  /** Goes on to the next multiple of so many iterations. */
  playCvt(iterations: number, settings: CvtSettings): void {
    this.#playCvt(settings, (done) => (Math.floor(done / iterations) + 1) * iterations);
  }

  /** Pauses after the next iteration. */
  stepCvt(settings: CvtSettings): void {
    this.#playCvt(settings, (done) => done + 1);
  }

  pauseCvt(): void {
    this.#cvt?.pause();
  }

  /** Back to the sites from before. */
  resetCvt(): void {
    if (!this.#cvt) return;
    const hasMoved = this.#cvt.iteration > 0;
    this.#stopCvt();
    if (hasMoved) this.#history.undo();
    this.#sitesReplaced();
  }

  /** Gives up what is under way. */
  cancel(): void {
    this.#opening.cancel();
    this.sampling.cancel();
    if (this.#cvt?.playing) this.#cvt.pause();
    else this.#task.cancel();
    this.#updateStatus();
  }

  dispose(): void {
    this.#stopCvt();
    this.cancel();
    this.#shown?.diagram?.dispose();
    this.#shown = undefined;
    this.#mesh?.dispose();
    this.#mesh = undefined;
    this.#lease?.release();
    this.#lease = undefined;
  }

  #adopt(opened: OpenedMesh): void {
    const { mesh } = opened;
    const sites = this.#history.createAll(opened.sites);
    this.#stopCvt();
    this.sampling.cancel();
    this.#task.cancel();
    this.#shown?.diagram?.dispose();
    this.#mesh?.dispose();
    this.#shown = undefined;
    this.#mesh = mesh;
    this.#history.reset(sites, opened.tints);
    this.#listener.modelChanged(opened);
    // Sites that a listener has set for the new model are no step: there is nothing to undo.
    this.#history.reset(this.sites, this.#history.tints);
    this.#listener.sitesChanged();
    this.#request();
  }

  /** A step back or forth: it changes the sites or the density. */
  #step(take: () => void): void {
    const { present: sites, tints } = this.#history;
    this.#stopCvt();
    take();
    if (this.#history.tints !== tints) this.#listener.densityChanged(this.#history.tints);
    this.#listener.sitesChanged();
    if (this.sites !== sites) this.#request();
  }

  #record(sites: Sites): void {
    this.#stopCvt();
    this.#history.record(sites);
    this.#sitesReplaced();
  }

  #sitesReplaced(): void {
    this.#listener.sitesChanged();
    this.#request();
  }

  #request(options?: { patient: boolean }): void {
    if (!this.#mesh) return;
    this.#computing = true;
    this.#updateStatus();
    this.#task.request({ ...this.#settings, sites: this.sites }, options);
  }

  async #compute(wanted: DiagramRequest, signal: AbortSignal): Promise<void> {
    const mesh = this.#mesh;
    const before = this.#shown;
    const start = performance.now();
    try {
      const changes = await changeDiagram(before, wanted);
      const diagram = changes
        ? before?.diagram
        : await computeDiagram(mesh, wanted, { signal, onProgress: this.#onProgress });
      const milliseconds = performance.now() - start;
      const isAnew = diagram && !changes && mesh === this.#mesh;
      const prepared = isAnew ? await this.#prepare(diagram.data, wanted.sites) : undefined;
      // An iteration of a tessellation may have been shown meanwhile.
      if (!mesh || mesh !== this.#mesh || (changes && before !== this.#shown)) {
        diagram?.dispose();
        return;
      }
      if (!changes && signal.aborted) {
        diagram?.dispose();
        signal.throwIfAborted();
      }
      const summary = changes
        ? changes.reduce((sum, change) => sum?.after(change, wanted.sites.length), before?.summary)
        : prepared?.summary;
      const shown = shownDiagram(wanted, diagram, summary);
      this.#show(shown);
      this.#listener.diagramChanged(shown, milliseconds, { changes, prepared });
    } catch (error) {
      // A request that follows will show the present sites.
      const isFollowed = this.#task.superseded || this.#cvt?.playing;
      if (!mesh || mesh !== this.#mesh || isFollowed) return;
      if (!signal.aborted) this.#fail(sentence('The diagram cannot be made', error));
      this.#returnToShown(wanted);
    } finally {
      this.#computing = this.#task.superseded;
      this.#updateStatus();
    }
  }

  #show(shown: ShownDiagram): void {
    if (this.#shown?.diagram !== shown.diagram) this.#shown?.diagram?.dispose();
    this.#shown = shown;
  }

  #playCvt(settings: CvtSettings, until: (iterationsDone: number) => number): void {
    if (!this.#mesh || this.sites.length === 0) return;
    this.#history.endMove();
    const wanted = { ...settings, metric: this.#settings.metric };
    if (this.#cvt && (this.#cvt.done || !this.#cvt.hasSettings(wanted))) this.#stopCvt();
    this.#cvt ??= this.#newCvt(this.#mesh, wanted);
    this.#cvt.play(until(this.#cvt.iteration));
    this.#task.cancel();
    this.#updateStatus();
  }

  #newCvt(mesh: Mesh, settings: CvtSettings & { metric: Metric }): CvtRun {
    return new CvtRun(mesh, this.sites, settings, this.#prepare, {
      iterated: (iteration) => this.#showIteration(iteration, settings.metric),
      paused: () => this.#rest(),
      failed: (error) => {
        this.#stopCvt();
        this.#fail(sentence('The sites cannot be moved', error));
        this.#request();
      },
    });
  }

  #showIteration({ state, prepared }: PreparedIteration, metric: Metric): void {
    if (state.iteration > 0) {
      const sites = this.sites.map(({ id }, i) => ({ id, ...placeOf(state.sites, i) }));
      if (state.iteration === 1) this.#history.record(sites);
      else this.#history.revise(sites);
      this.#listener.sitesChanged();
    }
    const settings = { sites: this.sites, metric, detail: 0 };
    const shown = shownDiagram(settings, state.diagram, prepared?.summary);
    this.#show(shown);
    this.#listener.cvtIterated(shown, state, { prepared });
  }

  /**
   * After a pause, the last iteration shown becomes the diagram, without waiting for one under way.
   * It is computed anew only if its metric or detail differs from those wanted. Before the first
   * iteration nothing has been drawn, so nobody is told.
   */
  #rest(): void {
    const shown = this.#shown;
    const { metric, detail } = this.#settings;
    const isWanted = shown?.metric === metric && shown.detail === detail;
    if (!shown?.diagram || shown.sites !== this.sites || !isWanted) {
      this.#request();
      return;
    }
    this.#updateStatus();
    const { latest } = this.#cvt ?? {};
    queueMicrotask(() => {
      if (latest && shown === this.#shown && !this.#cvt?.playing)
        this.#listener.cvtRested(shown, latest.milliseconds);
    });
  }

  #stopCvt(): void {
    this.#cvt?.stop();
    this.#cvt = undefined;
    this.#updateStatus();
  }

  /** Goes back to the shown sites; if no diagram was shown yet, the sites stay without one. */
  #returnToShown(failed: DiagramRequest): void {
    if (!this.#shown) return;
    const { sites, metric, detail, diagram } = this.#shown;
    this.#settings = { metric, detail };
    const { tints } = this.#history;
    this.#history.returnTo(sites);
    if (this.#history.tints !== tints) this.#listener.densityChanged(this.#history.tints);
    this.#listener.settingsRestored(this.#settings);
    this.#listener.sitesChanged();
    // A step that failed has taken the diagram with it.
    if (!diagram && sites.length > 0 && failed.sites !== sites) this.#request();
  }

  #fail(error: unknown, type: FailureType = 'computefailure'): void {
    this.#hasFailed = true;
    // A library that has stopped never answers again; the next model starts another.
    const { code } = ((error as Error).cause ?? error) as { code?: unknown };
    if (code === 'internal' || code === 'load-failed') {
      this.#lease?.discard();
      this.#lease = undefined;
    }
    this.#listener.failed(type, error);
  }

  #statusNow(): Status {
    if (this.#opening.isRunning) return 'loading';
    if (this.#cvt?.playing) return 'iterating';
    if (this.#computing || this.sampling.isRunning) return 'computing';
    if (this.#mesh) return 'ready';
    return this.#hasFailed ? 'failed' : 'empty';
  }

  #updateStatus(): void {
    const status = this.#statusNow();
    if (status !== this.#status) {
      this.#status = status;
      this.#listener.statusChanged(status);
    }
    const cvtStatus = this.#cvt?.status ?? 'idle';
    if (cvtStatus !== this.#cvtStatus) {
      this.#cvtStatus = cvtStatus;
      this.#listener.cvtStatusChanged(cvtStatus);
    }
  }
}
