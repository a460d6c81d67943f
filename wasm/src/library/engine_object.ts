// SPDX-License-Identifier: MIT
//
// The common part of the objects that callers hold: each stands for an object of an engine until it
// is disposed, and looks points of its surface up.

import type { Engine, Handle } from '../engine/engine.js';
import { GeodesicVoronoiError } from '../api/errors.js';
import type { GivenPoints } from './arguments.js';
import type { SurfacePoints } from '../api/results.js';
import type { TaskOptions } from '../api/options.js';
import type { Argument } from '../base/wasm_module.js';

/** The objects by the calls about them: none of them is collected, and so freed, during a call. */
const running = new Map<Promise<unknown>, EngineObject>();

/** Frees what an object kept in its engine if nobody disposed it before it was collected. */
const backstop = new FinalizationRegistry<{ engine: Engine; handle: Handle }>(
  ({ engine, handle }) => engine.close(handle),
);

/** The engine's object behind a mesh, a diagram or a tessellation, until that is disposed. */
export class EngineObject {
  readonly engine: Engine;
  readonly #what: string;
  readonly #handle: Handle;
  #disposed = false;

  constructor(what: string, engine: Engine, handle: Handle) {
    this.engine = engine;
    this.#what = what;
    this.#handle = handle;
    backstop.register(this, { engine, handle }, this);
  }

  /** Asks the engine about this object, and keeps it until there is an answer. */
  async ask<Answer>(question: (handle: Handle) => Promise<Answer>): Promise<Answer> {
    if (this.#disposed)
      throw new GeodesicVoronoiError('disposed', `the ${this.#what} has been disposed`);
    const call = question(this.#handle);
    running.set(call, this);
    try {
      return await call;
    } finally {
      running.delete(call);
    }
  }

  /** Calls a function of core.wasm on this object. */
  async call<Result>(name: string, args: readonly Argument[], task: TaskOptions): Promise<Result> {
    return this.ask((handle) => this.engine.call<Result>(name, handle, args, task));
  }

  /** Points as faces and coordinates; those given by vertices or places are looked up. */
  async onSurface(points: GivenPoints, { signal }: TaskOptions): Promise<SurfacePoints> {
    const lookUp = (name: string, list: Argument) =>
      this.ask((handle) => this.engine.callMesh<SurfacePoints>(name, handle, [list], { signal }));
    if ('vertex' in points) return lookUp('pointsAtVertices', points.vertex);
    if (!('position' in points)) return points;
    const { face, bary } = await lookUp('closestPoints', points.position);
    return { face, bary };
  }

  dispose(): void {
    if (this.#disposed) return;
    this.#disposed = true;
    backstop.unregister(this);
    this.engine.close(this.#handle);
  }
}
