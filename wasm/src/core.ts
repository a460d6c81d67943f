// SPDX-License-Identifier: MIT
import type {
  CvtMethod,
  CvtState,
  DiagramChange,
  DiagramData,
  Located,
  MeshInfo,
  MeshRepairs,
  Metric,
  Partition,
  PartitionOptions,
  PolygonMesh,
  PolygonTopology,
  RemeshQuality,
  Sampling,
  SurfacePath,
  SurfacePoints,
  VertexDistances,
  Violation,
  ViolationKind,
} from './types.js';
import { WasmModule, type CopyIn } from './wasm_module.js';

/** The functions of core.wasm, as `bindings.cpp` defines them. Pointers are numbers. */
interface CoreFunctions {
  version(): number;
  createMesh(
    positions: number,
    positionCount: number,
    triangles: number,
    indexCount: number,
  ): number;
  freeMesh(mesh: number): void;
  meshInfo(mesh: number): number;
  pointsAtVertices(owner: number, vertex: number, count: number): number;
  sampleSites(mesh: number, count: number, sampling: number, seed: number): number;
  startVoronoi(mesh: number, face: number, bary: number, count: number, metric: number): number;
  stepDistances(voronoi: number, budget: number): number;
  voronoiProgress(voronoi: number): number;
  distancesAtVertices(voronoi: number): number;
  pathToSite(voronoi: number, face: number, b0: number, b1: number, b2: number): number;
  startTracing(voronoi: number, detail: number): number;
  stepTracing(voronoi: number, budget: number): number;
  voronoiDiagram(voronoi: number): number;
  insertSite(voronoi: number, face: number, b0: number, b1: number, b2: number): number;
  moveSite(
    voronoi: number,
    label: number,
    face: number,
    b0: number,
    b1: number,
    b2: number,
  ): number;
  removeSite(voronoi: number, label: number): number;
  locate(voronoi: number, face: number, bary: number, count: number): number;
  partitionVoronoi(
    voronoi: number,
    leaveOutIndifferent: number,
    leaveOutUnreachable: number,
  ): number;
  dualVoronoi(voronoi: number, primal: number): number;
  dualViolations(voronoi: number): number;
  dualQuality(voronoi: number): number;
  repairingSites(voronoi: number): number;
  freeVoronoi(voronoi: number): void;
  startCvt(
    mesh: number,
    face: number,
    bary: number,
    count: number,
    method: number,
    metric: number,
    iterations: number,
    energyTolerance: number,
    moveTolerance: number,
    density: number,
    densityCount: number,
    fixed: number,
    fixedCount: number,
  ): number;
  stepCvt(cvt: number, budget: number): number;
  cvtIteration(cvt: number): number;
  cvtDiagram(cvt: number): number;
  cvtVoronoi(cvt: number): number;
  freeCvt(cvt: number): void;
}

/** In the order of `kMetrics` in `bindings.cpp`; the first one is the default. */
export const metrics: readonly Metric[] = ['exact', 'dgpc'];
/** In the order of `gvd::CvtMethod`. */
export const cvtMethods: readonly CvtMethod[] = ['lloyd', 'lbfgs'];
/** In the order of `Sampling` in `bindings.cpp`. */
export const samplings: readonly Sampling[] = ['random', 'farthest', 'poisson'];

/** In the order of `gvd::Violation::Kind`. */
const violationKinds: readonly ViolationKind[] = [
  'unreachable',
  'no-region',
  'few-runs',
  'closed-border',
  'no-disk',
  'touches-itself',
  'two-meet-twice',
  'three-meet-twice',
  'no-manifold',
];

/** How a slice of work has ended: `SliceEnd` in `bindings.cpp`. */
const sliceDone = 2;

/** What `startCvt` needs beside a mesh and sites. */
export interface CvtSettings {
  method: CvtMethod;
  metric: Metric;
  iterations: number;
  energyTolerance: number;
  moveTolerance: number;
  /** Per input vertex; empty: uniform. */
  density: Float64Array;
  fixedSites: Int32Array;
}

/** The counts of `meshInfo` in `bindings.cpp`, in their order. */
const infoCounts = [
  'vertices',
  'faces',
  'edges',
  'inputVertices',
  'inputFaces',
  'components',
  'boundaryLoops',
  'eulerCharacteristic',
  'genus',
] as const satisfies (keyof MeshInfo)[];

