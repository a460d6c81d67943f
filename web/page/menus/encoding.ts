// SPDX-License-Identifier: MIT
//
// Files made in a worker.

import { buffersOf } from '../../viewer/buffers/transfer.js';
import type { Encoders, EncodingRequest } from './encoding_worker.js';

/**
 * Makes a file of this media type in a worker of its own. Partitions and polygons are transferred,
 * since nobody else has them; other arguments are copied.
 */
export function encode<Name extends keyof Encoders>(
  type: string,
  name: Name,
  ...args: Parameters<Encoders[Name]>
): Promise<Blob> {
  const worker = new Worker(new URL('./encoding_worker.ts', import.meta.url), { type: 'module' });
  return new Promise<Blob>((resolve, reject) => {
    worker.onmessage = ({ data }: MessageEvent<Blob | string>) =>
      typeof data === 'string' ? reject(new Error(data)) : resolve(data);
    worker.onerror = ({ message }) => reject(new Error(message || 'its worker cannot be started'));
    const given = name.startsWith('diagram') ? [] : [...buffersOf(args[0])];
    worker.postMessage({ name, args, type } satisfies EncodingRequest<Name>, given);
  }).finally(() => worker.terminate());
}
