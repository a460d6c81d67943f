// SPDX-License-Identifier: MIT
//
// The far side of a worker: answers the calls that come through a port with an engine of its own. The
// other side is `worker_engine.ts`.

import { compileFromWeb } from '../base/compile.js';
import type { Engine, EngineSources, Handle } from './engine.js';
import { GeodesicVoronoiError, type ErrorCode } from '../api/errors.js';
import { LocalEngine } from './local_engine.js';

/** What the page sends. The first message loads; `abort` names an earlier `id`. */
export type Request =
  | { id: number; load: EngineSources }
  /** A function of the engine by its name, without the last argument: the options of the task. */
  | { id: number; call: string; args: readonly unknown[] }
  | { abort: number }
  | { close: Handle };

/** What the worker sends: for every `id` any number of shares done, then one result or error. */
export type Reply =
  | { id: number; progress: number }
  | { id: number; result: unknown }
  | { id: number; error: { code: ErrorCode; message: string } };

/** The result of loading. */
export type Loaded = Pick<Engine, 'version'>;

/** A worker's own scope, seen from inside. */
export interface Port {
  postMessage(message: unknown, transfer?: Transferable[]): void;
  onmessage: ((event: MessageEvent) => void) | null;
}

/** Answers by an engine on this thread. */
export function serveLocalEngine(port: Port): void {
  serve(port, (sources) => LocalEngine.load(sources, compileFromWeb));
}

export function serve(port: Port, loadEngine: (sources: EngineSources) => Promise<Engine>): void {
  let loading: Promise<Engine>;
  const tasks = new Map<number, AbortController>();

  const reply = (message: Reply) => port.postMessage(message, [...buffersOf(message)]);

  const load = async (sources: EngineSources): Promise<Loaded> => {
    loading = loadEngine(sources);
    return { version: (await loading).version };
  };

  const perform = async (id: number, name: string, args: readonly unknown[]): Promise<unknown> => {
    const controller = new AbortController();
    tasks.set(id, controller);
    const task = {
      signal: controller.signal,
      onProgress: (progress: number) => reply({ id, progress }),
    };
    const engine = (await loading) as unknown as Record<string, (...args: unknown[]) => unknown>;
    return engine[name](...args, task);
  };

  const answer = async (id: number, result: Promise<unknown>): Promise<void> => {
    try {
      reply({ id, result: await result });
    } catch (error) {
      const code = error instanceof GeodesicVoronoiError ? error.code : 'internal';
      const message = error instanceof Error ? error.message : String(error);
      reply({ id, error: { code, message } });
    } finally {
      tasks.delete(id);
    }
  };

  port.onmessage = ({ data }: { data: Request }) => {
    if ('load' in data) void answer(data.id, load(data.load));
    else if ('call' in data) void answer(data.id, perform(data.id, data.call, data.args));
    else if ('abort' in data) tasks.get(data.abort)?.abort();
    else
      void loading.then(
        (engine) => engine.close(data.close),
        () => {}, // nothing was loaded, so there is nothing to close
      );
  };
}

/** The buffers of all arrays in a message. They are transferred, since results are copies already. */
function buffersOf(value: unknown, found = new Set<ArrayBuffer>()): Set<ArrayBuffer> {
  if (ArrayBuffer.isView(value)) found.add(value.buffer as ArrayBuffer);
  else if (typeof value === 'object' && value !== null)
    for (const inner of Object.values(value)) buffersOf(inner, found);
  return found;
}
