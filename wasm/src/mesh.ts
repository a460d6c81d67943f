// SPDX-License-Identifier: MIT
//
// A mesh as callers hold it: it checks what it is given, and leaves the work to an engine.

import { toBoolean, toOptions, toTask } from './checks.js';
import { EngineDiagram } from './diagram.js';
import type { AdvancedCvt, Engine, OpenedMesh } from './engine.js';
import { toCount, toCvtSettings, toDetail, toMetric, toSampling, toSeed } from './input.js';
import { disposeSymbol, Kept } from './kept.js';
import {
  metrics,
  type Distances,
  type MeshInfo,
  type MeshPart,
  type Metric,
  type SurfacePath,
  type SurfacePoints,
} from './results.js';
import type { Triangles } from './triangles.js';
import type {
  CvtOptions,
  CvtState,
  Diagram,
  DistancesOptions,
  Mesh,
  SampleOptions,
  SurfacePointsInput,
  TaskOptions,
  VoronoiOptions,
} from './types.js';

export class EngineMesh implements Mesh {
  readonly info: MeshInfo;
  readonly positions: Float64Array;
  readonly indices: Int32Array;
  readonly normals: Float64Array;
  readonly uvs: Float64Array;
  readonly parts: readonly MeshPart[];
  readonly #kept: Kept;

  constructor(
    engine: Engine,
    { handle, info, parts }: OpenedMesh,
    { positions, indices, normals, uvs }: Triangles,
  ) {
    this.info = info;
    this.positions = positions;
    this.indices = indices;
    this.normals = normals;
    this.uvs = uvs;
    this.parts = parts;
    this.#kept = new Kept(this, 'mesh', engine, handle);
  }

  async sampleSites(count: number, options?: SampleOptions): Promise<SurfacePoints> {
    const { seed = 1, sampling = 'random' } = toOptions(options);
    const args = [toCount(count), toSampling(sampling), toSeed(seed)];
    return this.#kept.call('sampleSites', args, toTask(options));
  }

  async voronoi(sites: SurfacePointsInput, options?: VoronoiOptions): Promise<Diagram> {
    const { metric = metrics[0], detail = 0 } = toOptions(options);
    const form = { metric: toMetric(metric), detail: toDetail(detail) };
    const task = toTask(options);
    const points = await this.#kept.points('sites', sites);
    const { engine, handle } = this.#kept;
    const opened = await engine.openDiagram(handle, points, form, task);
    return new EngineDiagram(engine, form, points, opened);
  }

  async distances(sites: SurfacePointsInput, options?: DistancesOptions): Promise<Distances> {
    const { metric: given = metrics[0] } = toOptions(options);
    const metric = toMetric(given);
    const task = toTask(options);
    const points = await this.#kept.points('sites', sites);
    const { engine, handle } = this.#kept;
    const known = await engine.distances(handle, points, metric, task);
    return { metric, sites: points, ...known };
  }

  async path(
    from: SurfacePointsInput,
    to: SurfacePointsInput,
    options?: TaskOptions,
  ): Promise<SurfacePath> {
    const task = toTask(options);
    const start = await this.#kept.point('from', from);
    const end = await this.#kept.point('to', to);
    const { engine, handle } = this.#kept;
    return engine.path(handle, start, end, task);
  }

  async *cvt(
    sites: SurfacePointsInput,
    options?: CvtOptions,
  ): AsyncGenerator<CvtState, void, void> {
    const { data = false, diagrams = false } = toOptions(options);
    const withData = toBoolean('data', data);
    const form = toBoolean('diagrams', diagrams) ? 'diagram' : withData ? 'data' : 'bare';
    const settings = toCvtSettings(toOptions(options));
    const { signal, onProgress } = toTask(options);
    const points = await this.#kept.points('sites', sites);
    const { engine } = this.#kept;
    const { handle } = await engine.openCvt(this.#kept.handle, points, settings, { signal });
    try {
      for (;;) {
        const advanced = await engine.advanceCvt(handle, form, { signal });
        if (!advanced) break;
        onProgress?.(Math.min(1, (advanced.iteration + 1) / (settings.iterations + 1)));
        yield stateOf(engine, advanced, settings.metric);
      }
      onProgress?.(1);
    } finally {
      engine.close(handle);
    }
  }

  dispose(): void {
    this.#kept.dispose();
  }

  [disposeSymbol](): void {
    this.dispose();
  }
}

/** An iteration as callers get it. */
function stateOf(engine: Engine, { handle, ...state }: AdvancedCvt, metric: Metric): CvtState {
  if (handle === undefined || !state.data) return state;
  const opened = { handle, data: state.data };
  const diagram = new EngineDiagram(engine, { metric, detail: 0 }, state.sites, opened);
  return { ...state, diagram };
}
