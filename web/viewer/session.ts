// SPDX-License-Identifier: MIT
import {
  type Diagram,
  type GeodesicVoronoi,
  loadWorker,
  type Located,
  type Mesh,
  type Metric,
  type SurfacePointsInput,
} from 'geodesic-voronoi';
import { LatestTask } from './latest_task.js';
import type { ModelFiles } from './model_files.js';
import { SiteHistory, type SitePlace, type Sites, surfacePointsOf } from './site_history.js';

export type Status = 'empty' | 'loading' | 'computing' | 'ready';

export interface DiagramSettings {
  metric: Metric;
  detail: number;
}

/** A diagram with what it was made from; without sites there is none. */
export interface ShownDiagram extends DiagramSettings {
  sites: Sites;
  diagram: Diagram | undefined;
  milliseconds: number;
}

/** Told what changed, after it did. */
export interface SessionListener {
  modelChanged(mesh: Mesh, name: string): void;
  sitesChanged(sites: Sites): void;
  diagramChanged(shown: ShownDiagram): void;
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
 * diagram there is.
 */
export class Session {
  readonly #listener: SessionListener;
  readonly #history = new SiteHistory();
  readonly #task = new LatestTask<Job>((job, signal) => this.#compute(job, signal));
  #settings: DiagramSettings = { metric: 'dgpc', detail: 0 };
  #library: Promise<GeodesicVoronoi> | undefined;
  #opening: AbortController | undefined;
  #mesh: Mesh | undefined;
  #shown: ShownDiagram | undefined;
  #move: { id: number; recorded: boolean } | undefined;
  #computing = false;
  #status: Status = 'empty';

  constructor(listener: SessionListener) {
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
  async open(read: Reader, { count, seed }: { count: number; seed: number }): Promise<boolean> {
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
      const sites = count > 0 ? await mesh.sampleSites(count, { seed }) : { face: [], bary: [] };
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
    this.#request();
  }

  /** Sites in random places instead of those there are. */
  async scatter(count: number, seed: number): Promise<void> {
    const mesh = this.#mesh;
    if (!mesh) return;
    try {
      const sites = count > 0 ? await mesh.sampleSites(count, { seed }) : { face: [], bary: [] };
      if (mesh === this.#mesh) this.#record(this.#history.createAll(sites));
    } catch (error) {
      if (mesh === this.#mesh) this.#fail(error);
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

  removeSite(id: number): void {
    const rest = this.sites.filter((site) => site.id !== id);
    if (rest.length < this.sites.length) this.#record(rest);
  }

  /** Moves a site; all moves until `endMove` are one step to undo. */
  moveSite(id: number, { face, bary }: SitePlace): void {
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
    if (this.#move || !this.canUndo) return;
    this.#history.undo();
    this.#sitesReplaced();
  }

  redo(): void {
    if (this.#move || !this.canRedo) return;
    this.#history.redo();
    this.#sitesReplaced();
  }

  /** Gives up what is under way. */
  cancel(): void {
    this.#opening?.abort();
    this.#opening = undefined;
    this.#task.cancel();
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

  #record(sites: Sites): void {
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

  async #compute({ sites, metric, detail }: Job, signal: AbortSignal): Promise<void> {
    const mesh = this.#mesh;
    const start = performance.now();
    try {
      const diagram =
        sites.length > 0
          ? await mesh?.voronoi(surfacePointsOf(sites), {
              metric,
              detail,
              signal,
              onProgress: (share) => this.#listener.progressed(share),
            })
          : undefined;
      if (!mesh || mesh !== this.#mesh) {
        diagram?.dispose();
        return;
      }
      this.#shown?.diagram?.dispose();
      const milliseconds = performance.now() - start;
      this.#shown = { sites, metric, detail, diagram, milliseconds };
      this.#listener.diagramChanged(this.#shown);
    } catch (error) {
      if (!mesh || mesh !== this.#mesh || this.#task.superseded) return;
      if (!signal.aborted) this.#fail(sentence('The diagram cannot be made', error));
      this.#returnToShown();
    } finally {
      this.#computing = this.#task.superseded;
      this.#updateStatus();
    }
  }

  /** The first diagram of a model has nothing to return to: its sites stay without one. */
  #returnToShown(): void {
    if (!this.#shown) return;
    const { sites, metric, detail } = this.#shown;
    this.#settings = { metric, detail };
    this.#move = undefined;
    this.#history.returnTo(sites);
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
      : this.#computing
        ? 'computing'
        : this.#mesh
          ? 'ready'
          : 'empty';
    if (status === this.#status) return;
    this.#status = status;
    this.#listener.statusChanged(status);
  }
}

/** What happened and, from the library, why. */
function sentence(what: string, cause: unknown): Error {
  const why = cause instanceof Error ? cause.message : String(cause);
  return new Error(`${what}: ${why.replace(/\.$/, '')}.`, { cause });
}
