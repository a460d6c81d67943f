// SPDX-License-Identifier: MIT
//
// The objects that callers hold. They check what they are given, know whether they are still alive,
// and leave the work to an engine: so all engines behave alike.

import { changedData, changedSites, combinedChange, shortenChanges } from './change.js';
import { metrics } from './core.js';
import { regionsOf } from './region.js';
import {
  toCount,
  toCvtSettings,
  toDetail,
  toLabel,
  toMaxAdded,
  toMetric,
  toPartitionOptions,
  toPoints,
  toSampling,
  toSeed,
  toTriangles,
} from './input.js';
import { GeodesicVoronoiError } from './errors.js';
import type { AdvancedCvt, Engine, Handle, OpenedDiagram, OpenedMesh } from './engine.js';
import type { Triangles } from './triangles.js';
import type {
  CvtOptions,
  CvtState,
  Diagram,
  DiagramChange,
  DiagramData,
  Distances,
  DistancesOptions,
  DualOptions,
  GeodesicVoronoi,
  GltfResources,
  Located,
  Mesh,
  MeshInfo,
  MeshPart,
  MeshSource,
  Metric,
  Partition,
  PartitionOptions,
  PolygonMesh,
  Region,
  RemeshQuality,
  RepairOptions,
  Sampling,
  SurfacePath,
  SurfacePoints,
  SurfacePointsInput,
  TaskOptions,
  Violation,
  VoronoiOptions,
} from './types.js';

/** `Symbol.dispose`, also where the runtime does not know it yet. */
const disposeSymbol: typeof Symbol.dispose = Symbol.dispose ?? Symbol.for('Symbol.dispose');

/** Frees what an object kept in its engine if nobody disposed it before it was collected. */
const backstop = new FinalizationRegistry<{ engine: Engine; handle: Handle }>(
  ({ engine, handle }) => engine.close(handle),
);

/** What a mesh or a diagram keeps in its engine, until it is disposed. */
class Kept {
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

  dispose(): void {
    if (this.#disposed) return;
    this.#disposed = true;
    backstop.unregister(this);
    this.engine.close(this.#handle);
  }
}

class EngineDiagram implements Diagram {
  readonly metric: Metric;
  readonly #detail: number;
  readonly #kept: Kept;
  #sites: SurfacePoints;
  #data: DiagramData;
  /** What `data` does not know yet: that is merged when somebody asks for all of it. */
  #changes: DiagramChange[] = [];
  #regions: readonly Region[] | undefined;
  #lastChange: Promise<unknown> = Promise.resolve();

  constructor(
    engine: Engine,
    { metric, detail }: { metric: Metric; detail: number },
    sites: SurfacePoints,
    { handle, data }: OpenedDiagram,
  ) {
    this.metric = metric;
    this.#detail = detail;
    this.#sites = sites;
    this.#data = data;
    this.#kept = new Kept(this, 'diagram', engine, handle);
  }

  get sites(): SurfacePoints {
    return this.#sites;
  }

  get data(): DiagramData {
    const change = this.#changes.reduceRight<DiagramChange | undefined>(
      (later, earlier) => (later ? combinedChange(earlier, later) : earlier),
      undefined,
    );
    if (change) this.#data = changedData(this.#data, change, this.#sites.face.length);
    this.#changes = [];
    return this.#data;
  }

  get regions(): readonly Region[] {
    return (this.#regions ??= regionsOf(this.data));
  }

  insertSite(site: SurfacePointsInput): Promise<DiagramChange> {
    return this.#inTurn(async () => {
      const point = await resolvePoint(this.#kept, 'site', site);
      return [await this.#tidying(this.#kept.engine.insertSite(this.#kept.handle, point)), point];
    });
  }

  moveSite(label: number, site: SurfacePointsInput): Promise<DiagramChange> {
    return this.#inTurn(async () => {
      const point = await resolvePoint(this.#kept, 'site', site);
      const answer = this.#kept.engine.moveSite(this.#kept.handle, toLabel(label), point);
      return [await this.#tidying(answer), point];
    });
  }

  removeSite(label: number): Promise<DiagramChange> {
    return this.#inTurn(async () => [
      await this.#tidying(this.#kept.engine.removeSite(this.#kept.handle, toLabel(label))),
    ]);
  }