const repairCounts = [
  'weldedVertices',
  'isolatedVertices',
  'nonFiniteTriangles',
  'degenerateTriangles',
  'duplicateTriangles',
  'nonManifoldEdges',
  'orientationCuts',
  'flippedTriangles',
  'splitVertices',
  'mollifiedTriangles',
] as const satisfies (keyof MeshRepairs)[];

/** After `isManifold`. */
const topologyCounts = [
  'vertices',
  'edges',
  'faces',
  'components',
  'boundaryLoops',
  'eulerCharacteristic',
  'genus',
] as const satisfies (keyof PolygonTopology)[];

const qualityNumbers = [
  'triangles',
  'minAngle',
  'meanMinAngle',
  'minValence',
  'maxValence',
  'regularShare',
  'hausdorff',
] as const satisfies (keyof RemeshQuality)[];

declare const kind: unique symbol;
/** The address of a mesh, or of a diagram under way or done, in core.wasm. */
export type MeshPointer = number & { [kind]: 'mesh' };
export type VoronoiPointer = number & { [kind]: 'voronoi' };
export type CvtPointer = number & { [kind]: 'cvt' };

/** core.wasm, typed: plain arrays in, copies out. */
export class Core {
  readonly #wasm: WasmModule<CoreFunctions>;

  private constructor(wasm: WasmModule<CoreFunctions>) {
    this.#wasm = wasm;
  }

  static async instantiate(module: WebAssembly.Module): Promise<Core> {
    return new Core(await WasmModule.instantiate<CoreFunctions>(module));
  }

  get version(): string {
    return this.#wasm.text((core) => core.version());
  }

