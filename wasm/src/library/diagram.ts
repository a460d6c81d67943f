// SPDX-License-Identifier: MIT
//
// A diagram as callers hold it: it checks what it is given, leaves the work to an engine, and keeps
// the arrays up to date with the changes.

import { appendChange, areLarge, changedData, changedSites } from './change.js';
import { toTask, toTaskOptions } from '../base/checks.js';
import type { DiagramForm, Engine, OpenedDiagram } from '../engine/engine.js';
import { diagramJson, type DiagramJson } from '../output/diagram_formats.js';
import { type GeodesicVoronoiError, outOfMemory } from '../api/errors.js';
import { checked, repairDefaults, toPoint, toPoints, type GivenPoints } from './arguments.js';
import { EngineObject } from './engine_object.js';
import { disposeSymbol, inspectSymbol, tagSymbol } from '../base/symbols.js';
import { regionsOf } from '../base/region.js';
import { partOf } from '../base/slices.js';
import { Turns } from '../base/turns.js';
import type {
  DiagramAccuracy,
  DiagramChange,
  DiagramData,
  DualPaths,
  Located,
  Metric,
  Partition,
  PolygonMesh,
  RemeshQuality,
  SurfacePath,
  SurfacePoints,
  Violation,
  ViolationKind,
  WorstRegion,
} from '../api/results.js';
import type {
  AccuracyOptions,
  DualOptions,
  PartitionOptions,
  RepairOptions,
  SurfacePointsInput,
  TaskOptions,
} from '../api/options.js';
import type { Diagram, Region } from '../api/types.js';
import type { Argument } from '../base/wasm_module.js';

export class EngineDiagram implements Diagram {
  readonly #form: DiagramForm;
  readonly #object: EngineObject;
  #sites: SurfacePoints;
  #data: DiagramData;
  /** The changes that `#data` does not have yet: they are merged when the arrays are asked for. */
  #changes: DiagramChange[] = [];
  #regions: readonly Region[] | undefined;
  /** What is asked of the diagram is carried out in the order of the calls. */
  readonly #turns = new Turns();

  constructor(
    engine: Engine,
    form: DiagramForm,
    sites: SurfacePoints,
    { handle, data }: OpenedDiagram,
  ) {
    this.#form = form;
    this.#sites = sites;
    this.#data = data;
    this.#object = new EngineObject('diagram', engine, handle);
  }

  /** The diagram of sites on a mesh, or on that of another diagram. */
  static async open(
    object: EngineObject,
    form: DiagramForm,
    sites: SurfacePoints,
    task: TaskOptions,
  ): Promise<EngineDiagram> {
    const { engine } = object;
    const opened = await object.ask((handle) => engine.openDiagram(handle, sites, form, task));
    return new EngineDiagram(engine, form, sites, opened);
  }

  get metric(): Metric {
    return this.#form.metric;
  }

  get sites(): SurfacePoints {
    return this.#sites;
  }

  get data(): DiagramData {
    this.#mergeChanges();
    return this.#data;
  }

  #mergeChanges(): void {
    if (this.#changes.length === 0) return;
    try {
      this.#data = changedData(this.#data, this.#changes, this.#sites.face.length);
    } catch (cause) {
      throw cause instanceof RangeError ? outOfMemory(cause) : cause;
    }
    this.#changes = [];
  }

