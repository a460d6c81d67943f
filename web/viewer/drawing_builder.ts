// SPDX-License-Identifier: MIT
//
// Work of drawing that would keep the page from answering, done in a worker.

import type { DiagramData, Mesh } from 'geodesic-voronoi';
import type { Cells, CellTriangles } from './cell_triangles.js';
import type { DistanceSamples, DistanceTriangles } from './distance_triangles.js';
import type { Parts, PartTriangles } from './part_triangles.js';
import { PortedWorker } from './ported_worker.js';

/** First the mesh, then whatever is to be drawn of it. */
export type DrawingRequest =
  | { kind: 'mesh'; mesh: Pick<Mesh, 'positions' | 'indices'> }
  | { kind: 'cells'; cells: Cells }
  | { kind: 'parts'; partition: Parts; tones: Uint16Array }
  | { kind: 'distances'; samples: DistanceSamples };

const worker = new PortedWorker(
  () =>
    new Worker(new URL('./drawing_worker.js', import.meta.url), {
      type: 'module',
      name: 'geodesic-voronoi-drawing',
    }),
);

/** Makes triangles of what belongs to one mesh, in a worker, one for all elements. */
export class DrawingBuilder {
  readonly #port = worker.open(() => this.dispose());
  #isOver = false;
  /** Of the requests that are not answered, in their order. */
  readonly #waiting: ((result: never) => void)[] = [];

  constructor({ positions, indices }: Pick<Mesh, 'positions' | 'indices'>) {
    this.#port.onmessage = ({ data }) => this.#waiting.shift()?.(data as never);
    this.#port.postMessage({ kind: 'mesh', mesh: { positions, indices } } satisfies DrawingRequest);
  }

  /** The cells of a diagram. Undefined if there is no worker any more: whoever draws has to cut them. */
  cells({ cells, points }: DiagramData): Promise<CellTriangles | undefined> {
    // What is not asked for is not copied.
    return this.#ask({ kind: 'cells', cells: { cells, points: { position: points.position } } });
  }

  /** The regions, in these tones; the arrays of the partition are given away. Undefined as above. */
  parts(
    { points: { position }, triangles, regions: { centroid } }: Parts,
    tones: Uint16Array,
  ): Promise<PartTriangles | undefined> {
    const partition = { points: { position }, triangles, regions: { centroid } };
    const given = [position, ...Object.values(triangles)].map(({ buffer }) => buffer);
    return this.#ask({ kind: 'parts', partition, tones }, given as ArrayBuffer[]);
  }

  /** The surface with distances. Undefined as above. */
  distances(samples: DistanceSamples): Promise<DistanceTriangles | undefined> {
    return this.#ask({ kind: 'distances', samples });
  }

  dispose(): void {
    this.#isOver = true;
    worker.close(this.#port);
    for (const resolve of this.#waiting.splice(0)) resolve(undefined as never);
  }

  #ask<Result>(
    request: DrawingRequest,
    transfer: Transferable[] = [],
  ): Promise<Result | undefined> {
    return new Promise((resolve) => {
      this.#waiting.push(resolve);
      if (this.#isOver) this.dispose();
      else this.#port.postMessage(request, transfer);
    });
  }
}
