// SPDX-License-Identifier: MIT
//
// A mesh as callers hold it: it checks what it is given, and leaves the work to an engine.

import { isObject, show, toInt32, toOptions, toTask, toTaskOptions } from '../base/checks.js';
import { imported } from '../base/compile.js';
import { EngineDiagram } from './diagram.js';
import type { AdvancedCvt, CvtForm, Engine, Given, OpenedMesh } from '../engine/engine.js';
import type { Argument } from '../base/wasm_module.js';
import { GeodesicVoronoiError, invalidArgument } from '../api/errors.js';
import {
  checked,
  diagramDefaults,
  isWorstFirst,
  maxCount,
  repairDefaults,
  samplingDefaults,
  tessellationDefaults,
  toDensity,
  toPlaces,
  toPoint,
  toPoints,
  type GivenDensity,
  type GivenPoints,
} from './arguments.js';
import { EngineObject } from './engine_object.js';
import { disposeSymbol, tagSymbol } from '../base/symbols.js';
import type {
  BareComponents,
  ClosestPoints,
  Distances,
  MeshInfo,
  MeshPart,
  Metric,
  SurfacePath,
  SurfacePoints,
  VertexDistances,
} from '../api/results.js';
import { pointsFile, requireSameMesh } from '../input/points_file.js';
import { inSlices, partOf, type SlicedWork } from '../base/slices.js';
import { extended } from '../engine/subdivision.js';
import type { Subdivision, Triangles } from '../base/triangles.js';
import type {
  CvtOptions,
  DistancesOptions,
  RemeshOptions,
  SampleOptions,
  SurfacePointsInput,
  TaskOptions,
  VoronoiOptions,
} from '../api/options.js';
import type {
  CvtState,
  CvtStateWithData,
  CvtStateWithDiagram,
  Diagram,
  Mesh,
} from '../api/types.js';

/** The approximate share of sampling where components without a site get one afterwards. */
const samplingShare = 0.8;
/** Points that are checked or placed between two looks at the clock. */
const pointsPerStep = 2 ** 10;

export class EngineMesh implements Mesh {
  readonly info: MeshInfo;
  readonly positions: Float64Array;
  readonly indices: Int32Array;
  readonly parents: Int32Array;
  readonly normals: Float64Array;
  readonly uvs: Float64Array;
  readonly density: Float64Array;
  readonly parts: readonly MeshPart[];
  readonly #object: EngineObject;
  readonly #subdivision: Subdivision | undefined;

  constructor(
    engine: Engine,
    { handle, info, parts }: OpenedMesh,
    { positions, indices, subdivision, normals, uvs, density }: Triangles,
  ) {
    this.info = info;
    this.positions = positions;
    this.indices = indices;
    this.parents = subdivision?.parents ?? new Int32Array();
    this.#subdivision = subdivision;
    this.normals = normals;
    this.uvs = uvs;
    this.density = density;
    this.parts = parts;
    this.#object = new EngineObject('mesh', engine, handle);
  }

  get [tagSymbol](): string {
    return 'Mesh';
  }

  async sampleSites(
    wanted: number | { radius: number },
    options?: SampleOptions,
  ): Promise<SurfacePoints> {
    const byRadius = isObject(wanted) && !Array.isArray(wanted);
    const { seed, sampling, perComponent, density, ...task } = toTaskOptions(options, {
      ...samplingDefaults,
      sampling: byRadius ? 'farthest' : 'random',
    });
    checked({ seed, sampling, perComponent });
    const given = toDensity(density, this.density);
    if (byRadius && sampling !== 'farthest' && sampling !== 'poisson')
      throw invalidArgument(`the sampling ${show(sampling)} takes a number of sites, not a radius`);
    if ((given === 'curvature' || given.length > 0) && sampling !== 'random')
      throw invalidArgument(
        `a density is for random sites, not for the sampling ${show(sampling)}`,
      );
    const radius = byRadius && checked(toOptions(wanted, { radius: undefined })).radius;
    const count = byRadius ? maxCount : checked({ count: wanted }).count;
    const ofSampling = perComponent === 0 ? task : partOf(task, 0, samplingShare);
    const sample = async (): Promise<SurfacePoints> => {
      if (radius)
        return this.#object.call('sampleSitesByRadius', [radius, sampling, seed], ofSampling);
      if (isWorstFirst(sampling))
        return this.#object.call('sampleSitesWorstFirst', [count, sampling, seed], ofSampling);
      const weights = await this.#densityOf(given, task.signal);
      return this.#object.call('sampleSites', [count, sampling, seed, weights], ofSampling);
    };
    const { face, bary } = await sample();
    if (perComponent === 0) return { face, bary };
    const covering = partOf(task, samplingShare, 1);
    return this.#object.call('coverComponents', [face, bary, perComponent, count, seed], covering);
  }

