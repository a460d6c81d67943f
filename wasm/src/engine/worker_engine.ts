// SPDX-License-Identifier: MIT
//
// An engine in a worker: every call is a message to it and one back. Calls are forwarded by name,
// so no function is listed here. The far side is `worker_server.ts`.

import type { Engine, EngineSources, Handle } from './engine.js';
import { GeodesicVoronoiError, invalidArgument } from '../api/errors.js';
import type { TaskOptions } from '../api/options.js';
import type { Loaded, Port, Reply, Request } from './worker_server.js';

/** A `Worker`, seen from outside. */
interface WorkerPort extends Port {
  onerror: ((event: ErrorEvent) => void) | null;
  addEventListener(type: 'messageerror', listener: () => void): void;
  terminate(): void;
}

/** Loads the library in a worker, which errors call by this name; disposing the engine ends that. */
export async function startWorkerEngine(
  worker: WorkerPort,
  sources: EngineSources,
  name: string,
): Promise<Engine> {
  const connection = new Connection(worker, name);
  try {
    return engineOver(connection, await connection.load(sources));
  } catch (error) {
    connection.close('disposed', 'the library has not been loaded');
    throw error;
  }
}

function engineOver(connection: Connection, { version }: Loaded): Engine {
  const own = {
    version,
    close: (object: Handle) => connection.post({ close: object }),
    dispose: () => connection.close('disposed', 'the library has been disposed'),
    then: undefined, // else whoever awaits an engine would take it for a promise
  };
  return new Proxy(own, {
    get: (_, name) =>
      name in own
        ? Reflect.get(own, name)
        : (...args: unknown[]) => connection.call(String(name), args.slice(0, -1), args.at(-1)!),
  }) as unknown as Engine;
}

/** A request that is not answered yet. */
interface Pending {
  resolve(result: unknown): void;
  reject(reason: unknown): void;
  onProgress?(share: number): void;
}

class Connection {
  readonly #worker: WorkerPort;
  readonly #pending = new Map<number, Pending>();
  #isLoaded = false;
  #lastId = 0;
  #closed: GeodesicVoronoiError | undefined;

  constructor(worker: WorkerPort, name: string) {
    this.#worker = worker;
    worker.onmessage = ({ data }: { data: Reply }) => this.#receive(data);
    const stop = (why: string) =>
      this.close(this.#isLoaded ? 'internal' : 'load-failed', `${name} has stopped: ${why}`);
    worker.onerror = ({ message }) => stop(message || 'its script cannot be loaded');
    // Nobody knows which request it answers. It may be too large for the memory there is. Chromium has
    // no `onmessageerror` of workers.
    worker.addEventListener('messageerror', () => stop('its answer cannot be received'));
  }

  async load(sources: EngineSources): Promise<Loaded> {
    const loaded = await this.#request((id) => ({ id, load: sources }), {});
    this.#isLoaded = true;
    return loaded as Loaded;
  }

  call(name: string, args: readonly unknown[], task: TaskOptions): Promise<unknown> {
    return this.#request((id) => ({ id, call: name, args }), task);
  }

  post(message: Request): void {
    if (!this.#closed) this.#worker.postMessage(message);
  }

  close(...reason: ConstructorParameters<typeof GeodesicVoronoiError>): void {
    if (this.#closed) return;
    this.#closed = new GeodesicVoronoiError(...reason);
    this.#worker.terminate();
    for (const { reject } of this.#pending.values()) reject(this.#closed);
    this.#pending.clear();
  }

  async #request(
    message: (id: number) => Request,
    { signal, onProgress }: TaskOptions,
  ): Promise<unknown> {
    if (this.#closed) throw this.#closed;
    signal?.throwIfAborted();
    const id = ++this.#lastId;
    let abandon = () => {};
    try {
      return await new Promise((resolve, reject) => {
        abandon = () => {
          this.#abandon(id);
          reject(signal?.reason);
        };
        signal?.addEventListener('abort', abandon);
        this.#pending.set(id, { resolve, reject, onProgress });
        try {
          this.post(message(id));
        } catch (cause) {
          this.#pending.delete(id);
          const why = (cause as Error).message;
          reject(invalidArgument(`an argument cannot be sent to the worker: ${why}`));
        }
      });
    } finally {
      signal?.removeEventListener('abort', abandon);
    }
  }

  /** Aborts a request whose answer nobody wants; an answer that comes nevertheless is freed. */
  #abandon(id: number): void {
    this.#pending.set(id, {
      resolve: (late) => {
        const handle = (late as { handle?: Handle } | undefined)?.handle;
        if (handle !== undefined) this.post({ close: handle });
      },
      reject: () => {},
    });
    this.post({ abort: id });
  }

  #receive(reply: Reply): void {
    const pending = this.#pending.get(reply.id);
    if (!pending) return;
    if ('progress' in reply) {
      this.#report(reply.id, pending, reply.progress);
      return;
    }
    this.#pending.delete(reply.id);
    if ('result' in reply) pending.resolve(reply.result);
    else pending.reject(new GeodesicVoronoiError(reply.error.code, reply.error.message));
  }

  /** An error thrown by the progress listener ends the task, as it does on one thread. */
  #report(id: number, { onProgress, reject }: Pending, share: number): void {
    try {
      onProgress?.(share);
    } catch (error) {
      this.#abandon(id);
      reject(error);
    }
  }
}
