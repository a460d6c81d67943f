// SPDX-License-Identifier: MIT
//
// What stands behind the objects that callers hold: the library on this thread (`LocalEngine`) or
// in a worker (`startWorkerEngine`).

import type { DiagramData, MeshInfo, MeshPart, SurfacePoints } from '../api/results.js';
import type { FileInput } from '../input/read_model.js';
import type { Triangles } from '../base/triangles.js';
import type { MeshOptions, TaskOptions, VoronoiOptions, WasmSource } from '../api/options.js';
import type { CvtState } from '../api/types.js';
import type { Argument } from '../base/wasm_module.js';

/** Where to find the modules. */
export interface EngineSources {
  wasm: WasmSource | undefined;
  gltfWasm: WasmSource | undefined;
  dracoWasm: WasmSource | undefined;
}

/**
 * A mesh, a diagram or a tessellation that an engine keeps; never used twice, so a stale one is
 * known as such.
 */
export type Handle = number;

/** Options that are all given. */
export type Given<Options> = { [Name in keyof Options]-?: Exclude<Options[Name], undefined> };

/** How a mesh is made of triangles. */
export type MeshBuild = Given<
  Pick<MeshOptions, 'maxEdge' | 'weld' | 'orientation' | 'minComponent'>
>;

/** An opened mesh; `triangles` is given if they came from files or were subdivided. */
export interface OpenedMesh {
  handle: Handle;
  info: MeshInfo;
  parts: MeshPart[];
  triangles?: Triangles;
}

/** How a diagram is made. */
export type DiagramForm = Given<Pick<VoronoiOptions, 'metric' | 'detail'>>;

export interface OpenedDiagram {
  handle: Handle;
  data: DiagramData;
}

/**
 * What a state of a tessellation comes with: nothing, the arrays of its diagram, or the diagram
 * too.
 */
export type CvtForm = 'bare' | 'data' | 'diagram';

/** An iteration; `handle` is its diagram, if that was asked for. */
export type AdvancedCvt = Omit<CvtState, 'diagram'> & { handle?: Handle };

/**
 * Arguments have been checked in form. Arguments and results can be posted to a worker, except the
 * options of a task: the last argument of every function that returns a promise.
 */
export interface Engine {
  readonly version: string;
  /**
   * Calls a function of core.wasm by its name, to query or change a mesh or a diagram: `args` are
   * its arguments after the object.
   */
  call<Result>(
    name: string,
    object: Handle,
    args: readonly Argument[],
    task: TaskOptions,
  ): Promise<Result>;
  /** Calls a function about a mesh; `object` is the mesh, or a diagram on it. */
  callMesh: Engine['call'];
  openMesh(source: Triangles | FileInput, build: MeshBuild, task: TaskOptions): Promise<OpenedMesh>;
  /** `owner` is a mesh or a diagram on it. */
  openDiagram(
    owner: Handle,
    sites: SurfacePoints,
    form: DiagramForm,
    task: TaskOptions,
  ): Promise<OpenedDiagram>;
  /** `args` are the arguments of core.wasm after the mesh. */
  openCvt(mesh: Handle, args: readonly Argument[], task: TaskOptions): Promise<{ handle: Handle }>;
  /** The next iteration, beginning with number 0; undefined after the last one. */
  advanceCvt(cvt: Handle, form: CvtForm, task: TaskOptions): Promise<AdvancedCvt | undefined>;
  /** Frees a mesh, a diagram or a tessellation. The diagrams and tessellations of a mesh stay. */
  close(object: Handle): void;
  dispose(): void;
}