  async bareComponents(sites: SurfacePointsInput, options?: TaskOptions): Promise<BareComponents> {
    const task = toTask(options);
    const { face, bary } = await this.#object.onSurface(toPoints('sites', sites), task);
    return this.#object.call('bareComponents', [face, bary], task);
  }

  async curvatureDensity(options?: TaskOptions): Promise<Float64Array<ArrayBuffer>> {
    const task = toTask(options);
    const { values } = await this.#object.call<{ values: Float64Array<ArrayBuffer> }>(
      'curvatureDensity',
      [],
      task,
    );
    return values;
  }

  async closestPoints(positions: ArrayLike<number>, options?: TaskOptions): Promise<ClosestPoints> {
    const task = toTask(options);
    return this.#object.call('closestPoints', [toPlaces('positions', positions)], task);
  }

  async readPoints(json: unknown, options?: TaskOptions): Promise<SurfacePoints> {
    const { signal } = toTask(options);
    signal?.throwIfAborted();
    const file = pointsFile(json);
    const given = toPoints('points', file.points);
    const subdivision = this.#subdivision;
    if (subdivision && 3 * (file.faces ?? 0) === subdivision.whole.length && 'face' in given) {
      await inSlices(onSurface(given, subdivision.whole.length / 3), { signal });
      const { pointsOnChildren } = await imported(import('./points_on_children.js'));
      return pointsOnChildren(given, subdivision);
    }
    requireSameMesh(file, this.info);
    const points = await this.#object.onSurface(given, { signal });
    return inSlices(onSurface(points, this.info.inputFaces), { signal });
  }

  async positionsOf(
    points: SurfacePointsInput,
    options?: TaskOptions,
  ): Promise<Float64Array<ArrayBuffer>> {
    const task = toTask(options);
    task.signal?.throwIfAborted();
    const found = await this.#object.onSurface(toPoints('points', points), task);
    await inSlices(onSurface(found, this.info.inputFaces), { signal: task.signal });
    const places = await inSlices(this.#placesOf(found), task);
    task.onProgress?.(1);
    return places;
  }

  *#placesOf({ face, bary }: SurfacePoints): SlicedWork<Float64Array<ArrayBuffer>> {
    const places = new Float64Array(3 * face.length).fill(NaN);
    for (let i = 0; i < face.length; ++i) {
      if (i > 0 && i % pointsPerStep === 0) yield i / face.length;
      if (face[i] === -1) continue;
      for (let k = 0; k < 3; ++k) {
        const at = (corner: number) =>
          bary[3 * i + corner] * this.positions[3 * this.indices[3 * face[i] + corner] + k];
        places[3 * i + k] = at(0) + at(1) + at(2);
      }
    }
    return places;
  }

  async voronoi(sites: SurfacePointsInput, options?: VoronoiOptions): Promise<Diagram> {
    const { metric, detail, ...task } = toTaskOptions(options, diagramDefaults);
    const form = checked({ metric, detail });
    const points = await this.#object.onSurface(toPoints('sites', sites), task);
    return EngineDiagram.open(this.#object, form, points, task);
  }

  async distances(sites: SurfacePointsInput, options?: DistancesOptions): Promise<Distances> {
    const { metric, ...task } = toTaskOptions(options, { metric: diagramDefaults.metric });
    checked({ metric });
    const points = await this.#object.onSurface(toPoints('sites', sites), task);
    const { face, bary } = points;
    const args = [face, bary, metric];
    const known = await this.#object.call<VertexDistances>('distancesAtVertices', args, task);
    return { metric, sites: points, ...known };
  }

  async path(
    from: SurfacePointsInput,
    to: SurfacePointsInput,
    options?: TaskOptions,
  ): Promise<SurfacePath> {
    const task = toTask(options);
    const ends = { from: toPoint('from', from), to: toPoint('to', to) };
    const start = await this.#object.onSurface(ends.from, task).catch(naming('from'));
    const end = await this.#object.onSurface(ends.to, task).catch(naming('to'));
    return this.#object.call('shortestPath', [start.face, start.bary, end.face, end.bary], task);
  }

  cvt(
    sites: SurfacePointsInput,
    options: CvtOptions & { diagrams: true },
  ): AsyncGenerator<CvtStateWithDiagram, void, void>;
  cvt(
    sites: SurfacePointsInput,
    options: CvtOptions & { data: true },
  ): AsyncGenerator<CvtStateWithData, void, void>;
  cvt(sites: SurfacePointsInput, options?: CvtOptions): AsyncGenerator<CvtState, void, void>;
  cvt(sites: SurfacePointsInput, options?: CvtOptions): AsyncGenerator<CvtState, void, void> {
    const asked = this.#toCvt(sites, options);
    asked.catch(() => {}); // whoever asks for the first state hears of it
    return this.#iterations(asked);
  }

  /** Checks and copies the arguments of `cvt`, at the call. */
  async #toCvt(sites: SurfacePointsInput, options: CvtOptions | undefined): Promise<Cvt> {
    const { data, diagrams, signal, onProgress, ...settings } = toTaskOptions(options, {
      ...tessellationDefaults,
      data: false,
      diagrams: false,
    });
    checked({ data, diagrams });
    const form = diagrams ? 'diagram' : data ? 'data' : 'bare';
    return { ...this.#toTessellation(sites, settings), form, task: { signal, onProgress } };
  }

  #toTessellation(
    sites: SurfacePointsInput,
    { density, fixedSites, ...settings }: TessellationOptions,
  ): Tessellation {
    return {
      sites: toPoints('sites', sites),
      ...checked(settings),
      fixedSites: toInt32('fixedSites', fixedSites),
      density: toDensity(density, this.density),
    };
  }

  /** A tessellation as arguments of core.wasm, after the mesh. */
  async #argumentsOf(tessellation: Tessellation, { signal }: TaskOptions): Promise<Argument[]> {
    const { sites, method, metric, iterations, energyTolerance, moveTolerance, fixedSites } =
      tessellation;
    const density = await this.#densityOf(tessellation.density, signal);
    const { face, bary } = await this.#object.onSurface(sites, { signal });
    const settings = [method, metric, iterations, energyTolerance, moveTolerance];
    return [face, bary, ...settings, density, fixedSites];
  }

  async *#iterations(asked: Promise<Cvt>): AsyncGenerator<CvtState, void, void> {
    const { form, task, ...tessellation } = await asked;
    const { signal, onProgress } = task;
    const args = await this.#argumentsOf(tessellation, task);
    const { engine } = this.#object;
    const { handle } = await this.#object.ask((mesh) => engine.openCvt(mesh, args, { signal }));
    const cvt = new EngineObject('tessellation', engine, handle);
    try {
      for (;;) {
        const advanced = await cvt.ask((object) => engine.advanceCvt(object, form, { signal }));
        if (!advanced) break;
        // Now the diagram has an owner.
        const state = stateOf(engine, advanced, tessellation.metric);
        onProgress?.(Math.min(1, (advanced.iteration + 1) / (tessellation.iterations + 1)));
        yield state;
      }
      onProgress?.(1);
    } finally {
      cvt.dispose();
    }
  }

  async remesh(sites: SurfacePointsInput, options?: RemeshOptions): Promise<Diagram> {
    const { maxAdded, signal, onProgress, ...settings } = toTaskOptions(options, {
      ...tessellationDefaults,
      ...repairDefaults,
    });
    const task = { signal, onProgress };
    checked({ maxAdded });
    const tessellation = this.#toTessellation(sites, settings);
    const args = await this.#argumentsOf(tessellation, task);
    const shareOfSites = 0.95; // the rest is the diagram
    const remeshed = await this.#object.call<SurfacePoints>(
      'remeshedSites',
      [...args, maxAdded],
      partOf(task, 0, shareOfSites),
    );
    const { metric } = tessellation;
    return this.voronoi(remeshed, { metric, ...partOf(task, shareOfSites, 1) });
  }

  /** The density per vertex. */
  async #densityOf(given: GivenDensity, signal: AbortSignal | undefined): Promise<Float64Array> {
    if (given === 'curvature') return this.curvatureDensity({ signal });
    const { vertexCount, ends } = this.#subdivision ?? {};
    return ends && given.length === vertexCount ? extended(given, 1, ends) : given;
  }

  dispose(): void {
    this.#object.dispose();
  }

  [disposeSymbol](): void {
    this.dispose();
  }
}

