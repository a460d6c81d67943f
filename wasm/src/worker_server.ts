// SPDX-License-Identifier: MIT
import type { Engine, EngineSources } from './engine.js';
import { GeodesicVoronoiError } from './errors.js';
import type { TaskOptions } from './types.js';
import type { Loaded, Port, Reply, Request } from './worker_protocol.js';

/** Answers the requests that come through a port with an engine of its own. */
export function serve(port: Port, loadEngine: (sources: EngineSources) => Promise<Engine>): void {
  let loading: Promise<Engine>;
  const tasks = new Map<number, AbortController>();

  const reply = (message: Reply) => port.postMessage(message, buffersOf(message));

  const perform = async (
    request: Extract<Request, { call: unknown }>,
    task: TaskOptions,
  ): Promise<unknown> => {
    if (request.call === 'load') {
      loading = loadEngine(...request.args);
      const { version } = await loading;
      return { version } satisfies Loaded;
    }
    const engine = (await loading) as unknown as Record<string, (...args: unknown[]) => unknown>;
    return engine[request.call](...request.args, task);
  };

  const answer = async (request: Extract<Request, { call: unknown }>): Promise<void> => {
    const { id } = request;
    const controller = new AbortController();
    tasks.set(id, controller);
    const task = {
      signal: controller.signal,
      onProgress: (progress: number) => reply({ id, progress }),
    };
    try {
      reply({ id, result: await perform(request, task) });
    } catch (error) {
      const code = error instanceof GeodesicVoronoiError ? error.code : 'internal';
      reply({
        id,
        error: { code, message: error instanceof Error ? error.message : String(error) },
      });
    } finally {
      tasks.delete(id);
    }
  };

  port.onmessage = ({ data }: { data: Request }) => {
    if ('call' in data) void answer(data);
    else if ('abort' in data) tasks.get(data.abort)?.abort();
    else void loading.then((engine) => engine.close(data.close));
  };
}

/** The buffers of all arrays in a message. Results are copies already: they move, not copied again. */
function buffersOf(value: unknown): ArrayBuffer[] {
  if (ArrayBuffer.isView(value)) return [value.buffer as ArrayBuffer];
  if (typeof value !== 'object' || value === null) return [];
  return Object.values(value).flatMap(buffersOf);
}