  createMesh(positions: Float64Array, indices: Int32Array): MeshPointer {
    return this.#wasm.call((core, copyIn) =>
      core.createMesh(copyIn(positions), positions.length, copyIn(indices), indices.length),
    ) as MeshPointer;
  }

  freeMesh(mesh: MeshPointer): void {
    this.#wasm.run((core) => core.freeMesh(mesh));
  }

  meshInfo(mesh: MeshPointer): Omit<MeshInfo, 'notes'> {
    const [counts, repairs, measures] = this.#wasm.arrays((core) => core.meshInfo(mesh)) as [
      Int32Array,
      Int32Array,
      Float64Array,
    ];
    const [area, boundingDiagonal, mollification] = measures;
    return {
      ...named(infoCounts, counts),
      area,
      boundingDiagonal,
      repairs: { ...named(repairCounts, repairs), mollification },
    };
  }

  pointsAtVertices(owner: MeshPointer | VoronoiPointer, vertex: Int32Array): SurfacePoints {
    return surfacePoints(
      this.#wasm.arrays((core, copyIn) =>
        core.pointsAtVertices(owner, copyIn(vertex), vertex.length),
      ),
    );
  }

  sampleSites(mesh: MeshPointer, count: number, sampling: Sampling, seed: number): SurfacePoints {
    return surfacePoints(
      this.#wasm.arrays((core) =>
        core.sampleSites(mesh, count, samplings.indexOf(sampling), seed),
      ),
    );
  }

  startVoronoi(
    owner: MeshPointer | VoronoiPointer,
    sites: SurfacePoints,
    metric: Metric,
  ): VoronoiPointer {
    return this.#wasm.call((core, copyIn) =>
      core.startVoronoi(owner, ...copyPoints(copyIn, sites), metrics.indexOf(metric)),
    ) as VoronoiPointer;
  }

  /** Works on at most `budget` units; true when the distances are done. */
  stepDistances(voronoi: VoronoiPointer, budget: number): boolean {
    return this.#wasm.call((core) => core.stepDistances(voronoi, budget)) === sliceDone;
  }

  /** The share of the distances done, 0 … 1. */
  voronoiProgress(voronoi: VoronoiPointer): number {
    return this.#wasm.run((core) => core.voronoiProgress(voronoi)) ?? 0;
  }

  /** Of distances that are done. */
  distancesAtVertices(voronoi: VoronoiPointer): VertexDistances {
    const [label, distance, direction] = this.#wasm.arrays((core) =>
      core.distancesAtVertices(voronoi),
    ) as [Int32Array, Float64Array, Float64Array];
    return { label, distance, direction };
  }

  /** From a point to its nearest site, by distances that are done. */
  pathToSite(voronoi: VoronoiPointer, from: SurfacePoints): SurfacePath {
    const [b0, b1, b2] = from.bary;
    const [face, bary, position, [length]] = this.#wasm.arrays((core) =>
      core.pathToSite(voronoi, from.face[0], b0, b1, b2),
    ) as [Int32Array, Float64Array, Float64Array, Float64Array];
    return { points: { face, bary, position }, length };
  }

  /** Begins the diagram of distances that are done. */
  startTracing(voronoi: VoronoiPointer, detail: number): void {
    this.#wasm.call((core) => core.startTracing(voronoi, detail));
  }

  /** Works on at most `budget` faces; true when the diagram is done. */
  stepTracing(voronoi: VoronoiPointer, budget: number): boolean {
    return this.#wasm.call((core) => core.stepTracing(voronoi, budget)) === sliceDone;
  }

  /** The diagram that is done. */
  voronoiDiagram(voronoi: VoronoiPointer): Omit<DiagramData, 'siteCount'> {
    return diagramData(this.#wasm.arrays((core) => core.voronoiDiagram(voronoi)));
  }

  insertSite(voronoi: VoronoiPointer, site: SurfacePoints): DiagramChange {
    const [b0, b1, b2] = site.bary;
    return diagramChange(
      this.#wasm.arrays((core) => core.insertSite(voronoi, site.face[0], b0, b1, b2)),
    );
  }

  moveSite(voronoi: VoronoiPointer, label: number, site: SurfacePoints): DiagramChange {
    const [b0, b1, b2] = site.bary;
    return diagramChange(
      this.#wasm.arrays((core) => core.moveSite(voronoi, label, site.face[0], b0, b1, b2)),
    );
  }

  removeSite(voronoi: VoronoiPointer, label: number): DiagramChange {
    return diagramChange(this.#wasm.arrays((core) => core.removeSite(voronoi, label)));
  }

  locate(voronoi: VoronoiPointer, points: SurfacePoints): Located {
    const [label, distance] = this.#wasm.arrays((core, copyIn) =>
      core.locate(voronoi, ...copyPoints(copyIn, points)),
    ) as [Int32Array, Float64Array];
    return { label, distance };
  }

  /** The partition by the diagram traced last; so with all that follows. */
  partition(
    voronoi: VoronoiPointer,
    { leaveOutIndifferent, leaveOutUnreachable }: Required<PartitionOptions>,
  ): Partition {
    return partitionData(
      this.#wasm.arrays((core) =>
        core.partitionVoronoi(voronoi, Number(leaveOutIndifferent), Number(leaveOutUnreachable)),
      ),
    );
  }

  dual(voronoi: VoronoiPointer, primal: boolean): PolygonMesh {
    return polygonMesh(this.#wasm.arrays((core) => core.dualVoronoi(voronoi, Number(primal))));
  }

  violations(voronoi: VoronoiPointer): Violation[] {
    const [kinds, offset, labels, ...messages] = this.#wasm.arrays((core) =>
      core.dualViolations(voronoi),
    ) as [Int32Array, Int32Array, Int32Array, ...string[]];
    return messages.map((message, i) => ({
      kind: violationKinds[kinds[i]],
      labels: [...labels.subarray(offset[i], offset[i + 1])],
      message,
    }));
  }

  quality(voronoi: VoronoiPointer): RemeshQuality {
    const [numbers] = this.#wasm.arrays((core) => core.dualQuality(voronoi)) as [Float64Array];
    return named(qualityNumbers, numbers);
  }

  repairingSites(voronoi: VoronoiPointer): SurfacePoints {
    return surfacePoints(this.#wasm.arrays((core) => core.repairingSites(voronoi)));
  }

  freeVoronoi(voronoi: VoronoiPointer): void {
    this.#wasm.run((core) => core.freeVoronoi(voronoi));
  }

  startCvt(mesh: MeshPointer, sites: SurfacePoints, settings: CvtSettings): CvtPointer {
    const { iterations, energyTolerance, moveTolerance, density, fixedSites } = settings;
    return this.#wasm.call((core, copyIn) =>
      core.startCvt(
        mesh,
        ...copyPoints(copyIn, sites),
        cvtMethods.indexOf(settings.method),
        metrics.indexOf(settings.metric),
        iterations,
        energyTolerance,
        moveTolerance,
        copyIn(density),
        density.length,
        copyIn(fixedSites),
        fixedSites.length,
      ),
    ) as CvtPointer;
  }

  /** Works on at most `budget` queue entries; true when an iteration is done. */
  stepCvt(cvt: CvtPointer, budget: number): boolean {
    return this.#wasm.call((core) => core.stepCvt(cvt, budget)) === sliceDone;
  }

  /** The iteration that is done. */
  cvtIteration(cvt: CvtPointer): Omit<CvtState, 'data' | 'diagram'> & { isLast: boolean } {
    const [counts, measures, face, bary] = this.#wasm.arrays((core) => core.cvtIteration(cvt)) as [
      Int32Array,
      Float64Array,
      Int32Array,
      Float64Array,
    ];
    const [iteration, isLast] = counts;
    const [energy, largestMove] = measures;
    return { iteration, isLast: isLast === 1, energy, largestMove, sites: { face, bary } };
  }

  /** The diagram of the iteration that is done. */
  cvtDiagram(cvt: CvtPointer): Omit<DiagramData, 'siteCount'> {
    return diagramData(this.#wasm.arrays((core) => core.cvtDiagram(cvt)));
  }

  /** The same diagram as an object. */
  cvtVoronoi(cvt: CvtPointer): VoronoiPointer {
    return this.#wasm.call((core) => core.cvtVoronoi(cvt)) as VoronoiPointer;
  }

  freeCvt(cvt: CvtPointer): void {
    this.#wasm.run((core) => core.freeCvt(cvt));
  }
}

