// SPDX-License-Identifier: MIT
import type { DiagramData, Mesh } from 'geodesic-voronoi';
import type { Cells, CellTriangles } from './cell_triangles.js';

/** First the mesh, then the cells of one diagram after the other. */
export type CellRequest = Pick<Mesh, 'positions' | 'indices'> | Cells;

/**
 * Cuts the cells of a mesh's diagrams into triangles in a worker of its own: most of the work of drawing
 * a diagram, which would keep the page from answering.
 */
export class CellBuilder {
  readonly #worker: Worker;
  #isOver = false;
  /** Of the requests that are not answered, in their order. */
  readonly #waiting: ((result: CellTriangles | undefined) => void)[] = [];

  constructor({ positions, indices }: Pick<Mesh, 'positions' | 'indices'>) {
    this.#worker = new Worker(new URL('./cell_worker.js', import.meta.url), { type: 'module' });
    this.#worker.onmessage = ({ data }) => this.#waiting.shift()?.(data);
    this.#worker.onerror = () => this.dispose();
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
    this.#worker.terminate();
    for (const resolve of this.#waiting.splice(0)) resolve(undefined);
  }

  #post(request: CellRequest): void {
    this.#worker.postMessage(request);
  }
}
