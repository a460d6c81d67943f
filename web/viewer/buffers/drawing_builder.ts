// SPDX-License-Identifier: MIT
//
// Preparations for drawing that would block the page, done in a worker.

import type { DiagramData, Mesh } from 'geodesic-voronoi';
import type { DiagramGeometry, DiagramLines } from './diagram_geometry.js';
import type { DistanceSamples, DistanceTriangles } from './distance_triangles.js';
import type { Parts, PartTriangles } from './part_triangles.js';
import type { DrawnPixels, PictureFormat } from '../stage/picture_file.js';
import type { PlySurface } from './ply_surface.js';
import { PortedWorker } from './ported_worker.js';
import type { SceneArrays } from './scene_arrays.js';
import type { BuiltTree } from './search_tree.js';

/** The tasks of the worker: first the mesh, then anything to be drawn of it. */
export type DrawingTask =
  | { kind: 'mesh'; mesh: Pick<Mesh, 'positions' | 'indices'> }
  | { kind: 'tree' }
  | { kind: 'edges' }
  | { kind: 'diagram'; diagram: DiagramLines }
  | { kind: 'parts'; partition: Parts; tones: Uint16Array }
  | { kind: 'distances'; samples: DistanceSamples }
  | { kind: 'ply'; bytes: Uint8Array }
  | { kind: 'picture'; drawn: DrawnPixels; format: PictureFormat };

/** A request to the worker; the answer has the same number, and is undefined after a failure. */
export interface DrawingRequest {
  id: number;
  task: DrawingTask;
}
export interface DrawingAnswer {
  id: number;
  result: unknown;
}

const worker = new PortedWorker(
  () =>
    new Worker(new URL('./drawing_worker.js', import.meta.url), {
      type: 'module',
      name: 'geodesic-voronoi-drawing',
    }),
);

/**
 * Makes what is drawn of one mesh in a worker, which all elements share. Results are undefined if
 * the worker has stopped: the caller has to make them then.
 */
export class DrawingBuilder {
  readonly #port = worker.open(() => this.dispose());
  #isOver = false;
  /** The requests that are not answered, by their numbers. */
  readonly #waiting = new Map<number, (result: never) => void>();
  #lastId = 0;

  constructor() {
    this.#port.onmessage = ({ data: { id, result } }: MessageEvent<DrawingAnswer>) => {
      this.#waiting.get(id)?.(result as never);
      this.#waiting.delete(id);
    };
  }

  /** The mesh in the scene. This request has to come first. */
  scene({ positions, indices }: Pick<Mesh, 'positions' | 'indices'>) {
    return this.#ask<SceneArrays>({ kind: 'mesh', mesh: { positions, indices } });
  }

  /** The search tree of triangles; undefined also where a worker cannot load its code. */
  tree() {
    return this.#ask<BuiltTree>({ kind: 'tree' });
  }

  /** See `meshEdges`. */
  edges() {
    return this.#ask<Uint32Array>({ kind: 'edges' });
  }

  diagram({ cells, points: { position }, segments: { points } }: DiagramData) {
    // Only the arrays that are needed are copied to the worker.
    const diagram = { cells, points: { position }, segments: { points } };
    return this.#ask<DiagramGeometry>({ kind: 'diagram', diagram });
  }

  /** The regions, in these tones; the arrays of the partition are given away. */
  parts({ points: { position }, triangles, regions: { centroid } }: Parts, tones: Uint16Array) {
    const partition = { points: { position }, triangles, regions: { centroid } };
    const given = [position, ...Object.values(triangles)].map(({ buffer }) => buffer);
    return this.#ask<PartTriangles>({ kind: 'parts', partition, tones }, given as ArrayBuffer[]);
  }

  /** The surface with distances. */
  distances(samples: DistanceSamples) {
    return this.#ask<DistanceTriangles>({ kind: 'distances', samples });
  }

  /** See `plySurface`; undefined also where a worker cannot load its code. */
  plySurface(bytes: Uint8Array) {
    const own = bytes.slice();
    return this.#ask<PlySurface | null>({ kind: 'ply', bytes: own }, [own.buffer]);
  }

  /** The pixels are given away. */
  picture(drawn: DrawnPixels, format: PictureFormat) {
    return this.#ask<Blob>({ kind: 'picture', drawn, format }, [drawn.pixels.buffer]);
  }

  dispose(): void {
    this.#isOver = true;
    worker.close(this.#port);
    for (const resolve of this.#waiting.values()) resolve(undefined as never);
    this.#waiting.clear();
  }

  #ask<Result>(task: DrawingTask, transfer: Transferable[] = []): Promise<Result | undefined> {
    if (this.#isOver) return Promise.resolve(undefined);
    const id = ++this.#lastId;
    return new Promise((resolve) => {
      this.#waiting.set(id, resolve);
      this.#port.postMessage({ id, task } satisfies DrawingRequest, transfer);
    });
  }
}

/** The file of a picture whose pixels are given away; a builder makes it if there is one. */
export async function fileOfPicture(
  drawn: DrawnPixels,
  format: PictureFormat,
  builder: DrawingBuilder | undefined,
): Promise<Blob> {
  const made = await builder?.picture(drawn, format);
  if (made) return made;
  if (drawn.pixels.length === 0) throw new Error('The picture cannot be made.');
  return (await import('../stage/picture_file.js')).pictureFile(drawn, format);
}
