// SPDX-License-Identifier: MIT
//
// The library over an engine, as callers hold it; `mesh.ts` and `diagram.ts` are the objects that it
// makes. They behave alike over all engines.

import { toTaskOptions } from '../base/checks.js';
import type { Engine } from '../engine/engine.js';
import { checked, meshDefaults, toMeshInput } from './arguments.js';
import { disposeSymbol, tagSymbol } from '../base/symbols.js';
import { EngineMesh } from './mesh.js';
import type { Triangles } from '../base/triangles.js';
import type { MeshOptions, MeshSource } from '../api/options.js';
import type { GeodesicVoronoi, Mesh } from '../api/types.js';

export class Library implements GeodesicVoronoi {
  readonly #engine: Engine;

  constructor(engine: Engine) {
    this.#engine = engine;
  }

  get [tagSymbol](): string {
    return 'GeodesicVoronoi';
  }

  get version(): string {
    return this.#engine.version;
  }

  async mesh(source: MeshSource, options?: MeshOptions): Promise<Mesh> {
    const { limits, file, onProgress, signal, ...build } = toTaskOptions(options, meshDefaults);
    const input = toMeshInput(source, { limits, file });
    const opened = await this.#engine.openMesh(input, checked(build), { onProgress, signal });
    return new EngineMesh(this.#engine, opened, opened.triangles ?? (input as Triangles));
  }

  dispose(): void {
    this.#engine.dispose();
  }

  [disposeSymbol](): void {
    this.dispose();
  }
}
