// SPDX-License-Identifier: MIT
import type { Encoders, EncodingRequest } from './encoding_worker.js';

/** A file of this media type, made in a worker that ends with it. The arguments are copied. */
export function encode<Name extends keyof Encoders>(
  type: string,
  name: Name,
  ...args: Parameters<Encoders[Name]>
): Promise<Blob> {
  const worker = new Worker(new URL('./encoding_worker.ts', import.meta.url), { type: 'module' });
  return new Promise<Blob>((resolve, reject) => {
    worker.onmessage = ({ data }: MessageEvent<Blob>) => resolve(data);
    worker.onerror = ({ message }) => reject(new Error(message || 'its worker cannot be started'));
    worker.postMessage({ name, args, type } satisfies EncodingRequest<Name>);
  }).finally(() => worker.terminate());
}
