// SPDX-License-Identifier: MIT
import { compile, type CompileAddress, type WasmSource } from './compile.js';
import {
  Core,
  type CvtPointer,
  type CvtSettings,
  type MeshPointer,
  type VoronoiPointer,
} from './core.js';
import { GeodesicVoronoiError } from './errors.js';
import { readGltf } from './gltf.js';
import type { Triangles } from './triangles.js';
import type {
  CvtState,
  DiagramChange,
  DiagramData,
  GltfResources,
  Located,
  MeshInfo,
  MeshPart,
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

/** A mesh, a diagram or a tessellation that an engine keeps; never used twice, so a stale one is known as such. */
export type Handle = number;

export interface GltfFile {
  bytes: Uint8Array;
  resources: GltfResources;
}

/** A mesh opened; `triangles` are those of a glTF, which the caller does not have yet. */
export interface OpenedMesh {
  handle: Handle;
  info: MeshInfo;
  parts: MeshPart[];
  triangles?: Triangles;
}

export interface OpenedDiagram {
  handle: Handle;
  data: DiagramData;
}

export interface OpenedCvt {
  handle: Handle;
}

/** What a state of a tessellation comes with: nothing, the arrays of its diagram, or the diagram too. */
export type CvtForm = 'bare' | 'data' | 'diagram';

/** An iteration; with `handle` that of its diagram. */
export type AdvancedCvt = Omit<CvtState, 'diagram'> & { handle?: Handle };

/**
 * What stands behind the objects of `library.ts`: on this thread (`LocalEngine`) or in a worker
 * (`WorkerEngine`). Arguments are valid in form; everything in and out can be posted to a worker.
 */
export interface Engine {
  readonly version: string;
  openMesh(source: Triangles | GltfFile): Promise<OpenedMesh>;
  /** `owner` is a mesh or a diagram. */
  pointsAtVertices(owner: Handle, vertex: Int32Array): Promise<SurfacePoints>;
  sampleSites(
    mesh: Handle,
    count: number,
    sampling: Sampling,
    seed: number,
  ): Promise<SurfacePoints>;
  /** `owner` is a mesh or a diagram on it. */
  openDiagram(
    owner: Handle,
    sites: SurfacePoints,
    options: { metric: Metric; detail: number },
    task: TaskOptions,
  ): Promise<OpenedDiagram>;
  /** Distances alone, without a diagram. */
  distances(
    mesh: Handle,
    sites: SurfacePoints,
    metric: Metric,
    task: TaskOptions,
  ): Promise<VertexDistances>;
  /** `from` and `to` are one point each. */
  path(
    mesh: Handle,
    from: SurfacePoints,
    to: SurfacePoints,
    task: TaskOptions,
  ): Promise<SurfacePath>;
  /** `from` is one point, from which the path leads to its site. */
  pathToSite(diagram: Handle, from: SurfacePoints): Promise<SurfacePath>;
  /** `site` is one point. */
  insertSite(diagram: Handle, site: SurfacePoints): Promise<DiagramChange>;
  moveSite(diagram: Handle, label: number, site: SurfacePoints): Promise<DiagramChange>;
  removeSite(diagram: Handle, label: number): Promise<DiagramChange>;
  locate(diagram: Handle, points: SurfacePoints): Promise<Located>;
  partition(diagram: Handle, options: Required<PartitionOptions>): Promise<Partition>;
  dual(diagram: Handle, primal: boolean): Promise<PolygonMesh>;
  violations(diagram: Handle): Promise<Violation[]>;
  quality(diagram: Handle): Promise<RemeshQuality>;
  /** The sites that a round of repair adds; none if there is nothing to repair. */
  repairingSites(diagram: Handle): Promise<SurfacePoints>;
  openCvt(mesh: Handle, sites: SurfacePoints, settings: CvtSettings): Promise<OpenedCvt>;
  /** The next iteration, the first time number 0; nothing after the last one. */
  advanceCvt(cvt: Handle, form: CvtForm, task: TaskOptions): Promise<AdvancedCvt | undefined>;
  /** Frees a mesh, a diagram or a tessellation. Those of a mesh stay. */
  close(handle: Handle): void;
  dispose(): void;
}

/** Where to find the two modules. */
export interface EngineSources {
  wasm: WasmSource;
  gltfWasm: WasmSource;
}

/** How long a slice of work may keep its thread from anything else. */
const sliceMilliseconds = 12;
/** Units of work between two looks at the clock: well below a slice, well above its price. */
const unitsPerStep = 256;
/** About the distances' part of the time that a diagram takes; tracing it is the rest. */
const distancesShare = 0.9;

/** The library on the thread that calls it. */
export class LocalEngine implements Engine {
  readonly version: string;
  #core: Core | undefined;
  readonly #gltfModule: () => Promise<WebAssembly.Module>;
  readonly #meshes = new Map<Handle, MeshPointer>();
  readonly #diagrams = new Map<Handle, VoronoiPointer>();
  readonly #cvts = new Map<Handle, CvtPointer>();
  /** Tessellations of which every iteration has been asked for. */
  readonly #finished = new Set<Handle>();
  #lastHandle: Handle = 0;

  private constructor(core: Core, gltfModule: () => Promise<WebAssembly.Module>) {
    this.#core = core;
    this.#gltfModule = gltfModule;
    this.version = core.version;
  }

  static async load(sources: EngineSources, compileAddress: CompileAddress): Promise<LocalEngine> {
    const core = await Core.instantiate(await compile(sources.wasm, compileAddress));
    let gltfModule: Promise<WebAssembly.Module> | undefined;
    return new LocalEngine(core, () => {
      gltfModule ??= compile(sources.gltfWasm, compileAddress).catch((error) => {
        gltfModule = undefined; // the next file tries again
        throw error;
      });
      return gltfModule;
    });
  }

  async openMesh(source: Triangles | GltfFile): Promise<OpenedMesh> {
    if ('positions' in source) return this.#openTriangles(source);
    const { parts, notes, ...triangles } = await readGltf(
      await this.#gltfModule(),
      source.bytes,
      source.resources,
    );
    const { handle, info } = this.#openTriangles(triangles);
    return { handle, info: { ...info, notes }, parts, triangles };
  }

  #openTriangles({ positions, indices }: Triangles): OpenedMesh {
    const core = this.#open();
    const mesh = core.createMesh(positions, indices);
    const info = { ...core.meshInfo(mesh), notes: [] };
    return { handle: this.#keep(this.#meshes, mesh), info, parts: [] };
  }

  async pointsAtVertices(owner: Handle, vertex: Int32Array): Promise<SurfacePoints> {
    return this.#open().pointsAtVertices(this.#surface(owner), vertex);
  }

  async sampleSites(
    mesh: Handle,
    count: number,
    sampling: Sampling,
    seed: number,
  ): Promise<SurfacePoints> {
    return this.#open().sampleSites(this.#mesh(mesh), count, sampling, seed);
  }

  async openDiagram(
    owner: Handle,
    sites: SurfacePoints,
    { metric, detail }: { metric: Metric; detail: number },
    task: TaskOptions,
  ): Promise<OpenedDiagram> {
    const { signal, onProgress } = task;
    const voronoi = await this.#spread(owner, sites, metric, {
      signal,
      onProgress: (share) => onProgress?.(distancesShare * share),
    });
    const core = this.#open();
    try {
      core.startTracing(voronoi, detail);
      await this.#inSlices(() => core.stepTracing(voronoi, unitsPerStep), { signal });
      const data = { siteCount: sites.face.length, ...core.voronoiDiagram(voronoi) };
      onProgress?.(1);
      return { handle: this.#keep(this.#diagrams, voronoi), data };
    } catch (error) {
      core.freeVoronoi(voronoi);
      throw error;
    }
  }

  async distances(
    mesh: Handle,
    sites: SurfacePoints,
    metric: Metric,
    task: TaskOptions,
  ): Promise<VertexDistances> {
    const voronoi = await this.#spread(mesh, sites, metric, task);
    const core = this.#open();
    try {
      return core.distancesAtVertices(voronoi);
    } finally {
      core.freeVoronoi(voronoi);
    }
  }

  async path(
    mesh: Handle,
    from: SurfacePoints,
    to: SurfacePoints,
    task: TaskOptions,
  ): Promise<SurfacePath> {
    const voronoi = await this.#spread(mesh, to, 'exact', task);
    const core = this.#open();
    try {
      return core.pathToSite(voronoi, from);
    } finally {
      core.freeVoronoi(voronoi);
    }
  }

  async pathToSite(diagram: Handle, from: SurfacePoints): Promise<SurfacePath> {
    return this.#open().pathToSite(pointerOf(this.#diagrams, diagram), from);
  }

  /** The distances of sites; whoever gets them frees them. */
  async #spread(
    owner: Handle,
    sites: SurfacePoints,
    metric: Metric,
    { signal, onProgress }: TaskOptions,
  ): Promise<VoronoiPointer> {
    signal?.throwIfAborted();
    const core = this.#open();
    const voronoi = core.startVoronoi(this.#surface(owner), sites, metric);
    try {
      await this.#inSlices(() => core.stepDistances(voronoi, unitsPerStep), {
        signal,
        onProgress: () => onProgress?.(core.voronoiProgress(voronoi)),
      });
      return voronoi;
    } catch (error) {
      core.freeVoronoi(voronoi);
      throw error;
    }
  }

  async openCvt(mesh: Handle, sites: SurfacePoints, settings: CvtSettings): Promise<OpenedCvt> {
    const cvt = this.#open().startCvt(this.#mesh(mesh), sites, settings);
    return { handle: this.#keep(this.#cvts, cvt) };
  }

  async advanceCvt(
    handle: Handle,
    form: CvtForm,
    { signal }: TaskOptions,
  ): Promise<AdvancedCvt | undefined> {
    signal?.throwIfAborted();
    const core = this.#open();
    if (this.#finished.has(handle)) return undefined;
    const cvt = () => pointerOf(this.#cvts, handle); // it may be closed between slices
    await this.#inSlices(() => core.stepCvt(cvt(), unitsPerStep), { signal });
    const { isLast, ...state } = core.cvtIteration(cvt());
    if (isLast) this.#finished.add(handle);
    if (form === 'bare') return state;
    const siteCount = state.sites.face.length;
    const withData = { ...state, data: { siteCount, ...core.cvtDiagram(cvt()) } };
    if (form === 'data') return withData;
    return { ...withData, handle: this.#keep(this.#diagrams, core.cvtVoronoi(cvt())) };
  }

  /**
   * Calls `step` until it says that it is done: in slices, between which the thread serves others,
   * the caller hears of it and may give up.
   */
  async #inSlices(
    step: () => boolean,
    { signal, onProgress }: { signal?: AbortSignal; onProgress?: () => void },
  ): Promise<void> {
    let done = false;
    while (!done) {
      const end = performance.now() + sliceMilliseconds;
      do done = step();
      while (!done && performance.now() < end);
      onProgress?.();
      await nextTask();
      signal?.throwIfAborted();
      this.#open();
    }
  }

  async insertSite(diagram: Handle, site: SurfacePoints): Promise<DiagramChange> {
    return this.#open().insertSite(pointerOf(this.#diagrams, diagram), site);
  }

  async moveSite(diagram: Handle, label: number, site: SurfacePoints): Promise<DiagramChange> {
    return this.#open().moveSite(pointerOf(this.#diagrams, diagram), label, site);
  }

  async removeSite(diagram: Handle, label: number): Promise<DiagramChange> {
    return this.#open().removeSite(pointerOf(this.#diagrams, diagram), label);
  }

  async locate(diagram: Handle, points: SurfacePoints): Promise<Located> {
    const core = this.#open();
    return core.locate(pointerOf(this.#diagrams, diagram), points);
  }

  async partition(diagram: Handle, options: Required<PartitionOptions>): Promise<Partition> {
    return this.#open().partition(pointerOf(this.#diagrams, diagram), options);
  }

  async dual(diagram: Handle, primal: boolean): Promise<PolygonMesh> {
    return this.#open().dual(pointerOf(this.#diagrams, diagram), primal);
  }

  async violations(diagram: Handle): Promise<Violation[]> {
    return this.#open().violations(pointerOf(this.#diagrams, diagram));
  }

  async quality(diagram: Handle): Promise<RemeshQuality> {
    return this.#open().quality(pointerOf(this.#diagrams, diagram));
  }

  async repairingSites(diagram: Handle): Promise<SurfacePoints> {
    return this.#open().repairingSites(pointerOf(this.#diagrams, diagram));
  }

  close(handle: Handle): void {
    const mesh = this.#meshes.get(handle);
    const diagram = this.#diagrams.get(handle);
    if (mesh !== undefined) this.#core?.freeMesh(mesh);
    if (diagram !== undefined) this.#core?.freeVoronoi(diagram);
    const cvt = this.#cvts.get(handle);
    if (cvt !== undefined) this.#core?.freeCvt(cvt);
    this.#cvts.delete(handle);
    this.#finished.delete(handle);
    this.#meshes.delete(handle);
    this.#diagrams.delete(handle);
  }

  /** Lets go of the instance: all its memory at once. */
  dispose(): void {
    this.#core = undefined;
    this.#meshes.clear();
    this.#diagrams.clear();
    this.#cvts.clear();
  }

  #open(): Core {
    if (!this.#core) throw new GeodesicVoronoiError('disposed', 'the library has been disposed');
    return this.#core;
  }

  #mesh(handle: Handle): MeshPointer {
    return pointerOf(this.#meshes, handle);
  }

  #surface(owner: Handle): MeshPointer | VoronoiPointer {
    return this.#diagrams.get(owner) ?? this.#mesh(owner);
  }

  #keep<Pointer>(pointers: Map<Handle, Pointer>, pointer: Pointer): Handle {
    pointers.set(++this.#lastHandle, pointer);
    return this.#lastHandle;
  }
}

function pointerOf<Pointer>(pointers: Map<Handle, Pointer>, handle: Handle): Pointer {
  const pointer = pointers.get(handle);
  if (pointer === undefined)
    throw new GeodesicVoronoiError('disposed', 'the object has been disposed');
  return pointer;
}

/** Lets everything else that waits for this thread have its turn. Not a timer: those are slowed. */
function nextTask(): Promise<void> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(undefined);
  });
}