/** Says of the error of a point which one it is about. */
function naming(name: string): (error: unknown) => never {
  return (error) => {
    if (!(error instanceof GeodesicVoronoiError) || error.code !== 'invalid-point') throw error;
    throw new GeodesicVoronoiError(error.code, `${name}: ${error.message}`, { cause: error });
  };
}

type TessellationOptions = Given<Pick<CvtOptions, keyof typeof tessellationDefaults>>;

/** Sites that are to move to centroids, and how: checked and copied. */
interface Tessellation extends Omit<TessellationOptions, 'density' | 'fixedSites'> {
  sites: GivenPoints;
  density: GivenDensity;
  fixedSites: Int32Array;
}

/** The arguments of `cvt`. */
interface Cvt extends Tessellation {
  form: CvtForm;
  task: TaskOptions;
}

/** An iteration as callers get it. */
function stateOf(engine: Engine, { handle, ...state }: AdvancedCvt, metric: Metric): CvtState {
  if (handle === undefined || !state.data) return state;
  const opened = { handle, data: state.data };
  const diagram = new EngineDiagram(engine, { metric, detail: 0 }, state.sites, opened);
  return { ...state, diagram };
}

/**
 * The points, refused as by the core if one is on a triangle that there is not, or outside its
 * triangle; -1 is a label without a site.
 */
function* onSurface(points: SurfacePoints, count: number): SlicedWork<SurfacePoints> {
  const { face, bary } = points;
  for (const [i, f] of face.entries()) {
    if (i > 0 && i % pointsPerStep === 0) yield i / face.length;
    if (f === -1) continue;
    const isThere = f >= 0 && f < count;
    const fault = isThere ? faultOf(bary.subarray(3 * i, 3 * i + 3)) : `there is no triangle ${f}`;
    if (fault) throw new GeodesicVoronoiError('invalid-point', `point ${i}: ${fault}`);
  }
  return points;
}

/** The fault of barycentric coordinates, beyond the core's tolerance; nothing if there is none. */
function faultOf(bary: Float64Array): string | undefined {
  const tolerance = 1e-6;
  if (!bary.every(Number.isFinite)) return 'a barycentric coordinate is not a finite number';
  const negative = bary.find((b) => b < -tolerance);
  if (negative !== undefined) return `the barycentric coordinate ${negative} is negative`;
  const sum = bary[0] + bary[1] + bary[2];
  if (Math.abs(sum - 1) <= tolerance) return undefined;
  return `the barycentric coordinates sum to ${sum}, not 1`;
}