  get regions(): readonly Region[] {
    return (this.#regions ??= regionsOf(this.data));
  }

  toJSON(): DiagramJson {
    return diagramJson(this);
  }

  get [tagSymbol](): string {
    return 'Diagram';
  }

  [inspectSymbol](): object {
    const { metric, sites, data, regions } = this;
    return { metric, sites, data, regions };
  }

  async fetchData(options?: TaskOptions): Promise<DiagramData> {
    const task = toTask(options);
    return this.#turns.take(task, async () => {
      if (this.#changes.length > 0) {
        this.#data = await this.#object.call<DiagramData>('voronoiDiagram', [], task);
        this.#changes = [];
        // The loops of these regions are indices into the former arrays.
        this.#regions = undefined;
      }
      return this.#data;
    });
  }

  async insertSite(site: SurfacePointsInput, options?: TaskOptions): Promise<DiagramChange> {
    return this.#change('insertSite', [], toPoint('site', site), options);
  }

  async moveSite(
    label: number,
    site: SurfacePointsInput,
    options?: TaskOptions,
  ): Promise<DiagramChange> {
    return this.#change('moveSite', [checked({ label }).label], toPoint('site', site), options);
  }

  async removeSite(label: number, options?: TaskOptions): Promise<DiagramChange> {
    return this.#change('removeSite', [checked({ label }).label], undefined, options);
  }

  /**
   * Changes a site: `args` are the arguments of core.wasm before the new place, if there is one. A
   * change that has begun goes on to its end, whatever its listener throws: else the engine's
   * diagram could differ from this one.
   */
  async #change(
    name: string,
    args: readonly number[],
    place: GivenPoints | undefined,
    options: TaskOptions | undefined,
  ): Promise<DiagramChange> {
    const { signal, onProgress } = toTask(options);
    let fault: { error: unknown } | undefined;
    const report = (share: number) => {
      try {
        if (!fault) onProgress?.(share);
      } catch (error) {
        fault = { error };
      }
    };
    return this.#turns.take({ signal }, async () => {
      const site = place && (await this.#object.onSurface(place, { signal }));
      signal?.throwIfAborted();
      const all = site ? [...args, site.face, site.bary] : args;
      const change = await this.#object
        .call<DiagramChange>(name, all, { onProgress: report })
        .then((made) => this.#take(made, site))
        .catch((error) => {
          // The engine's diagram has changed, but for all of its arrays there was no memory.
          if ((error as GeodesicVoronoiError).code === 'out-of-memory') this.dispose();
          throw error;
        });
      if (fault) throw fault.error;
      return change;
    });
  }

  /** Takes over a change that the engine made; `site` is the new place, if there is one. */
  #take(change: DiagramChange, site: SurfacePoints | undefined): DiagramChange {
    this.#sites = changedSites(this.#sites, change.label, site);
    appendChange(this.#changes, change);
    this.#regions = undefined;
    if (areLarge(this.#changes, this.#data)) this.#mergeChanges();
    return change;
  }

  /** Asks core.wasm about the diagram, in turn. */
  #ask<Result>(name: string, args: readonly Argument[], task: TaskOptions): Promise<Result> {
    return this.#turns.take(task, () => this.#object.call<Result>(name, args, task));
  }

  /** Asks about points. */
  #askOf<Result>(name: string, points: GivenPoints, task: TaskOptions): Promise<Result> {
    return this.#turns.take(task, async () => {
      const { face, bary } = await this.#object.onSurface(points, task);
      return this.#object.call<Result>(name, [face, bary], task);
    });
  }

  async locate(points: SurfacePointsInput, options?: TaskOptions): Promise<Located> {
    return this.#askOf('locate', toPoints('points', points), toTask(options));
  }

  async accuracy(options?: AccuracyOptions): Promise<DiagramAccuracy> {
    const { samples, ...task } = toTaskOptions(options, { samples: 1000 });
    checked({ samples });
    const { mislabelled, maxEdge } = await this.#ask<DiagramAccuracy>(
      'diagramAccuracy',
      [samples],
      task,
    );
    return { mislabelled, maxEdge: Number(maxEdge.toPrecision(1)) };
  }

  async worstRegionPoint(worst: WorstRegion, options?: TaskOptions): Promise<SurfacePoints> {
    return this.#ask('worstRegionPoint', [checked({ worst }).worst], toTask(options));
  }

  async path(point: SurfacePointsInput, options?: TaskOptions): Promise<SurfacePath> {
    return this.#askOf('pathToSite', toPoint('point', point), toTask(options));
  }

  async partition(options?: PartitionOptions): Promise<Partition> {
    const { leaveOutIndifferent, leaveOutUnreachable, ...task } = toTaskOptions(options, {
      leaveOutIndifferent: false,
      leaveOutUnreachable: false,
    });
    checked({ leaveOutIndifferent, leaveOutUnreachable });
    return this.#ask('partition', [leaveOutIndifferent, leaveOutUnreachable], task);
  }

  async dual(options?: DualOptions): Promise<PolygonMesh> {
    const { primal, ...task } = toTaskOptions(options, { primal: false });
    return this.#ask('dual', [checked({ primal }).primal], task);
  }

  async dualPaths(options?: TaskOptions): Promise<DualPaths> {
    return this.#ask('dualPaths', [], toTask(options));
  }

  async violations(options?: TaskOptions): Promise<Violation[]> {
    const task = toTask(options);
    return this.#turns.take(task, () => this.#violations(task));
  }

  async #violations(task: TaskOptions): Promise<Violation[]> {
    const { kind, labelOffset, labels, message } = await this.#object.call<ViolationArrays>(
      'dualViolations',
      [],
      task,
    );
    return kind.map((each, i) => ({
      kind: each,
      labels: [...labels.subarray(labelOffset[i], labelOffset[i + 1])],
      message: message[i],
    }));
  }

  async remeshQuality(options?: TaskOptions): Promise<RemeshQuality> {
    return this.#ask('dualQuality', [], toTask(options));
  }

  async repair(options?: RepairOptions): Promise<Diagram> {
    const { maxAdded, ...task } = toTaskOptions(options, repairDefaults);
    checked({ maxAdded });
    const shareOfSites = 0.9; // the rest is their diagram
    const sites = await this.#turns.take(task, async () => {
      const violations = await this.#violations({ signal: task.signal });
      if (violations.length === 0) return undefined;
      const finding = partOf(task, 0, shareOfSites);
      return this.#object.call<SurfacePoints>('repairedSites', [maxAdded], finding);
    });
    const rest = partOf(task, shareOfSites, 1);
    if (sites) return EngineDiagram.open(this.#object, this.#form, sites, rest);
    task.onProgress?.(1);
    return this;
  }

  dispose(): void {
    this.#object.dispose();
  }

  [disposeSymbol](): void {
    this.dispose();
  }
}

/** `Violation`s as core.wasm lists them. */
interface ViolationArrays {
  kind: ViolationKind[];
  labelOffset: Int32Array;
  labels: Int32Array;
  message: string[];
}