/** Takes one array after the other. */
function reader(arrays: readonly unknown[]): {
  ints: () => Int32Array;
  doubles: () => Float64Array;
} {
  const rest = arrays.values();
  return {
    ints: () => rest.next().value as Int32Array,
    doubles: () => rest.next().value as Float64Array,
  };
}

function diagramData(arrays: readonly unknown[]): Omit<DiagramData, 'siteCount'> {
  const { ints, doubles } = reader(arrays);
  // Evaluated from top to bottom: the order of `addDiagram` in bindings.cpp.
  return {
    points: { face: ints(), bary: doubles(), position: doubles() },
    segments: { points: ints(), labels: ints(), face: ints(), arc: ints() },
    arcs: { offset: ints(), points: ints(), labels: ints() },
    voronoiPoints: { point: ints(), labelOffset: ints(), labels: ints() },
    loops: { offset: ints(), points: ints(), label: ints() },
    regionArea: doubles(),
    faceLabel: ints(),
    indifferentFaces: ints(),
    cells: { offset: ints(), points: ints(), face: ints(), label: ints() },
  };
}

function partitionData(arrays: readonly unknown[]): Partition {
  const { ints, doubles } = reader(arrays);
  return {
    points: { face: ints(), bary: doubles(), position: doubles() },
    triangles: { points: ints(), label: ints(), face: ints(), bary: doubles() },
    regions: {
      triangleOffset: ints(),
      area: doubles(),
      perimeter: doubles(),
      boundaryLength: doubles(),
      centroid: doubles(),
      nearCentroid: { face: ints(), bary: doubles() },
      components: ints(),
      loops: ints(),
      eulerCharacteristic: ints(),
      genus: ints(),
      selfTouchings: ints(),
      neighbours: { offset: ints(), label: ints(), length: doubles() },
    },
  };
}

function polygonMesh(arrays: readonly unknown[]): PolygonMesh {
  const { ints, doubles } = reader(arrays);
  return {
    points: { face: ints(), bary: doubles(), position: doubles() },
    faces: { offset: ints(), points: ints() },
    vertexLabel: ints(),
    faceLabel: ints(),
    triangles: { points: ints(), face: ints() },
    topology: topology(ints()),
  };
}

function topology([isManifold, ...counts]: Int32Array): PolygonTopology {
  return { isManifold: isManifold === 1, ...named(topologyCounts, counts) };
}

function diagramChange(arrays: readonly unknown[]): DiagramChange {
  const [[label], labels, faces, ...part] = arrays as [Int32Array, Int32Array, Int32Array];
  return { label, labels, faces, part: diagramData(part) };
}

function named<Name extends string>(
  names: readonly Name[],
  values: ArrayLike<number>,
): Record<Name, number> {
  return Object.fromEntries(names.map((name, i) => [name, values[i]])) as Record<Name, number>;
}

function surfacePoints(arrays: readonly unknown[]): SurfacePoints {
  const [face, bary] = arrays as [Int32Array, Float64Array];
  return { face, bary };
}

function copyPoints(copyIn: CopyIn, { face, bary }: SurfacePoints): [number, number, number] {
  return [copyIn(face), copyIn(bary), face.length];
}
