// SPDX-License-Identifier: MIT
import type { Engine, EngineSources, Handle } from './engine.js';
import type { ErrorCode } from './types.js';

/** The calls of an engine that are answered; the last argument, a task's options, stays behind. */
export type EngineCall =
  | 'openMesh'
  | 'pointsAtVertices'
  | 'sampleSites'
  | 'openDiagram'
  | 'distances'
  | 'path'
  | 'pathToSite'
  | 'insertSite'
  | 'moveSite'
  | 'removeSite'
  | 'locate'
  | 'partition'
  | 'dual'
  | 'violations'
  | 'quality'
  | 'repairingSites'
  | 'openCvt'
  | 'advanceCvt';

/** What the page sends. The first message is 'load'; `abort` names an earlier `id`. */
export type Request =
  | { id: number; call: 'load'; args: [EngineSources] }
  | { id: number; call: EngineCall; args: unknown[] }
  | { abort: number }
  | { close: Handle };

/** What the worker sends: for every `id` any number of shares done, then one result or error. */
export type Reply =
  | { id: number; progress: number }
  | { id: number; result: unknown }
  | { id: number; error: { code: ErrorCode; message: string } };

/** The result of 'load'. */
export type Loaded = Pick<Engine, 'version'>;

/** A worker's own scope, seen from inside. */
export interface Port {
  postMessage(message: unknown, transfer?: Transferable[]): void;
  onmessage: ((event: MessageEvent) => void) | null;
}

/** A `Worker`, seen from outside. */
export interface WorkerPort extends Port {
  onerror: ((event: ErrorEvent) => void) | null;
  terminate(): void;
}
