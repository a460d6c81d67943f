// SPDX-License-Identifier: MIT
import type { CvtSettings } from './core.js';
import type {
  AdvancedCvt,
  CvtForm,
  Engine,
  EngineSources,
  GltfFile,
  Handle,
  OpenedCvt,
  OpenedDiagram,
  OpenedMesh,
} from './engine.js';
import { GeodesicVoronoiError } from './errors.js';
import type { Triangles } from './triangles.js';
import type {
  DiagramChange,
  Located,
  Metric,
  Partition,
  PartitionOptions,
  PolygonMesh,
  RemeshQuality,
  Sampling,
  SurfacePath,
  SurfacePoints,
  TaskOptions,
  VertexDistances,
  Violation,
} from './types.js';
import type { EngineCall, Loaded, Reply, Request, WorkerPort } from './worker_protocol.js';

/** A request that is not answered yet. */
interface Pending {
  resolve(result: unknown): void;
  reject(reason: unknown): void;
  onProgress?(share: number): void;
}

/** An engine in a worker: `worker_server.ts` answers there. */
export class WorkerEngine implements Engine {
  readonly #worker: WorkerPort;
  readonly #pending = new Map<number, Pending>();
  #version = '';
  #lastId = 0;
  #closed: GeodesicVoronoiError | undefined;

  private constructor(worker: WorkerPort) {
    this.#worker = worker;
    worker.onmessage = ({ data }: { data: Reply }) => this.#receive(data);
    worker.onerror = ({ message }) => {
      this.#close(
        this.#version ? 'internal' : 'load-failed',
        `the worker has stopped: ${message || 'its script cannot be loaded'}`,
      );
    };
  }

  static async start(worker: WorkerPort, sources: EngineSources): Promise<WorkerEngine> {
    const engine = new WorkerEngine(worker);
    try {
      engine.#version = (await engine.#request<Loaded>('load', [sources])).version;
      return engine;
    } catch (error) {
      engine.dispose();
      throw error;
    }
  }

  get version(): string {
    return this.#version;
  }

  openMesh(source: Triangles | GltfFile): Promise<OpenedMesh> {
    return this.#request('openMesh', [source]);
  }

  pointsAtVertices(owner: Handle, vertex: Int32Array): Promise<SurfacePoints> {
    return this.#request('pointsAtVertices', [owner, vertex]);
  }

  sampleSites(
    mesh: Handle,
    count: number,
    sampling: Sampling,
    seed: number,
  ): Promise<SurfacePoints> {
    return this.#request('sampleSites', [mesh, count, sampling, seed]);
  }

  openDiagram(
    owner: Handle,
    sites: SurfacePoints,
    options: { metric: Metric; detail: number },
    task: TaskOptions,
  ): Promise<OpenedDiagram> {
    return this.#request('openDiagram', [owner, sites, options], task);
  }

  distances(
    mesh: Handle,
    sites: SurfacePoints,
    metric: Metric,
    task: TaskOptions,
  ): Promise<VertexDistances> {
    return this.#request('distances', [mesh, sites, metric], task);
  }

  path(
    mesh: Handle,
    from: SurfacePoints,
    to: SurfacePoints,
    task: TaskOptions,
  ): Promise<SurfacePath> {
    return this.#request('path', [mesh, from, to], task);
  }

  pathToSite(diagram: Handle, from: SurfacePoints): Promise<SurfacePath> {
    return this.#request('pathToSite', [diagram, from]);
  }

  insertSite(diagram: Handle, site: SurfacePoints): Promise<DiagramChange> {
    return this.#request('insertSite', [diagram, site]);
  }

  moveSite(diagram: Handle, label: number, site: SurfacePoints): Promise<DiagramChange> {
    return this.#request('moveSite', [diagram, label, site]);
  }

  removeSite(diagram: Handle, label: number): Promise<DiagramChange> {
    return this.#request('removeSite', [diagram, label]);
  }

  locate(diagram: Handle, points: SurfacePoints): Promise<Located> {
    return this.#request('locate', [diagram, points]);
  }

  partition(diagram: Handle, options: Required<PartitionOptions>): Promise<Partition> {
    return this.#request('partition', [diagram, options]);
  }

  dual(diagram: Handle, primal: boolean): Promise<PolygonMesh> {
    return this.#request('dual', [diagram, primal]);
  }

  violations(diagram: Handle): Promise<Violation[]> {
    return this.#request('violations', [diagram]);
  }

  quality(diagram: Handle): Promise<RemeshQuality> {
    return this.#request('quality', [diagram]);
  }

  repairingSites(diagram: Handle): Promise<SurfacePoints> {
    return this.#request('repairingSites', [diagram]);
  }

  openCvt(mesh: Handle, sites: SurfacePoints, settings: CvtSettings): Promise<OpenedCvt> {
    return this.#request('openCvt', [mesh, sites, settings]);
  }

  advanceCvt(cvt: Handle, form: CvtForm, task: TaskOptions): Promise<AdvancedCvt | undefined> {
    return this.#request('advanceCvt', [cvt, form], task);
  }

  close(handle: Handle): void {
    if (!this.#closed) this.#post({ close: handle });
  }

  dispose(): void {
    this.#close('disposed', 'the library has been disposed');
  }

  #close(...reason: ConstructorParameters<typeof GeodesicVoronoiError>): void {
    if (this.#closed) return;
    this.#closed = new GeodesicVoronoiError(...reason);
    this.#worker.terminate();
    for (const { reject } of this.#pending.values()) reject(this.#closed);
    this.#pending.clear();
  }

  #post(message: Request): void {
    this.#worker.postMessage(message);
  }

  async #request<Result>(
    call: EngineCall | 'load',
    args: unknown[],
    { signal, onProgress }: TaskOptions = {},
  ): Promise<Result> {
    if (this.#closed) throw this.#closed;
    signal?.throwIfAborted();
    const id = ++this.#lastId;
    let abandon = () => {};
    try {
      return await new Promise<Result>((resolve, reject) => {
        abandon = () => {
          this.#abandon(id);
          reject(signal?.reason);
        };
        signal?.addEventListener('abort', abandon);
        this.#pending.set(id, {
          resolve: resolve as (result: unknown) => void,
          reject,
          onProgress,
        });
        this.#post({ id, call, args } as Request);
      });
    } finally {
      signal?.removeEventListener('abort', abandon);
    }
  }

  /** Nobody waits for this answer any more; if it comes too late to be stopped, it is freed. */
  #abandon(id: number): void {
    this.#pending.set(id, {
      resolve: (late) => {
        const handle = (late as { handle?: Handle } | undefined)?.handle;
        if (handle !== undefined) this.close(handle);
      },
      reject: () => {},
    });
    this.#post({ abort: id });
  }

  #receive(reply: Reply): void {
    const pending = this.#pending.get(reply.id);
    if (!pending) return;
    if ('progress' in reply) {
      this.#report(reply.id, pending, reply.progress);
      return;
    }
    this.#pending.delete(reply.id);
    if ('result' in reply) pending.resolve(reply.result);
    else pending.reject(new GeodesicVoronoiError(reply.error.code, reply.error.message));
  }

  /** What the listener throws ends the task, as it does on one thread. */
  #report(id: number, { onProgress, reject }: Pending, share: number): void {
    try {
      onProgress?.(share);
    } catch (error) {
      this.#abandon(id);
      reject(error);
    }
  }
}
