// SPDX-License-Identifier: MIT
//
// Preparations for drawing that would block the page, done in a worker.

import type { DrawingAnswer, DrawingRequest, DrawingTasks } from './drawing_worker.js';
import type { DrawnPixels, PictureFormat } from '../stage/picture_file.js';
import { buffersOf } from './transfer.js';

/** The worker of all builders, each of which talks to it through a port of its own. */
let worker: Worker | undefined;
const builders = new Set<DrawingBuilder>();

/** The tasks whose arguments are given away; those of others are copied. */
const givenAway: ReadonlySet<keyof DrawingTasks> = new Set(['parts', 'ply', 'picture']);

/**
 * Makes what is drawn of one mesh, or files of pictures, in a worker, which starts with the first
 * builder and ends with the last one.
 */
export class DrawingBuilder {
  readonly #port: MessagePort;
  #isOver = false;
  /** The requests that are not answered, by their numbers. */
  readonly #waiting = new Map<number, (result: never) => void>();
  #lastId = 0;

  constructor() {
    const { port1, port2 } = new MessageChannel();
    worker ??= started();
    worker.postMessage(port2, [port2]);
    builders.add(this);
    this.#port = port1;
    port1.onmessage = ({ data: { id, result } }: MessageEvent<DrawingAnswer>) => {
      this.#waiting.get(id)?.(result as never);
      this.#waiting.delete(id);
    };
    // An answer that is too large for the memory there is: nobody knows to which request.
    port1.onmessageerror = () => this.dispose();
  }

  /**
   * Asks for a task by its name in `drawing_worker.ts`: 'scene' before others about the mesh. The
   * result is undefined if the worker has stopped, cannot load the task's code, or cannot get the
   * arguments: the caller has to make it then, or to say so.
   */
  ask<Name extends keyof DrawingTasks>(
    name: Name,
    ...args: Parameters<DrawingTasks[Name]>
  ): Promise<Awaited<ReturnType<DrawingTasks[Name]>> | undefined> {
    if (this.#isOver) return Promise.resolve(undefined);
    const id = ++this.#lastId;
    const given = givenAway.has(name) ? [...buffersOf(args)] : [];
    return new Promise((resolve) => {
      try {
        this.#port.postMessage({ id, name, args } satisfies DrawingRequest<Name>, given);
        this.#waiting.set(id, resolve);
      } catch {
        resolve(undefined); // there is no memory for a copy of the arguments
      }
    });
  }

  dispose(): void {
    this.#isOver = true;
    this.#port.close();
    builders.delete(this);
    if (builders.size === 0) {
      worker?.terminate();
      worker = undefined;
    }
    for (const resolve of this.#waiting.values()) resolve(undefined as never);
    this.#waiting.clear();
  }
}

function started(): Worker {
  const one = new Worker(new URL('./drawing_worker.js', import.meta.url), {
    type: 'module',
    name: 'geodesic-voronoi-drawing',
  });
  one.onerror = () => {
    if (one === worker) for (const builder of [...builders]) builder.dispose();
  };
  return one;
}

/** The file of a picture whose pixels are given away. The model may be closed meanwhile. */
export async function fileOfPicture(drawn: DrawnPixels, format: PictureFormat): Promise<Blob> {
  const builder = new DrawingBuilder();
  try {
    // A worker that does not start would take the pixels with it.
    const made = (await builder.ask('answers')) && (await builder.ask('picture', drawn, format));
    if (made) return made;
  } finally {
    builder.dispose();
  }
  if (drawn.pixels.length === 0) throw new Error('The picture cannot be made.');
  return (await import('../stage/picture_file.js')).pictureFile(drawn, format);
}
