// SPDX-License-Identifier: MIT
//
// Preparations for drawing that would block the page, done in a worker.

import type { DiagramData, Mesh } from 'geodesic-voronoi';
import type { DistanceSamples } from './distance_triangles.js';
import type { DrawingAnswer, DrawingRequest, DrawingTasks } from './drawing_worker.js';
import type { Parts } from './part_triangles.js';
import type { DrawnPixels, PictureFormat } from '../stage/picture_file.js';
import { PortedWorker } from './ported_worker.js';

const worker = new PortedWorker(
  () =>
    new Worker(new URL('./drawing_worker.js', import.meta.url), {
      type: 'module',
      name: 'geodesic-voronoi-drawing',
    }),
);

/**
 * Makes what is drawn of one mesh, or files of pictures, in a worker, which all elements share.
 * Results are undefined if the worker has stopped: the caller has to make them then, or to say so.
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
    // An answer that is too large for the memory there is: nobody knows to which request.
    this.#port.onmessageerror = () => this.dispose();
  }

  /** True once the worker has started. */
  answers() {
    return this.#ask('answers', []);
  }

  /** The mesh in the scene. This request has to come before others about it. */
  scene({ positions, indices }: Pick<Mesh, 'positions' | 'indices'>) {
    return this.#ask('scene', [{ positions, indices }]);
  }

  /** The search tree of triangles; undefined also where a worker cannot load its code. */
  tree() {
    return this.#ask('tree', []);
  }

  /** See `meshEdges`. */
  edges() {
    return this.#ask('edges', []);
  }

  /** See `adjacencyOf`. */
  adjacency() {
    return this.#ask('adjacency', []);
  }

  diagram({ cells, points: { position }, segments: { points } }: DiagramData) {
    // Only the arrays that are needed are copied to the worker.
    return this.#ask('diagram', [{ cells, points: { position }, segments: { points } }]);
  }

  /** The regions, in these tones; the arrays of the partition are given away. */
  parts({ points: { position }, triangles, regions: { centroid } }: Parts, tones: Uint16Array) {
    const partition = { points: { position }, triangles, regions: { centroid } };
    const given = [position, ...Object.values(triangles)].map(({ buffer }) => buffer);
    return this.#ask('parts', [partition, tones], given as ArrayBuffer[]);
  }

  /** See `cornersToAsk`. */
  corners({ faceLabel }: Pick<DiagramData, 'faceLabel'>) {
    return this.#ask('corners', [faceLabel]);
  }

  /** The surface with distances. */
  distances(samples: DistanceSamples) {
    return this.#ask('distances', [samples]);
  }

  /** See `plySurface`; undefined also where a worker cannot load its code. */
  plySurface(bytes: Uint8Array) {
    const own = bytes.slice();
    return this.#ask('ply', [own], [own.buffer]);
  }

  /** The pixels are given away. */
  picture(drawn: DrawnPixels, format: PictureFormat) {
    return this.#ask('picture', [drawn, format], [drawn.pixels.buffer]);
  }

  dispose(): void {
    this.#isOver = true;
    worker.close(this.#port);
    for (const resolve of this.#waiting.values()) resolve(undefined as never);
    this.#waiting.clear();
  }

  #ask<Name extends keyof DrawingTasks>(
    name: Name,
    args: Parameters<DrawingTasks[Name]>,
    transfer: Transferable[] = [],
  ): Promise<Awaited<ReturnType<DrawingTasks[Name]>> | undefined> {
    if (this.#isOver) return Promise.resolve(undefined);
    const id = ++this.#lastId;
    return new Promise((resolve) => {
      this.#waiting.set(id, resolve);
      this.#port.postMessage({ id, name, args } satisfies DrawingRequest<Name>, transfer);
    });
  }
}

/** The file of a picture whose pixels are given away. The model may be closed meanwhile. */
export async function fileOfPicture(drawn: DrawnPixels, format: PictureFormat): Promise<Blob> {
  const builder = new DrawingBuilder();
  try {
    // A worker that does not start would take the pixels with it.
    const made = (await builder.answers()) && (await builder.picture(drawn, format));
    if (made) return made;
  } finally {
    builder.dispose();
  }
  if (drawn.pixels.length === 0) throw new Error('The picture cannot be made.');
  return (await import('../stage/picture_file.js')).pictureFile(drawn, format);
}
