// SPDX-License-Identifier: MIT
import {
  type CvtState,
  type Diagram,
  type DiagramChange,
  type DiagramData,
  type GeodesicVoronoi,
  loadWorker,
  type Located,
  type Mesh,
  type Metric,
  type Sampling,
  type SurfacePointsInput,
} from 'geodesic-voronoi';
import type { CellTriangles } from './cell_triangles.js';
import { type CvtPicture, CvtRun, type CvtSettings } from './cvt_run.js';
import { DiagramSummary } from './diagram_summary.js';
import { LatestTask } from './latest_task.js';
import type { ModelFiles } from './model_files.js';
import {
  placeOf,
  SiteHistory,
  type SitePlace,
  type Sites,
  surfacePointsOf,
  type Tints,
} from './site_history.js';
import { type SiteStep, stepsBetween, without } from './site_step.js';

export type Status = 'empty' | 'loading' | 'computing' | 'iterating' | 'ready';

/**
 * Where a centroidal tessellation of the present sites stands: 'idle' if none has begun, 'done' if
 * no iteration lowers the energy any more.
 */
export type CvtStatus = 'idle' | 'running' | 'paused' | 'done';

/** How sites are scattered. */
export interface Scattering {
  count: number;
  seed: number;
  sampling?: Sampling;
}

export interface DiagramSettings {
  metric: Metric;
  detail: number;
}

/** A diagram with what it was made from. Its labels are the indices of the sites. */
export interface ShownDiagram extends DiagramSettings {
  sites: Sites;
  /** Without sites there is none. */
  summary: DiagramSummary | undefined;
  /** All of it, put together when asked for if the diagram has been changed: not for every step of a drag. */
  readonly data: DiagramData | undefined;
  diagram: Diagram | undefined;
}

/** What helps to draw a diagram. */
export interface Drawable {
  /** The diagram drawn before has become this one by these. */
  changes?: readonly DiagramChange[];
  /** Its cells, if they have been cut already. */
  cells?: CellTriangles;
}

/** Told what changed, after it did. */
export interface SessionListener {
  modelChanged(mesh: Mesh, name: string): void;
  sitesChanged(sites: Sites): void;
  /** By undoing or redoing; after a failure too. */
  densityChanged(tints: Tints): void;
  diagramChanged(shown: ShownDiagram, milliseconds: number, how: Drawable): void;
  /** Sites and diagram are those of an iteration. */
  cvtIterated(shown: ShownDiagram, state: CvtState, how: Drawable): void;
  /** Iterations have been paused: the one that is shown is the diagram of the sites as any other. */
  cvtRested(shown: ShownDiagram, milliseconds: number): void;
  cvtStatusChanged(status: CvtStatus): void;
  /** After a failure or a cancel: the settings are again those of the diagram that is shown. */
  settingsRestored(settings: DiagramSettings): void;
  statusChanged(status: Status): void;
  progressed(share: number): void;
  /** Whatever failed, the model, the sites and the diagram are those from before. */
  failed(error: unknown): void;
}

type Reader = (signal: AbortSignal, onProgress: (share: number) => void) => Promise<ModelFiles>;
interface Job extends DiagramSettings {
  sites: Sites;
}

/**
 * One model with its sites and their diagram, computed in a worker that starts with the first model.
 * Sites change at once; the diagram follows, and if it cannot, the sites return to those of the
 * diagram there is. Where one site has moved, come or gone, only its surroundings are computed.
 */
export class Session {
  readonly #cut: (data: DiagramData) => Promise<CellTriangles | undefined>;
  readonly #listener: SessionListener;
  readonly #history = new SiteHistory();
  readonly #task = new LatestTask<Job>((job, signal) => this.#compute(job, signal));
  #settings: DiagramSettings = { metric: 'exact', detail: 0 };
  #library: Promise<GeodesicVoronoi> | undefined;
  #opening: AbortController | undefined;
  #mesh: Mesh | undefined;
  #shown: ShownDiagram | undefined;
  #move: { id: number; recorded: boolean } | undefined;
  #cvt: CvtRun | undefined;
  #cvtStatus: CvtStatus = 'idle';
  #scattering: Scattering | undefined;
  #computing = false;
  #status: Status = 'empty';