  /** One change after the other, in the order in which they were asked for. */
  #inTurn(task: () => Promise<[DiagramChange, SurfacePoints?]>): Promise<DiagramChange> {
    const result = this.#lastChange.then(async () => {
      const [change, site] = await task();
      this.#sites = changedSites(this.#sites, change.label, site);
      this.#changes.push(change);
      this.#regions = undefined;
      return change;
    });
    this.#lastChange = result.catch(() => undefined);
    return result;
  }

  /** While an engine computes a change, elsewhere perhaps, those before it are put in order. */
  #tidying(answer: Promise<DiagramChange>): Promise<DiagramChange> {
    shortenChanges(this.#changes);
    return answer;
  }

  async locate(points: SurfacePointsInput): Promise<Located> {
    const resolved = await resolvePoints(this.#kept, 'points', points);
    return this.#kept.engine.locate(this.#kept.handle, resolved);
  }

  async path(point: SurfacePointsInput): Promise<SurfacePath> {
    const from = await resolvePoint(this.#kept, 'point', point);
    return this.#kept.engine.pathToSite(this.#kept.handle, from);
  }

  async partition(options: PartitionOptions = {}): Promise<Partition> {
    return this.#kept.engine.partition(this.#kept.handle, toPartitionOptions(options));
  }

  async dual({ primal = false }: DualOptions = {}): Promise<PolygonMesh> {
    return this.#kept.engine.dual(this.#kept.handle, primal);
  }

  async violations(): Promise<Violation[]> {
    return this.#kept.engine.violations(this.#kept.handle);
  }

  async remeshQuality(): Promise<RemeshQuality> {
    return this.#kept.engine.quality(this.#kept.handle);
  }

  async repair({ maxAdded = 1000, onProgress, signal }: RepairOptions = {}): Promise<Diagram> {
    const most = this.sites.face.length + toMaxAdded(maxAdded);
    let diagram: EngineDiagram = this;
    let share = 0;
    for (;;) {
      const before = diagram;
      try {
        const sites = await before.#moreSites(most);
        if (!sites) break;
        // How many rounds there will be, nobody knows: each is half of what is left.
        const rest = (1 - share) / 2;
        diagram = await before.#anew(sites, {
          signal,
          onProgress: (part) => onProgress?.(share + rest * part),
        });
        share += rest;
      } catch (error) {
        if (before !== this) before.dispose();
        throw error;
      }
      if (before !== this) before.dispose();
    }
    onProgress?.(1);
    return diagram;
  }

  /** These sites and those of one round of repair; nothing if there is nothing to repair. */
  async #moreSites(most: number): Promise<SurfacePoints | undefined> {
    const { engine, handle } = this.#kept;
    const added = await engine.repairingSites(handle);
    if (added.face.length === 0) return undefined;
    const { face, bary } = this.sites;
    if (face.length + added.face.length > most) {
      const [{ message }] = await engine.violations(handle);
      throw new GeodesicVoronoiError(
        'invalid-argument',
        `the dual is not valid with as many sites as may be added: ${message}`,
      );
    }
    return {
      face: Int32Array.from([...face, ...added.face]),
      bary: Float64Array.from([...bary, ...added.bary]),
    };
  }

  /** The diagram of other sites on the same mesh. */
  async #anew(sites: SurfacePoints, task: TaskOptions): Promise<EngineDiagram> {
    const { engine, handle } = this.#kept;
    const form = { metric: this.metric, detail: this.#detail };
    const opened = await engine.openDiagram(handle, sites, form, task);
    return new EngineDiagram(engine, form, sites, opened);
  }

  dispose(): void {
    this.#kept.dispose();
  }

  [disposeSymbol](): void {
    this.dispose();
  }
}

