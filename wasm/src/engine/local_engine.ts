// SPDX-License-Identifier: MIT
//
// The library on the thread that calls it: objects in core.wasm, and long work in slices.

import { compile, type CompileAddress } from '../base/compile.js';
import type {
  AdvancedCvt,
  CvtForm,
  DiagramForm,
  Engine,
  EngineSources,
  Handle,
  MeshBuild,
  OpenedDiagram,
  OpenedMesh,
} from './engine.js';
import { GeodesicVoronoiError } from '../api/errors.js';
import { type FileInput, type InputModules, type Model, readModel } from '../input/read_model.js';
import type { DiagramData, MeshInfo, SurfacePoints } from '../api/results.js';
import { weldAdvice } from '../base/sentences.js';
import { inSlices, partOf, type SlicedWork } from '../base/slices.js';
import { subdivided } from './subdivision.js';
import type { Triangles } from '../base/triangles.js';
import { Turns } from '../base/turns.js';
import type { TaskOptions } from '../api/options.js';
import { type Argument, WasmModule } from '../base/wasm_module.js';

/** Numbers that are copied between two looks at the clock. */
const numbersPerStep = 2 ** 15;
/** The approximate share of reading in the time for a mesh from a file; building is the rest. */
const readingShare = 0.7;

/** The address of an object in core.wasm. */
type Pointer = number;

/** An object that is stored until it is closed, with the function that frees it. */
interface StoredObject {
  pointer: Pointer;
  free: 'freeMesh' | 'freeVoronoi' | 'freeCvt';
  turns: Turns;
}

/** The answer of `createMesh`: the mesh and its facts. */
type CreatedMesh = Omit<MeshInfo, 'origin' | 'notes'> & { mesh: Pointer };

export class LocalEngine implements Engine {
  readonly version: string;
  #core: WasmModule | undefined;
  readonly #inputModules: InputModules;
  readonly #objects = new Map<Handle, StoredObject>();
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