  /** `cut` makes the cells of a diagram of the present model ready to be drawn. */
  constructor(
    cut: (data: DiagramData) => Promise<CellTriangles | undefined>,
    listener: SessionListener,
  ) {
    this.#cut = cut;
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

  /** Opens a model with so many sites scattered; resolves to whether it is there now. */
  async open(read: Reader, scattering: Scattering): Promise<boolean> {
    this.#opening?.abort();
    const opening = new AbortController();
    this.#opening = opening;
    this.#updateStatus();
    const { signal } = opening;
    let mesh: Mesh | undefined;
    try {
      const library = await this.#loadedLibrary();
      const { name, bytes, resources } = await read(signal, (share) => this.#listener.progressed(share));
      mesh = await library.mesh(bytes, { resources }).catch((error) => {
        throw sentence(`${name} cannot be opened`, error);
      });
      const sites = await scattered(mesh, scattering);
      signal.throwIfAborted();
      this.#adopt(mesh, name, this.#history.createAll(sites));
      return true;
    } catch (error) {
      if (mesh !== this.#mesh) mesh?.dispose();
      if (!signal.aborted) this.#fail(error);
      return false;
    } finally {
      if (this.#opening === opening) {
        this.#opening = undefined;
        this.#updateStatus();
      }
    }
  }

  configure(settings: DiagramSettings): void {
    const { metric, detail } = this.#settings;
    if (settings.metric === metric && settings.detail === detail) return;
    this.#settings = settings;
    // A tessellation under way has diagrams of its own; the pause brings one with these settings.
    if (!this.#cvt?.playing) this.#request();
  }

  /** Sites in new places instead of those there are. */
  async scatter(scattering: Scattering): Promise<void> {
    const mesh = this.#mesh;
    if (!mesh) return;
    this.#scattering = scattering;
    this.#updateStatus();
    // Whether nothing newer has been asked for, nor this been given up.
    const isWanted = () => mesh === this.#mesh && this.#scattering === scattering;
    try {
      const sites = await scattered(mesh, scattering);
      if (isWanted()) this.#record(this.#history.createAll(sites));
    } catch (error) {
      if (isWanted()) this.#fail(error);
    } finally {
      if (isWanted()) this.#scattering = undefined;
      this.#updateStatus();
    }
  }

  replaceSites(sites: { face: ArrayLike<number>; bary: ArrayLike<number> }): void {
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

  /** Moves a site; all moves until `endMove` are one step to undo. */
  moveSite(id: number, { face, bary }: SitePlace): void {
    this.#stopCvt();
    const moved = this.sites.map((site) => (site.id === id ? { id, face, bary } : site));
    if (this.#move?.id !== id) this.#move = { id, recorded: false };
    if (this.#move.recorded) this.#history.revise(moved);
    else this.#history.record(moved);
    this.#move.recorded = true;
    this.#listener.sitesChanged(this.sites);
    this.#request({ patient: true });
  }

  endMove(): void {
    this.#move = undefined;
    this.#task.hurry();
  }

  /** Puts a site that is being moved back to where it was. */
  cancelMove(): void {
    if (!this.#move) return;
    this.#move = undefined;
    this.#history.discard();
    this.#listener.sitesChanged(this.sites);
    this.#request();
  }

  undo(): void {
    if (!this.#move && this.canUndo) this.#step(() => this.#history.undo());
  }

  redo(): void {
    if (!this.#move && this.canRedo) this.#step(() => this.#history.redo());
  }

  /** A density was painted: a step to undo. It ends a tessellation; the next one is by it. */
  recordDensity(tints: Tints): void {
    if (!this.#mesh || (!tints && !this.#history.tints)) return;
    this.#stopCvt();
    this.#history.recordTints(tints);
    this.#listener.sitesChanged(this.sites);
  }

  // --- Centroidal tessellation ----------------------------------------------------------------
  //
  // All iterations from the first to the last are one step to undo. Any other change of the sites
  // ends the tessellation; the next one begins with the sites as they are then.

  get cvtStatus(): CvtStatus {
    return this.#cvtStatus;
  }

  /** The last iteration of the sites there are. */
  get cvtState(): CvtState | undefined {
    return this.#cvt?.latest?.state;
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
    this.#opening?.abort();
    this.#opening = undefined;
    this.#scattering = undefined;
    if (this.#cvt?.playing) this.#cvt.pause();
    else this.#task.cancel();
    this.#updateStatus();
  }

  /** Region and distance by the diagram that is shown; undefined if there is none. */
  async locate(points: SurfacePointsInput): Promise<Located | undefined> {
    try {
      return await this.#shown?.diagram?.locate(points);
    } catch {
      // The diagram was replaced meanwhile; the next answer is about its successor.
      return undefined;
    }
  }

  dispose(): void {
    this.#stopCvt();
    this.cancel();
    this.#mesh = undefined;
    this.#shown = undefined;
    this.#library?.then((library) => library.dispose()).catch(() => {});
    this.#library = undefined;
  }

  #loadedLibrary(): Promise<GeodesicVoronoi> {
    this.#library ??= loadWorker();
    return this.#library;
  }

  #adopt(mesh: Mesh, name: string, sites: Sites): void {
    this.#stopCvt();
    this.#scattering = undefined;
    this.#task.cancel();
    this.#shown?.diagram?.dispose();
    this.#mesh?.dispose();
    this.#shown = undefined;
    this.#move = undefined;
    this.#mesh = mesh;
    this.#history.reset(sites);
    this.#listener.modelChanged(mesh, name);
    this.#listener.sitesChanged(sites);
    this.#request();
  }

  /** A step back or forth: it changes the sites or the density. */
  #step(take: () => void): void {
    const { present: sites, tints } = this.#history;
    this.#stopCvt();
    take();
    if (this.#history.tints !== tints) this.#listener.densityChanged(this.#history.tints);
    if (this.sites !== sites) this.#sitesReplaced();
    else this.#listener.sitesChanged(sites);
  }

  #record(sites: Sites): void {
    this.#stopCvt();
    this.#history.record(sites);
    this.#sitesReplaced();
  }

  #sitesReplaced(): void {
    this.#listener.sitesChanged(this.sites);
    this.#request();
  }

  #request(options?: { patient: boolean }): void {
    if (!this.#mesh) return;
    this.#computing = true;
    this.#updateStatus();
    this.#task.request({ ...this.#settings, sites: this.sites }, options);
  }

  async #compute(job: Job, signal: AbortSignal): Promise<void> {
    const mesh = this.#mesh;
    const before = this.#shown;
    const start = performance.now();
    try {
      const changes = await this.#changeShown(job);
      const diagram = changes ? before?.diagram : await this.#computeAnew(mesh, job, signal);
      const milliseconds = performance.now() - start;
      const isAnew = diagram && !changes && mesh === this.#mesh;
      const cells = isAnew ? await this.#cut(diagram.data) : undefined;
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
        ? changes.reduce((sum, change) => sum?.after(change, job.sites.length), before?.summary)
        : diagram && DiagramSummary.of(diagram.data);
      const shown: ShownDiagram = {
        ...job,
        summary,
        diagram,
        get data() {
          return diagram?.data;
        },
      };
      this.#show(shown);
      this.#listener.diagramChanged(shown, milliseconds, { changes, cells });
    } catch (error) {
      // What follows shows the sites as they are now.
      const isFollowed = this.#task.superseded || this.#cvt?.playing;
      if (!mesh || mesh !== this.#mesh || isFollowed) return;
      if (!signal.aborted) this.#fail(sentence('The diagram cannot be made', error));
      this.#returnToShown();
    } finally {
      this.#computing = this.#task.superseded;
      this.#updateStatus();
    }
  }

  async #computeAnew(
    mesh: Mesh | undefined,
    { sites, metric, detail }: Job,
    signal: AbortSignal,
  ): Promise<Diagram | undefined> {
    if (sites.length === 0) return undefined;
    return mesh?.voronoi(surfacePointsOf(sites), {
      metric,
      detail,
      signal,
      onProgress: (share) => this.#listener.progressed(share),
    });
  }

  /**
   * Makes the diagram that is shown the one asked for, where a step or two do: the work of a few regions,
   * the first time that of a diagram. It is too short to be given up half-way. Undefined if there are no
   * such steps or one failed.
   */
  async #changeShown({ sites, metric, detail }: Job): Promise<DiagramChange[] | undefined> {
    const shown = this.#shown;
    const diagram = shown?.diagram;
    if (!diagram || shown.metric !== metric || shown.detail !== detail) return undefined;
    const steps = sites.length > 0 && stepsBetween(shown.sites, sites);
    if (!steps) return undefined;
    try {
      return await Promise.all(steps.map((step) => takeStep(diagram, step)));
    } catch {
      return undefined; // computed anew, it works or says why not
    }
  }

  #show(shown: ShownDiagram): void {
    if (this.#shown?.diagram !== shown.diagram) this.#shown?.diagram?.dispose();
    this.#shown = shown;
  }

  #playCvt(settings: CvtSettings, until: (iterationsDone: number) => number): void {
    if (!this.#mesh || this.sites.length === 0) return;
    this.#move = undefined;
    const wanted = { ...settings, metric: this.#settings.metric };
    const present = this.#cvt?.settings ?? {};
    const isOther = (Object.keys(wanted) as (keyof CvtSettings)[]).some(
      (name) => wanted[name] !== present[name],
    );
    if (this.#cvt && (isOther || this.#cvt.done)) this.#stopCvt();
    this.#cvt ??= this.#newCvt(this.#mesh, wanted);
    this.#cvt.play(until(this.#cvt.iteration));
    this.#task.cancel();
    this.#updateStatus();
  }

  #newCvt(mesh: Mesh, settings: CvtSettings): CvtRun {
    return new CvtRun(mesh, this.sites, settings, this.#cut, {
      iterated: (picture) => this.#showIteration(picture, settings.metric ?? 'exact'),
      paused: () => this.#rest(),
      failed: (error) => {
        this.#stopCvt();
        this.#fail(sentence('The sites cannot be moved', error));
        this.#request();
      },
    });
  }

  #showIteration({ state, cells }: CvtPicture, metric: Metric): void {
    if (state.iteration > 0) {
      const sites = this.sites.map(({ id }, i) => ({ id, ...placeOf(state.sites, i) }));
      if (state.iteration === 1) this.#history.record(sites);
      else this.#history.revise(sites);
      this.#listener.sitesChanged(sites);
    }
    const shown: ShownDiagram = {
      sites: this.sites,
      metric,
      detail: 0,
      summary: state.data && DiagramSummary.of(state.data),
      get data() {
        return state.diagram?.data;
      },
      diagram: state.diagram,
    };
    this.#show(shown);
    this.#listener.cvtIterated(shown, state, { cells });
  }

  /**
   * After a pause: what is shown is what there is. An iteration under way is not waited for; only if the
   * diagram is to have other settings than those of iterations, it is computed.
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
    const milliseconds = this.#cvt?.latest?.milliseconds ?? 0;
    queueMicrotask(() => {
      if (shown === this.#shown && !this.#cvt?.playing) this.#listener.cvtRested(shown, milliseconds);
    });
  }

  #stopCvt(): void {
    this.#cvt?.stop();
    this.#cvt = undefined;
    this.#updateStatus();
  }

  /** The first diagram of a model has nothing to return to: its sites stay without one. */
  #returnToShown(): void {
    if (!this.#shown) return;
    const { sites, metric, detail } = this.#shown;
    this.#settings = { metric, detail };
    this.#move = undefined;
    const { tints } = this.#history;
    this.#history.returnTo(sites);
    if (this.#history.tints !== tints) this.#listener.densityChanged(this.#history.tints);
    this.#listener.settingsRestored(this.#settings);
    this.#listener.sitesChanged(this.sites);
  }

  #fail(error: unknown): void {
    // A library that has stopped answers nothing any more; the next model starts another.
    const { code } = ((error as Error).cause ?? error) as { code?: unknown };
    if (code === 'internal' || code === 'load-failed') this.#library = undefined;
    this.#listener.failed(error);
  }

  #updateStatus(): void {
    const status = this.#opening
      ? 'loading'
      : this.#cvt?.playing
        ? 'iterating'
        : this.#computing || this.#scattering
          ? 'computing'
          : this.#mesh
            ? 'ready'
            : 'empty';
    if (status !== this.#status) {
      this.#status = status;
      this.#listener.statusChanged(status);
    }
    const cvtStatus = cvtStatusOf(this.#cvt);
    if (cvtStatus !== this.#cvtStatus) {
      this.#cvtStatus = cvtStatus;
      this.#listener.cvtStatusChanged(cvtStatus);
    }
  }
}

function cvtStatusOf(run: CvtRun | undefined): CvtStatus {
  if (!run) return 'idle';
  if (run.playing) return 'running';
  return run.done ? 'done' : 'paused';
}

function takeStep(diagram: Diagram, step: SiteStep): Promise<DiagramChange> {
  if (step.kind === 'remove') return diagram.removeSite(step.index);
  const place = surfacePointsOf([step.site]);
  if (step.kind === 'insert') return diagram.insertSite(place);
  return diagram.moveSite(step.index, place);
}

async function scattered(mesh: Mesh, { count, seed, sampling }: Scattering) {
  return count > 0 ? mesh.sampleSites(count, { seed, sampling }) : { face: [], bary: [] };
}

/** What happened and, from the library, why. */
function sentence(what: string, cause: unknown): Error {
  const why = cause instanceof Error ? cause.message : String(cause);
  return new Error(`${what}: ${why.replace(/\.$/, '')}.`, { cause });
}
