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

/** Frees what an object kept in its engine if nobody disposed it before it was collected. */
const backstop = new FinalizationRegistry<{ engine: Engine; handle: Handle }>(
  ({ engine, handle }) => engine.close(handle),
);

/** The engine's object behind a mesh or a diagram, until that is disposed. */
export class EngineObject {
  readonly engine: Engine;
  readonly #what: string;
  readonly #handle: Handle;
  #disposed = false;

  constructor(owner: object, what: string, engine: Engine, handle: Handle) {
    this.engine = engine;
    this.#what = what;
    this.#handle = handle;
    backstop.register(owner, { engine, handle }, this);
  }

  get handle(): Handle {
    if (this.#disposed) {
      throw new GeodesicVoronoiError('disposed', `the ${this.#what} has been disposed`);
    }
    return this.#handle;
  }

  /** Calls a function of core.wasm on this object. */
  async call<Result>(name: string, args: readonly Argument[], task: TaskOptions): Promise<Result> {
    return this.engine.call(name, this.handle, args, task);
  }

  /** Points as faces and coordinates; those given by vertices or places are looked up. */
  async onSurface(points: GivenPoints, { signal }: TaskOptions): Promise<SurfacePoints> {
    if ('vertex' in points)
      return this.engine.callMesh('pointsAtVertices', this.handle, [points.vertex], { signal });
    if (!('position' in points)) return points;
    const { face, bary } = await this.engine.callMesh<SurfacePoints>(
      'closestPoints',
      this.handle,
      [points.position],
      { signal },
    );
    return { face, bary };
  }

  dispose(): void {
    if (this.#disposed) return;
    this.#disposed = true;
    backstop.unregister(this);
    this.engine.close(this.#handle);
  }
}
