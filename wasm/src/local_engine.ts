// SPDX-License-Identifier: MIT
//
// The library on the thread that calls it: objects in core.wasm, and long work in slices.

import { compile, type CompileAddress } from './compile.js';
import type {
  AdvancedCvt,
  CvtForm,
  CvtSettings,
  DiagramForm,
  Engine,
  EngineSources,
  FileInput,
  Handle,
  MeshBuild,
  OpenedCvt,
  OpenedDiagram,
  OpenedMesh,
} from './engine.js';
import { GeodesicVoronoiError } from './errors.js';
import { type InputModules, readModel } from './input/read_model.js';
import { settled } from './kept.js';
import type {
  DiagramData,
  MeshInfo,
  MeshPart,
  Metric,
  SurfacePoints,
  VertexDistances,
} from './results.js';
import { inSlices, nextTask, sliceMilliseconds } from './slices.js';
import {
  type Subdivision,
  subdividedParts,
  subdividedTriangles,
  subdivisionNote,
} from './subdivision.js';
import type { Triangles } from './triangles.js';
import type { TaskOptions } from './types.js';
import {
  type Argument,
  sliceDone,
  sliceMoreToDo,
  unitsPerStep,
  WasmModule,
} from './wasm_module.js';

/** Numbers that are copied between two looks at the clock. */
const numbersPerStep = 2 ** 15;
/** The approximate share of reading in the time for a mesh from a file; building is the rest. */
const readingShare = 0.7;
/** The approximate share of distances in the time for a diagram; tracing is the rest. */
const distancesShare = 0.9;

/** The address of an object in core.wasm. */
type Pointer = number;

/** An object that is stored until it is closed, with the function that frees it. */
interface StoredObject {
  pointer: Pointer;
  free?: 'freeMesh' | 'freeVoronoi' | 'freeCvt';
  /** The mesh of a diagram, made when first asked for and freed with the diagram. */
  mesh?: Handle;
  lastCall?: Promise<void>;
}

/** The answer of `createMesh`: the mesh and its facts. */
type CreatedMesh = Omit<MeshInfo, 'origin' | 'notes'> & { mesh: Pointer };

export class LocalEngine implements Engine {
  readonly version: string;
  #core: WasmModule | undefined;
  readonly #inputModules: InputModules;
  readonly #objects = new Map<Handle, StoredObject>();
  /** Tessellations that have no further iteration. */
  readonly #finished = new Set<Handle>();
  #lastHandle: Handle = 0;

  private constructor(core: WasmModule, inputModules: InputModules) {
    this.#core = core;
    this.#inputModules = inputModules;
    this.version = core.text('version');
  }

  static async load(sources: EngineSources, compileAddress: CompileAddress): Promise<LocalEngine> {
    const core = await WasmModule.instantiate(await compile('wasm', sources.wasm, compileAddress));
    return new LocalEngine(core, {
      gltf: whenNeeded(() => compile('gltfWasm', sources.gltfWasm, compileAddress)),
      draco: whenNeeded(() => compile('dracoWasm', sources.dracoWasm, compileAddress)),
    });
  }

  /** Calls about one object are answered one after the other. */
  call<Result>(
    name: string,
    object: Handle,
    args: readonly Argument[],
    { signal, onProgress }: TaskOptions,
  ): Promise<Result> {
    const kept = this.#objects.get(object);
    const result = (kept?.lastCall ?? Promise.resolve()).then(async () => {
      signal?.throwIfAborted();
      const pointer = () => this.#pointer(object); // it may be closed between slices
      return this.#answer<Result>(name, [pointer(), ...args], { signal, onProgress }, pointer);
    });
    if (kept) kept.lastCall = settled(result);
    return result;
  }