class EngineMesh implements Mesh {
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

  async sampleSites(
    count: number,
    { seed = 1, sampling = 'random' }: { seed?: number; sampling?: Sampling } = {},
  ): Promise<SurfacePoints> {
    const { engine, handle } = this.#kept;
    return engine.sampleSites(handle, toCount(count), toSampling(sampling), toSeed(seed));
  }

  async voronoi(sites: SurfacePointsInput, options: VoronoiOptions = {}): Promise<Diagram> {
    const { metric = metrics[0], detail = 0, onProgress, signal } = options;
    const form = { metric: toMetric(metric), detail: toDetail(detail) };
    const points = await resolvePoints(this.#kept, 'sites', sites);
    const { engine, handle } = this.#kept;
    const opened = await engine.openDiagram(handle, points, form, { onProgress, signal });
    return new EngineDiagram(engine, form, points, opened);
  }

  async distances(
    sites: SurfacePointsInput,
    { metric = metrics[0], onProgress, signal }: DistancesOptions = {},
  ): Promise<Distances> {
    const form = toMetric(metric);
    const points = await resolvePoints(this.#kept, 'sites', sites);
    const { engine, handle } = this.#kept;
    const known = await engine.distances(handle, points, form, { onProgress, signal });
    return { metric: form, sites: points, ...known };
  }

  async path(
    from: SurfacePointsInput,
    to: SurfacePointsInput,
    { onProgress, signal }: TaskOptions = {},
  ): Promise<SurfacePath> {
    const start = await resolvePoint(this.#kept, 'from', from);
    const end = await resolvePoint(this.#kept, 'to', to);
    const { engine, handle } = this.#kept;
    return engine.path(handle, start, end, { onProgress, signal });
  }

  async *cvt(
    sites: SurfacePointsInput,
    options: CvtOptions = {},
  ): AsyncGenerator<CvtState, void, void> {
    const { data = false, diagrams = false, signal } = options;
    const settings = toCvtSettings(options);
    const points = await resolvePoints(this.#kept, 'sites', sites);
    const { engine } = this.#kept;
    const { handle } = await engine.openCvt(this.#kept.handle, points, settings);
    try {
      for (;;) {
        const form = diagrams ? 'diagram' : data ? 'data' : 'bare';
        const advanced = await engine.advanceCvt(handle, form, { signal });
        if (!advanced) return;
        yield stateOf(engine, advanced, settings.metric);
      }
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

/** The library over an engine. */
export class Library implements GeodesicVoronoi {
  readonly #engine: Engine;

  constructor(engine: Engine) {
    this.#engine = engine;
  }

  get version(): string {
    return this.#engine.version;
  }

  async mesh(source: MeshSource, options: { resources?: GltfResources } = {}): Promise<Mesh> {
    const input = toTriangles(source, options.resources);
    const opened = await this.#engine.openMesh(input);
    return new EngineMesh(this.#engine, opened, opened.triangles ?? (input as Triangles));
  }

  dispose(): void {
    this.#engine.dispose();
  }

  [disposeSymbol](): void {
    this.dispose();
  }
}

/** One point, given as a list. */
async function resolvePoint(
  owner: Kept,
  name: string,
  point: SurfacePointsInput,
): Promise<SurfacePoints> {
  const points = await resolvePoints(owner, name, point);
  if (points.face.length !== 1) {
    throw new GeodesicVoronoiError(
      'invalid-argument',
      `${name} is a list of ${points.face.length} points where one is needed`,
    );
  }
  return points;
}

/** Points as faces and coordinates; those given by vertices are looked up. */
async function resolvePoints(
  owner: Kept,
  name: string,
  points: SurfacePointsInput,
): Promise<SurfacePoints> {
  const list = toPoints(name, points);
  return 'vertex' in list ? owner.engine.pointsAtVertices(owner.handle, list.vertex) : list;
}