  /** Calls about one object are answered one after the other; `pointer` is what they are about. */
  async call<Result>(
    name: string,
    object: Handle,
    args: readonly Argument[],
    task: TaskOptions,
    pointer: () => Pointer = () => this.#pointer(object),
  ): Promise<Result> {
    return this.#stored(object).turns.take(task, async () => {
      const answer = await this.#answer<Result>(name, [pointer(), ...args], task, pointer);
      task.onProgress?.(1);
      return answer;
    });
  }

  readonly callMesh: Engine['call'] = (name, object, args, task) =>
    this.call(name, object, args, task, () => this.#meshPointer(object));

  async openMesh(
    source: Triangles | FileInput,
    build: MeshBuild,
    task: TaskOptions,
  ): Promise<OpenedMesh> {
    task.signal?.throwIfAborted();
    if (!('positions' in source)) {
      const model = await readModel(source, this.#inputModules, partOf(task, 0, readingShare));
      return this.#openModel(model, build, partOf(task, readingShare, 1));
    }
    const origin = { format: 'arrays', file: '' } as const;
    const model = { triangles: source, parts: [], origin, notes: [] };
    const opened = await this.#openModel(model, build, task);
    // The caller has these.
    return opened.triangles === source ? { ...opened, triangles: undefined } : opened;
  }

  async #openModel(
    given: Model,
    { maxEdge, weld, orientation, minComponent }: MeshBuild,
    task: TaskOptions,
  ): Promise<OpenedMesh> {
    const { signal, onProgress } = task;
    const { positions, indices } = given.triangles;
    const core = this.#open();
    const arrays = core.call('newMeshArrays', positions.length, indices.length);
    try {
      await inSlices(this.#copyInto(arrays, given.triangles), { signal });
      let model = given;
      if (maxEdge > 0) {
        const args = [arrays, maxEdge];
        model = subdivided(given, await this.#answer('subdivideMeshArrays', args, { signal }));
      }
      const args = [arrays, weld, orientation, minComponent];
      const { mesh, ...counts } = await this.#answer<CreatedMesh>('createMesh', args, task);
      const handle = this.#store({ pointer: mesh, free: 'freeMesh' });
      try {
        onProgress?.(1); // may throw, which ends the task
      } catch (error) {
        this.close(handle);
        throw error;
      }
      const { triangles, parts, origin } = model;
      const notes = [...model.notes];
      if (counts.hasOpenSeams || counts.hasTJunctions) notes.push(weldAdvice);
      return { handle, info: { ...counts, origin, notes }, parts, triangles };
    } finally {
      core.run('freeMeshArrays', arrays);
    }
  }

  /** Copies triangles into arrays of core.wasm. */
  *#copyInto(arrays: Pointer, { positions, indices }: Triangles): SlicedWork<void> {
    const length = Math.max(positions.length, indices.length);
    for (let at = 0; at < length; at += numbersPerStep) {
      const part = [at, at + numbersPerStep];
      const pieces = [positions.subarray(...part), indices.subarray(...part)];
      this.#open().call('appendToMeshArrays', arrays, ...pieces);
      yield at / length;
    }
  }

  /**
   * The answer of a function of core.wasm, worked on in slices. Between these, what it is about may
   * be closed. The caller reports the share 1.
   */
  async #answer<Result>(
    name: string,
    args: readonly Argument[],
    task: TaskOptions,
    requireOpen: () => unknown = () => this.#open(),
  ): Promise<Result> {
    const core = this.#open();
    const answer = core.call(name, ...args);
    try {
      return await inSlices(core.answering<Result>(answer, requireOpen), task);
    } finally {
      core.run('freeAnswer', answer);
    }
  }

  async openDiagram(
    owner: Handle,
    { face, bary }: SurfacePoints,
    { metric, detail }: DiagramForm,
    task: TaskOptions,
  ): Promise<OpenedDiagram> {
    task.signal?.throwIfAborted();
    const args = [this.#meshPointer(owner), face, bary, metric, detail];
    const { voronoi } = await this.#answer<{ voronoi: Pointer }>('createVoronoi', args, task);
    return this.#storeDiagram(voronoi, task);
  }

  /** Stores a diagram that is there, and gets its arrays. */
  async #storeDiagram(
    voronoi: Pointer,
    { signal, onProgress }: TaskOptions,
  ): Promise<OpenedDiagram> {
    const handle = this.#store({ pointer: voronoi, free: 'freeVoronoi' });
    try {
      const data = await this.call<DiagramData>('voronoiDiagram', handle, [], { signal });
      onProgress?.(1); // may throw, which ends the task
      return { handle, data };
    } catch (error) {
      this.close(handle);
      throw error;
    }
  }

  async openCvt(
    mesh: Handle,
    args: readonly Argument[],
    { signal }: TaskOptions,
  ): Promise<{ handle: Handle }> {
    signal?.throwIfAborted();
    const pointer = this.#open().call('startCvt', this.#pointer(mesh), ...args);
    return { handle: this.#store({ pointer, free: 'freeCvt' }) };
  }

  async advanceCvt(
    handle: Handle,
    form: CvtForm,
    { signal }: TaskOptions,
  ): Promise<AdvancedCvt | undefined> {
    const { hasState, ...state } = await this.call<AdvancedCvt & { hasState: boolean }>(
      'advanceCvt',
      handle,
      [],
      { signal },
    );
    if (!hasState) return undefined;
    if (form === 'bare') return state;
    const voronoi = this.#open().call('cvtVoronoi', this.#pointer(handle));
    const diagram = await this.#storeDiagram(voronoi, { signal });
    if (form === 'diagram') return { ...state, ...diagram };
    this.close(diagram.handle);
    return { ...state, data: diagram.data };
  }

  close(object: Handle): void {
    const stored = this.#objects.get(object);
    if (stored) this.#core?.run(stored.free, stored.pointer);
    this.#objects.delete(object);
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
    return this.#stored(object).pointer;
  }

  #stored(object: Handle): StoredObject {
    this.#open(); // throws if the library has been disposed, and with it the object
    const stored = this.#objects.get(object);
    if (!stored) throw new GeodesicVoronoiError('disposed', 'the object has been disposed');
    return stored;
  }

  /** Of the mesh itself, or of the mesh that a diagram is on, which is freed with it. */
  #meshPointer(object: Handle): Pointer {
    const { pointer, free } = this.#stored(object);
    return free === 'freeVoronoi' ? this.#open().call('meshOfVoronoi', pointer) : pointer;
  }

  #store(object: Omit<StoredObject, 'turns'>): Handle {
    this.#objects.set(++this.#lastHandle, { ...object, turns: new Turns() });
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