  async callMesh<Result>(
    name: string,
    object: Handle,
    args: readonly Argument[],
    task: TaskOptions,
  ): Promise<Result> {
    return this.call(name, this.#meshOf(object), args, task);
  }

  async openMesh(
    source: Triangles | FileInput,
    build: MeshBuild,
    { signal, onProgress }: TaskOptions,
  ): Promise<OpenedMesh> {
    signal?.throwIfAborted();
    return 'positions' in source
      ? this.#openTriangles(source, [], build, { signal, onProgress })
      : this.#openFiles(source, build, { signal, onProgress });
  }

  async #openFiles(
    input: FileInput,
    build: MeshBuild,
    { signal, onProgress }: TaskOptions,
  ): Promise<OpenedMesh> {
    const { parts, origin, notes, ...read } = await readModel(input, this.#inputModules, {
      signal,
      onProgress: (share) => onProgress?.(readingShare * share),
    });
    const { info, triangles, ...opened } = await this.#openTriangles(read.triangles, parts, build, {
      signal,
      onProgress: (share) => onProgress?.(readingShare + (1 - readingShare) * share),
    });
    return {
      ...opened,
      info: { ...info, origin, notes: [...notes, ...info.notes] },
      triangles: triangles ?? read.triangles,
    };
  }

  async #openTriangles(
    given: Triangles,
    parts: MeshPart[],
    { maxEdge, weld, orientation, minComponent }: MeshBuild,
    { signal, onProgress }: TaskOptions,
  ): Promise<OpenedMesh> {
    const core = this.#open();
    const { positions, indices } = given;
    const arrays = core.call('newMeshArrays', positions.length, indices.length);
    try {
      const length = Math.max(positions.length, indices.length);
      let at = 0;
      const copyMore = () => {
        const part = [at, (at += numbersPerStep)];
        const pieces = [positions.subarray(...part), indices.subarray(...part)];
        core.call('appendToMeshArrays', arrays, ...pieces);
        return at < length ? sliceMoreToDo : sliceDone;
      };
      await this.#inSlices(copyMore, { signal });
      const cut =
        maxEdge > 0
          ? await this.#answer<Subdivision>('subdivideMeshArrays', [arrays, maxEdge], { signal })
          : undefined;
      const triangles = cut && subdividedTriangles(given, cut);
      const args = [arrays, weld, orientation, minComponent];
      const { mesh, ...counts } = await this.#answer<CreatedMesh>('createMesh', args, {
        signal,
        onProgress: (share) => share < 1 && onProgress?.(share),
      });
      const info: MeshInfo = {
        ...counts,
        origin: { format: 'arrays', file: '' },
        notes: cut ? [subdivisionNote(indices.length / 3, cut)] : [],
      };
      const handle = this.#keep({ pointer: mesh, free: 'freeMesh' });
      try {
        onProgress?.(1); // may throw, which ends the task
      } catch (error) {
        this.close(handle);
        throw error;
      }
      if (!cut) return { handle, info, parts };
      return { handle, info, parts: subdividedParts(parts, cut), triangles };
    } finally {
      core.run('freeMeshArrays', arrays);
    }
  }

  /** The answer of a function of core.wasm, worked on in slices. */
  async #answer<Result>(
    name: string,
    args: readonly Argument[],
    { signal, onProgress }: TaskOptions,
    requireOpen: () => unknown = () => {},
  ): Promise<Result> {
    const core = this.#open();
    const answer = core.call(name, ...args);
    const requireBoth = () => {
      this.#open();
      requireOpen();
    };
    try {
      await inSlices(core.working(answer, requireBoth), { signal, onProgress });
      const result = await inSlices(core.copying<Result>(answer), { signal });
      onProgress?.(1);
      return result;
    } finally {
      core.run('freeAnswer', answer);
    }
  }

  async openDiagram(
    owner: Handle,
    sites: SurfacePoints,
    { metric, detail }: DiagramForm,
    { signal, onProgress }: TaskOptions,
  ): Promise<OpenedDiagram> {
    const voronoi = await this.#spread(owner, sites, metric, {
      signal,
      onProgress: (share) => onProgress?.(distancesShare * share),
    });
    const core = this.#open();
    try {
      core.call('startTracing', voronoi, detail);
      await this.#inSlices(() => core.call('stepTracing', voronoi, unitsPerStep), { signal });
      const data = await this.#answer<DiagramData>('voronoiDiagram', [voronoi], { signal });
      onProgress?.(1);
      return { handle: this.#keep({ pointer: voronoi, free: 'freeVoronoi' }), data };
    } catch (error) {
      core.run('freeVoronoi', voronoi);
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
      return await this.#answer('distancesAtVertices', [voronoi], { signal: task.signal });
    } finally {
      core.run('freeVoronoi', voronoi);
    }
  }

  /** The distances of sites; whoever gets them frees them. */
  async #spread(
    owner: Handle,
    sites: SurfacePoints,
    metric: Metric,
    { signal, onProgress }: TaskOptions,
  ): Promise<Pointer> {
    signal?.throwIfAborted();
    const core = this.#open();
    const voronoi = core.call(
      'startVoronoi',
      this.#pointer(this.#meshOf(owner)),
      sites.face,
      sites.bary,
      metric,
    );
    try {
      await this.#inSlices(() => core.call('stepDistances', voronoi, unitsPerStep), {
        signal,
        onProgress: () => onProgress?.(core.run('distancesProgress', voronoi) ?? 0),
      });
      return voronoi;
    } catch (error) {
      core.run('freeVoronoi', voronoi);
      throw error;
    }
  }

  async openCvt(
    mesh: Handle,
    { face, bary }: SurfacePoints,
    settings: CvtSettings,
    { signal }: TaskOptions,
  ): Promise<OpenedCvt> {
    signal?.throwIfAborted();
    const pointer = this.#open().call(
      'startCvt',
      this.#pointer(mesh),
      face,
      bary,
      settings.method,
      settings.metric,
      settings.iterations,
      settings.energyTolerance,
      settings.moveTolerance,
      settings.density,
      settings.fixedSites,
    );
    return { handle: this.#keep({ pointer, free: 'freeCvt' }) };
  }

  async advanceCvt(
    handle: Handle,
    form: CvtForm,
    { signal }: TaskOptions,
  ): Promise<AdvancedCvt | undefined> {
    signal?.throwIfAborted();
    const core = this.#open();
    if (this.#finished.has(handle)) return undefined;
    const cvt = () => this.#pointer(handle); // it may be closed between slices
    await this.#inSlices(() => core.call('stepCvt', cvt(), unitsPerStep), { signal });
    const { isLast, ...state } = core.answer<AdvancedCvt & { isLast: boolean }>(
      'cvtIteration',
      cvt(),
    );
    if (isLast) this.#finished.add(handle);
    if (form === 'bare') return state;
    const data = await this.#answer<DiagramData>('cvtDiagram', [cvt()], { signal });
    const withData = { ...state, data };
    if (form === 'data') return withData;
    const pointer = core.call('cvtVoronoi', cvt());
    return { ...withData, handle: this.#keep({ pointer, free: 'freeVoronoi' }) };
  }

  /**
   * Calls `step` until it says that it is done, in slices. Between slices the thread serves others,
   * progress is reported, and the signal may abort.
   */
  async #inSlices(
    step: () => number,
    { signal, onProgress }: { signal?: AbortSignal; onProgress?: () => void },
  ): Promise<void> {
    let done = false;
    while (!done) {
      const end = performance.now() + sliceMilliseconds;
      do done = step() === sliceDone;
      while (!done && performance.now() < end);
      onProgress?.();
      await nextTask();
      signal?.throwIfAborted();
      this.#open();
    }
  }

  close(object: Handle): void {
    const kept = this.#objects.get(object);
    if (kept?.free) this.#core?.run(kept.free, kept.pointer);
    if (kept?.mesh !== undefined) this.#objects.delete(kept.mesh);
    this.#objects.delete(object);
    this.#finished.delete(object);
  }

  /** Lets go of the instance: all its memory at once. */
  dispose(): void {
    this.#core = undefined;
    this.#objects.clear();
  }

  #open(): WasmModule {
    if (!this.#core) throw new GeodesicVoronoiError('disposed', 'the library has been disposed');
    return this.#core;
  }

  #pointer(object: Handle): Pointer {
    this.#open(); // throws if the library has been disposed, and with it the object
    const kept = this.#objects.get(object);
    if (!kept) throw new GeodesicVoronoiError('disposed', 'the object has been disposed');
    return kept.pointer;
  }

  /** The mesh itself, or the mesh that a diagram is on. */
  #meshOf(object: Handle): Handle {
    const kept = this.#objects.get(object);
    if (kept?.free !== 'freeVoronoi') return object;
    kept.mesh ??= this.#keep({ pointer: this.#open().call('meshOfVoronoi', kept.pointer) });
    return kept.mesh;
  }

  #keep(object: StoredObject): Handle {
    this.#objects.set(++this.#lastHandle, object);
    return this.#lastHandle;
  }
}

/** Makes a value when it is first asked for; after a failure, the next request tries again. */
function whenNeeded<Value>(make: () => Promise<Value>): () => Promise<Value> {
  let made: Promise<Value> | undefined;
  return () =>
    (made ??= make().catch((error) => {
      made = undefined;
      throw error;
    }));
}
