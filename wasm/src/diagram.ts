// SPDX-License-Identifier: MIT
//
// A diagram as callers hold it: it checks what it is given, leaves the work to an engine, and keeps
// the arrays up to date with the changes.

import { appendChange, areLarge, changedData, changedSites } from './change.js';
import { toBoolean, toTask, toTaskOptions } from './checks.js';
import type { DiagramForm, Engine, OpenedDiagram } from './engine.js';
import { invalidArgument } from './errors.js';
import { diagramJson, type DiagramJson } from './formats.js';
import { repairDefaults, toLabel, toMaxAdded, toWorstRegion } from './input.js';
import { disposeSymbol, inspectSymbol, Kept } from './kept.js';
import { regionsOf } from './region.js';
import type {
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
} from './results.js';
import type {
  Diagram,
  DualOptions,
  PartitionOptions,
  Region,
  RepairOptions,
  SurfacePointsInput,
  TaskOptions,
} from './types.js';

export class EngineDiagram implements Diagram {
  readonly #form: DiagramForm;
  readonly #kept: Kept;
  #sites: SurfacePoints;
  #data: DiagramData;
  /** The changes that `#data` does not have yet: they are merged when the arrays are asked for. */
  #changes: DiagramChange[] = [];
  #regions: readonly Region[] | undefined;
  #lastChange: Promise<unknown> = Promise.resolve();

  constructor(
    engine: Engine,
    form: DiagramForm,
    sites: SurfacePoints,
    { handle, data }: OpenedDiagram,
  ) {
    this.#form = form;
    this.#sites = sites;
    this.#data = data;
    this.#kept = new Kept(this, 'diagram', engine, handle);
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
    if (this.#changes.length > 0)
      this.#data = changedData(this.#data, this.#changes, this.#sites.face.length);
    this.#changes = [];
  }

  get regions(): readonly Region[] {
    return (this.#regions ??= regionsOf(this.data));
  }

  toJSON(): DiagramJson {
    return diagramJson(this);
  }

  [inspectSymbol](): object {
    const { metric, sites, data, regions } = this;
    return { metric, sites, data, regions };
  }

  /** Waits for the changes asked for before it; later ones wait for it. */
  async fetchData(options?: TaskOptions): Promise<DiagramData> {
    const task = toTask(options);
    const result = this.#lastChange.then(async () => {
      task.signal?.throwIfAborted();
      if (this.#changes.length > 0) {
        this.#data = await this.#kept.call<DiagramData>('voronoiDiagram', [], task);
        this.#changes = [];
        // The loops of these regions are indices into the former arrays.
        this.#regions = undefined;
      }
      return this.#data;
    });
    this.#lastChange = result.catch(() => undefined);
    return result;
  }

