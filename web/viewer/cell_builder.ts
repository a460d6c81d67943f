// SPDX-License-Identifier: MIT
import type { DiagramData, Mesh } from 'geodesic-voronoi';
import type { Cells, CellTriangles } from './cell_triangles.js';
import { PortedWorker } from './ported_worker.js';

/** First the mesh, then the cells of one diagram after the other. */
export type CellRequest = Pick<Mesh, 'positions' | 'indices'> | Cells;

const worker = new PortedWorker(
  () =>
    new Worker(new URL('./cell_worker.js', import.meta.url), {
      type: 'module',
      name: 'geodesic-voronoi-drawing',
    }),
);

/**
 * Cuts the cells of a mesh's diagrams into triangles in a worker, one for all elements: most of the work
 * of drawing a diagram, which would keep the page from answering.
 */
export class CellBuilder {
  readonly #port = worker.open(() => this.dispose());
  #isOver = false;
  /** Of the requests that are not answered, in their order. */
  readonly #waiting: ((result: CellTriangles | undefined) => void)[] = [];

  constructor({ positions, indices }: Pick<Mesh, 'positions' | 'indices'>) {
    this.#port.onmessage = ({ data }) => this.#waiting.shift()?.(data);
    this.#post({ positions, indices });
  }

  /** Undefined if there is no worker any more: whoever draws has to cut them. */
  build({ cells, points }: DiagramData): Promise<CellTriangles | undefined> {
    return new Promise((resolve) => {
      this.#waiting.push(resolve);
      if (this.#isOver) this.dispose();
      // What is not asked for is not copied.
      else this.#post({ cells, points: { position: points.position } });
    });
  }

  dispose(): void {
    this.#isOver = true;
    worker.close(this.#port);
    for (const resolve of this.#waiting.splice(0)) resolve(undefined);
  }

  #post(request: CellRequest): void {
    this.#port.postMessage(request);
  }
}
