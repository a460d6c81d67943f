// SPDX-License-Identifier: MIT
//
// The state of a viewer: model, sites, diagram, tessellation, history.

import type { Mesh } from 'geodesic-voronoi';
import { CvtPlayer } from './cvt_player.js';
import type { CvtSettings } from './cvt_run.js';
import { type FailureType, sentence } from './failure.js';
import { LibraryLease } from './library_pool.js';
import { LiveDiagram } from './live_diagram.js';
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
import type {
  DiagramRequest,
  DiagramSettings,
  PrepareDiagram,
  ShownDiagram,
} from './shown_diagram.js';
import {
  areSamePlaces,
  isSameDensity,
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
  readonly #listener: SessionListener;
  readonly #onProgress = (share: number) => this.#listener.progressed(share);
  readonly #history = new SiteHistory();
  readonly #diagram: LiveDiagram;
  readonly #cvt: CvtPlayer;
  readonly opening = new RestartableTask();
  readonly sampling = new RestartableTask();
  #lease: LibraryLease | undefined;
  /** How the present model was opened, and with which library. */
  #opened: { read: Reader; how: Opening; lease: LibraryLease } | undefined;
  #hasFailed = false;
  #status: Status = 'empty';
  #cvtStatus: CvtStatus = 'idle';

  /** `prepare` gets diagrams of the present model. */
  constructor(settings: DiagramSettings, prepare: PrepareDiagram, listener: SessionListener) {
    this.#listener = listener;
    this.#diagram = new LiveDiagram(settings, prepare, listener, {
      computingChanged: () => this.#updateStatus(),
      failed: (request, error) => this.#requestFailed(request, error),
    });
    this.#cvt = new CvtPlayer(this.#history, this.#diagram, prepare, listener, {
      statusChanged: () => this.#updateStatus(),
      failed: (error) => {
        this.#giveUp(sentence('The sites cannot be moved', error), () => this.#request());
      },
    });
  }

  get status(): Status {
    return this.#status;
  }

  /** What the present model was read by. */
  get reader(): Reader | undefined {
    return this.#opened?.read;
  }

  get mesh(): Mesh | undefined {
    return this.#diagram.mesh;
  }

  get shown(): ShownDiagram | undefined {
    return this.#diagram.shown;
  }

  get sites(): Sites {
    return this.#history.present;
  }

  get tints(): Tints {
    return this.#history.tints;
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

  /** Whether the library of the present mesh has stopped: requests open the model once more. */
  get hasStopped(): boolean {
    return this.#opened !== undefined && this.#opened.lease !== this.#lease;
  }

  /** Opens a model with so many sites sampled; resolves to whether it is there now. */
  open(read: Reader, how: Opening): Promise<boolean> {
    this.#hasFailed = false;
    return this.#outcome(this.opening, 'loadfailure', async (signal) => {
      const lease = (this.#lease ??= new LibraryLease());
      const library = await lease.library.catch((error) => {
        this.#discard(lease);
        throw sentence('Nothing can be computed', error);
      });
      const task = { signal, onProgress: this.#onProgress };
      const opened = await openMesh(library, read, how, task).catch((error) => {
        if (isOfStopped(error)) this.#discard(lease);
        throw error;
      });
      // Only here can nothing come between this look at the signal and the adoption.
      if (signal.aborted) {
        opened.mesh.dispose();
        opened.builder.dispose();
        throw signal.reason;
      }
      this.#opened = { read, how: { ...how, kept: undefined }, lease };
      this.#adopt(opened);
    });
  }

  /** Opens the model once more, in another library, with its density, and its sites or new ones. */
  async reopen(sampling?: SiteSampling): Promise<boolean> {
    if (!this.#opened) return false;
    const { read, how } = this.#opened;
    const siteSampling = sampling ? () => sampling : how.siteSampling;
    const sites = () => (sampling ? undefined : this.sites);
    return this.open(read, { ...how, siteSampling, kept: { sites, tints: () => this.tints } });
  }

  configure(settings: DiagramSettings): void {
    // A tessellation under way has its own diagrams; after its pause one has these settings.
    if (this.#diagram.configure(settings) && !this.#cvt.isPlaying) this.#request();
  }

  /** Replaces the sites by new ones in new places; resolves to whether they are there now. */
  async sampleSites(siteSampling: SiteSampling): Promise<boolean> {
    const { mesh } = this;
    if (!mesh) return false;
    if (this.hasStopped) return this.reopen(siteSampling);
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
    const { mesh } = this;
    const outcome = task.run(work);
    this.#updateStatus();
    let error: unknown;
    const isDone = await outcome.catch((thrown) => {
      error = thrown;
      return false;
    });
    const restore = () => {
      if (mesh && mesh === this.mesh && !task.isRunning)
        this.#listener.settingsRestored(this.#diagram.settings);
    };
    if (!isDone) this.#giveUp(error, restore, failure);
    this.#updateStatus();
    return isDone;
  }

  replaceSites(sites: PointList): void {
    this.#record(this.#history.createAll(sites));
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
    this.#cvt.stop();
    this.#listener.sitesChanged();
    this.#request({ patient: true });
  }

  endMove(): void {
    this.#history.endMove();
    this.#diagram.hurry();
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

  /** Records a painted density, a step to undo if it is another. Ends a tessellation; the next one uses it. */
  recordDensity(tints: Tints): void {
    if (isSameDensity(tints, this.#history.tints)) return;
    this.#cvt.stop();
    this.#history.recordTints(tints);
    this.#listener.sitesChanged();
  }

  get cvtStatus(): CvtStatus {
    return this.#cvtStatus;
  }

  /** Moves the sites to the centroids of their regions, up to the next multiple of so many iterations. */
  playCvt(iterations: number, settings: CvtSettings): void {
    this.#cvt.play(settings, (done) => (Math.floor(done / iterations) + 1) * iterations);
  }

  /** Pauses after the next iteration. */
  stepCvt(settings: CvtSettings): void {
    this.#cvt.play(settings, (done) => done + 1);
  }

  pauseCvt(): void {
    this.#cvt.pause();
  }

  /** Back to the sites from before the tessellation. */
  resetCvt(): void {
    if (this.#cvt.reset()) this.#sitesReplaced();
  }

  /** Gives up what is under way. */
  cancel(): void {
    this.opening.cancel();
    this.sampling.cancel();
    if (this.#cvt.isPlaying) this.#cvt.pause();
    else this.#diagram.cancel();
    this.#updateStatus();
  }

  dispose(): void {
    this.#cvt.stop();
    this.cancel();
    this.#diagram.mesh = undefined;
    this.#lease?.release();
    this.#lease = undefined;
  }

  #adopt(opened: OpenedMesh): void {
    const sites = this.#history.createAll(opened.sites);
    this.#cvt.stop();
    this.sampling.cancel();
    this.#diagram.mesh = opened.mesh;
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
    // A tessellation that ends before its first iteration leaves the present sites without a diagram.
    const { isPlaying } = this.#cvt;
    this.#cvt.stop();
    take();
    if (this.#history.tints !== tints) this.#listener.densityChanged(this.#history.tints);
    this.#listener.sitesChanged();
    if (isPlaying || this.sites !== sites) this.#request();
  }

  /** Replaces the sites, a step to undo unless they are where they were, as those sampled once more. */
  #record(sites: Sites): void {
    this.#cvt.stop();
    if (!areSamePlaces(sites, this.sites)) this.#history.record(sites);
    this.#sitesReplaced();
  }

  #sitesReplaced(): void {
    this.#listener.sitesChanged();
    this.#request();
  }

  #request(options?: { patient: boolean }): void {
    if (!this.hasStopped) this.#diagram.request(this.sites, options);
    // A model that is being opened takes the sites as they are in the end.
    else if (!this.opening.isRunning) void this.reopen();
  }

  #requestFailed(request: DiagramRequest, error: unknown): void {
    if (this.#cvt.isPlaying) return; // its next iteration shows the present sites
    const failure = error && sentence('The diagram cannot be made', error);
    this.#giveUp(failure, () => this.#returnToShown(request));
  }

  /** Goes back to the shown sites; if no diagram was shown yet, the sites stay without one. */
  #returnToShown(failed: DiagramRequest): void {
    const { shown } = this;
    if (!shown) return;
    const { sites, diagram } = shown;
    this.#diagram.configure(shown);
    const { tints } = this.#history;
    this.#history.returnTo(sites);
    if (this.#history.tints !== tints) this.#listener.densityChanged(this.#history.tints);
    this.#listener.settingsRestored(this.#diagram.settings);
    this.#listener.sitesChanged();
    // After a step that failed there is no diagram, and after a library has stopped no mesh.
    const isGone = !diagram || this.hasStopped;
    if (isGone && sites.length > 0 && failed.sites !== sites) this.#request();
  }

  /**
   * Ends work that failed or, without an error, was cancelled. Listeners are told when all is restored, so
   * what they change stays.
   */
  #giveUp(error: unknown, restore: () => void, type: FailureType = 'computefailure'): void {
    if (error) this.#hasFailed = true;
    // An opening has seen to its own library: that may be another one than the present model's.
    if (error && isOfStopped(error) && this.#opened) this.#discard(this.#opened.lease);
    restore();
    if (error) this.#listener.failed(type, error);
  }

  /**
   * Gives up a library that has stopped, and never answers again; another one starts when it is
   * needed, and may have started since.
   */
  #discard(lease: LibraryLease): void {
    lease.discard();
    if (lease === this.#lease) this.#lease = undefined;
  }

  #statusNow(): Status {
    if (this.opening.isRunning) return 'loading';
    if (this.#cvt.isPlaying) return 'iterating';
    if (this.#diagram.isComputing || this.sampling.isRunning) return 'computing';
    if (this.mesh) return 'ready';
    return this.#hasFailed ? 'failed' : 'empty';
  }

  #updateStatus(): void {
    const status = this.#statusNow();
    if (status !== this.#status) {
      this.#status = status;
      this.#listener.statusChanged(status);
    }
    const cvtStatus = this.#cvt.status;
    if (cvtStatus !== this.#cvtStatus) {
      this.#cvtStatus = cvtStatus;
      this.#listener.cvtStatusChanged(cvtStatus);
    }
  }
}

/** Whether an error says that a library has stopped. */
function isOfStopped(error: unknown): boolean {
  const { code } = ((error as Error).cause ?? error) as { code?: unknown };
  return code === 'internal';
}
