// SPDX-License-Identifier: MIT
//
// The diagram of the present sites: computed whenever they change, by the latest request.

import type { Mesh, TaskOptions } from 'geodesic-voronoi';
import { LatestTask } from './latest_task.js';
import type { SessionListener } from './session_listener.js';
import {
  changeDiagram,
  computeDiagram,
  type DiagramRequest,
  type DiagramSettings,
  type PrepareDiagram,
  type ShownDiagram,
} from './shown_diagram.js';
import type { Sites } from './site_history.js';

/** What the session does about a request. */
interface RequestUse {
  /** A computation has begun or ended. */
  computingChanged(): void;
  /** The diagram shown is still the one from before; without an error, the request was given up. */
  failed(request: DiagramRequest, error: unknown): void;
}

/**
 * The diagram that is shown of a mesh. It follows requests, the latest one first, by changes of a
 * site or two where that is enough, and else is computed anew.
 */
export class LiveDiagram {
  readonly #prepare: PrepareDiagram;
  readonly #listener: SessionListener;
  readonly #use: RequestUse;
  readonly #task = new LatestTask<DiagramRequest>(this.#follow.bind(this));
  #settings: DiagramSettings;
  #mesh: Mesh | undefined;
  #shown: ShownDiagram | undefined;
  #isComputing = false;

  constructor(
    settings: DiagramSettings,
    prepare: PrepareDiagram,
    listener: SessionListener,
    use: RequestUse,
  ) {
    this.#settings = settings;
    this.#prepare = prepare;
    this.#listener = listener;
    this.#use = use;
  }

  /** What requests ask for. */
  get settings(): DiagramSettings {
    return this.#settings;
  }

  /** Sets what further requests ask for; returns whether that is something else than before. */
  configure({ metric, detail }: DiagramSettings): boolean {
    const before = this.#settings;
    this.#settings = { metric, detail };
    return metric !== before.metric || detail !== before.detail;
  }

  get mesh(): Mesh | undefined {
    return this.#mesh;
  }

  /** Begins anew, without a diagram; the mesh before is disposed of. */
  set mesh(mesh: Mesh | undefined) {
    this.#task.cancel();
    this.#shown?.diagram?.dispose();
    this.#mesh?.dispose();
    this.#shown = undefined;
    this.#mesh = mesh;
  }

  get shown(): ShownDiagram | undefined {
    return this.#shown;
  }

  /** Takes a diagram that is there already, as an iteration of a tessellation has it. */
  set shown(shown: ShownDiagram) {
    if (this.#shown?.diagram !== shown.diagram) this.#shown?.diagram?.dispose();
    this.#shown = shown;
  }

  get isComputing(): boolean {
    return this.#isComputing;
  }

  /** Asks for the diagram of these sites; with `patient`, one that is under way is shown before. */
  request(sites: Sites, options?: { patient: boolean }): void {
    if (!this.#mesh) return;
    this.#isComputing = true;
    this.#use.computingChanged();
    this.#task.request({ ...this.#settings, sites }, options);
  }

  /** Ends a computation that a patient request waits for. */
  hurry(): void {
    this.#task.hurry();
  }

  cancel(): void {
    this.#task.cancel();
  }

  async #follow(request: DiagramRequest, signal: AbortSignal): Promise<void> {
    const mesh = this.#mesh;
    try {
      const onProgress = (share: number) => this.#listener.progressed(share);
      await this.#compute(request, { signal, onProgress });
    } catch (error) {
      if (mesh && mesh === this.#mesh && !this.#task.superseded)
        this.#use.failed(request, signal.aborted ? undefined : error);
    } finally {
      this.#isComputing = this.#task.superseded;
      this.#use.computingChanged();
    }
  }

  async #compute(request: DiagramRequest, task: TaskOptions): Promise<void> {
    const mesh = this.#mesh;
    const before = this.#shown;
    const start = performance.now();
    const changes = await changeDiagram(before, request);
    const diagram = changes ? before?.diagram : await computeDiagram(mesh, request, task);
    const milliseconds = performance.now() - start;
    const isAnew = diagram && !changes && mesh === this.#mesh;
    const prepared = isAnew ? await this.#prepare(diagram.data, request.sites) : undefined;
    // An iteration of a tessellation may have been shown meanwhile.
    if (!mesh || mesh !== this.#mesh || (changes && before !== this.#shown)) {
      diagram?.dispose();
      return;
    }
    if (!changes && task.signal?.aborted) {
      diagram?.dispose();
      task.signal.throwIfAborted();
    }
    const summary = changes
      ? changes.reduce((sum, change) => sum?.after(change, request.sites.length), before?.summary)
      : prepared?.summary;
    this.shown = { ...request, diagram, summary };
    this.#listener.diagramChanged(this.shown, milliseconds, { changes, prepared });
    // A change is carried out to its end; a cancel in the meantime gives up the request after it.
    task.signal?.throwIfAborted();
  }
}