  insertSite(site: SurfacePointsInput, options?: TaskOptions): Promise<DiagramChange> {
    return this.#inTurn(options, async (change) => {
      const point = await this.#kept.point('site', site);
      return [await change('insertSite', point.face, point.bary), point];
    });
  }

  moveSite(label: number, site: SurfacePointsInput, options?: TaskOptions): Promise<DiagramChange> {
    return this.#inTurn(options, async (change) => {
      const point = await this.#kept.point('site', site);
      return [await change('moveSite', toLabel(label), point.face, point.bary), point];
    });
  }

  removeSite(label: number, options?: TaskOptions): Promise<DiagramChange> {
    return this.#inTurn(options, async (change) => [await change('removeSite', toLabel(label))]);
  }

  /**
   * Makes changes one after the other, in the order in which they were asked for. One that has
   * begun cannot be aborted: the engine's diagram could then differ from this one.
   */
  async #inTurn(
    options: TaskOptions | undefined,
    task: (change: ChangeCall) => Promise<[DiagramChange, SurfacePoints?]>,
  ): Promise<DiagramChange> {
    const { signal, onProgress } = toTask(options);
    const result = this.#lastChange.then(async () => {
      const [change, site] = await task((name, ...args) => {
        signal?.throwIfAborted();
        return this.#kept.call<DiagramChange>(name, args, { onProgress });
      });
      this.#sites = changedSites(this.#sites, change.label, site);
      appendChange(this.#changes, change);
      if (areLarge(this.#changes, this.#data)) this.#mergeChanges();
      this.#regions = undefined;
      return change;
    });
    this.#lastChange = result.catch(() => undefined);
    return result;
  }

  async locate(points: SurfacePointsInput, options?: TaskOptions): Promise<Located> {
    const task = toTask(options);
    const { face, bary } = await this.#kept.points('points', points);
    return this.#kept.call('locate', [face, bary], task);
  }

  async worstRegionPoint(worst: WorstRegion, options?: TaskOptions): Promise<SurfacePoints> {
    return this.#kept.call('worstRegionPoint', [toWorstRegion(worst)], toTask(options));
  }

  async path(point: SurfacePointsInput, options?: TaskOptions): Promise<SurfacePath> {
    const task = toTask(options);
    const { face, bary } = await this.#kept.point('point', point);
    return this.#kept.call('pathToSite', [face, bary], task);
  }

  async partition(options?: PartitionOptions): Promise<Partition> {
    const { leaveOutIndifferent, leaveOutUnreachable, ...task } = toTaskOptions(options, {
      leaveOutIndifferent: false,
      leaveOutUnreachable: false,
    });
    const args = [
      toBoolean('leaveOutIndifferent', leaveOutIndifferent),
      toBoolean('leaveOutUnreachable', leaveOutUnreachable),
    ];
    return this.#kept.call('partition', args, task);
  }

  async dual(options?: DualOptions): Promise<PolygonMesh> {
    const { primal, ...task } = toTaskOptions(options, { primal: false });
    return this.#kept.call('dual', [toBoolean('primal', primal)], task);
  }

  async dualPaths(options?: TaskOptions): Promise<DualPaths> {
    return this.#kept.call('dualPaths', [], toTask(options));
  }

  async violations(options?: TaskOptions): Promise<Violation[]> {
    const { kind, labelOffset, labels, message } = await this.#kept.call<ViolationArrays>(
      'dualViolations',
      [],
      toTask(options),
    );
    return kind.map((each, i) => ({
      kind: each,
      labels: [...labels.subarray(labelOffset[i], labelOffset[i + 1])],
      message: message[i],
    }));
  }

  async remeshQuality(options?: TaskOptions): Promise<RemeshQuality> {
    return this.#kept.call('dualQuality', [], toTask(options));
  }

  async repair(options?: RepairOptions): Promise<Diagram> {
    const { maxAdded, signal, onProgress } = toTaskOptions(options, repairDefaults);
    let left = toMaxAdded(maxAdded);
    let share = 0;
    let repaired: EngineDiagram | undefined; // gets its first sites when it is opened
    try {
      for (;;) {
        const more = await (repaired ?? this).#repairingSites(left, signal);
        if (more.face.length === 0) break;
        left -= more.face.length;
        // The number of rounds is not known: each counts as half of what is left.
        const [before, rest] = [share, (1 - share) / 2];
        const onShare = (part: number) => onProgress?.(before + rest * part);
        if (repaired) await repaired.#insertSites(more, { signal, onProgress: onShare });
        else repaired = await this.#anew(joined(this.sites, more), { signal, onProgress: onShare });
        share += rest;
      }
    } catch (error) {
      repaired?.dispose();
      throw error;
    }
    onProgress?.(1);
    return repaired ?? this;
  }

  /** The sites that one round of repair adds. Refuses more than `most`. */
  async #repairingSites(most: number, signal?: AbortSignal): Promise<SurfacePoints> {
    const more = await this.#kept.call<SurfacePoints>('repairingSites', [], { signal });
    if (more.face.length <= most) return more;
    const [{ message }] = await this.violations({ signal });
    throw invalidArgument(`the dual is not valid with as many sites as may be added: ${message}`);
  }

  async #insertSites({ face, bary }: SurfacePoints, { signal, onProgress }: TaskOptions) {
    for (let i = 0; i < face.length; ++i) {
      const site = { face: face.subarray(i, i + 1), bary: bary.subarray(3 * i, 3 * i + 3) };
      await this.insertSite(site, { signal });
      onProgress?.((i + 1) / face.length);
    }
  }

  /** The diagram of other sites on the same mesh. */
  async #anew(sites: SurfacePoints, task: TaskOptions): Promise<EngineDiagram> {
    const { engine, handle } = this.#kept;
    const opened = await engine.openDiagram(handle, sites, this.#form, task);
    return new EngineDiagram(engine, this.#form, sites, opened);
  }

  dispose(): void {
    this.#kept.dispose();
  }

  [disposeSymbol](): void {
    this.dispose();
  }
}

function joined(a: SurfacePoints, b: SurfacePoints): SurfacePoints {
  return {
    face: Int32Array.from([...a.face, ...b.face]),
    bary: Float64Array.from([...a.bary, ...b.bary]),
  };
}

/** Calls a function of core.wasm that changes the diagram. */
type ChangeCall = (
  name: string,
  ...args: readonly (number | Int32Array | Float64Array)[]
) => Promise<DiagramChange>;

/** `Violation`s as core.wasm lists them. */
interface ViolationArrays {
  kind: ViolationKind[];
  labelOffset: Int32Array;
  labels: Int32Array;
  message: string[];
}
