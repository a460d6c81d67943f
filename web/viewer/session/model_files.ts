// SPDX-License-Identifier: MIT
//
// The files of a model, as a person gives them: chosen, dropped, or by an address.

import { gltfResourceUris, type ModelFiles, type TaskOptions } from 'geodesic-voronoi';
import { sentence } from './failure.js';

/** Files, and a name for them until the model is found among them. */
export interface NamedFiles {
  name: string;
  files: ModelFiles;
  /** The path of the model to open, of several. */
  file?: string;
  /** Fetches a further file that the model refers to, from the model's own address. */
  fetchBeside?: (uri: string, signal: AbortSignal) => Promise<Uint8Array>;
}

export type Task = Required<TaskOptions>;

/** What a caller gives as files, and a list of them as a copy: the one of a page's input is emptied. */
export function givenFiles(files: File | Iterable<File> | ModelFiles): File[] | ModelFiles {
  if (typeof files !== 'object' || files === null)
    throw new TypeError('Files are a File, a list of these, or an object of files by their paths.');
  if (files instanceof File) return [files];
  return Symbol.iterator in files ? [...files] : files;
}

/** Files that were chosen: those of a folder have a path. They are read if the model needs them. */
export function chosenFiles(files: Iterable<File>): ModelFiles {
  return byPath([...files].map((file) => [file.webkitRelativePath || file.name, file]));
}

/** Files named after the model that is wanted, or after the only one. */
export function named(given: File[] | ModelFiles, file?: string): NamedFiles {
  const files = Array.isArray(given) ? chosenFiles(given) : given;
  const paths = Object.keys(files);
  const path = file ?? (paths.length === 1 ? paths[0] : undefined);
  return { name: path === undefined ? 'The model' : lastSegment(path), files, file };
}

/** Files and folders that were dropped; to be called before the drop's event is over. */
export function droppedFiles(dropped: DataTransfer): Promise<ModelFiles> {
  const found = [...dropped.items]
    .filter(({ kind }) => kind === 'file')
    .map((item) => {
      const entry = item.webkitGetAsEntry();
      const file = item.getAsFile();
      return entry?.isDirectory || !file ? filesIn(entry) : [[file.name, file] as [string, File]];
    });
  const files = Promise.all(found).then((lists) => byPath(lists.flat()));
  files.catch(() => {}); // whoever opens them hears of it
  return files;
}

/** Requests that a page has made before, by address; the response to each is read once. */
const provided = new Map<string, typeof request>();

/** Provides the request for the model at an address, for the next time that it is asked for. */
export function provideModel(address: string, made: typeof request): void {
  provided.set(new URL(address, document.baseURI).href, made);
}

function request(signal: AbortSignal, url: URL): Promise<Response> {
  return fetch(url, { signal });
}

/** The model at an address (a path after a # chooses one in a zip), fetching files it refers to. */
export async function fetchModelFiles(
  address: string,
  { signal, onProgress }: Task,
): Promise<NamedFiles> {
  const url = urlOf(address);
  const name = nameOf(url);
  const fetchBeside = (uri: string, signal: AbortSignal) => fetchBytes(urlOf(uri, url), signal);
  const bytes = await fetchBytes(url, signal, onProgress);
  const further = await fetchAll(gltfResourceUris(bytes), fetchBeside, signal);
  const files = Object.fromEntries([[name, bytes], ...further]);
  const file = url.hash ? decoded(url.hash.slice(1)) : undefined;
  return { name, files, file, fetchBeside };
}

/** Fetches files; if one fails, the others are given up. */
async function fetchAll(
  uris: readonly string[],
  fetchOne: (uri: string, signal: AbortSignal) => Promise<Uint8Array>,
  signal: AbortSignal,
): Promise<[uri: string, bytes: Uint8Array][]> {
  signal.throwIfAborted();
  const ending = new AbortController();
  const end = () => ending.abort(signal.reason);
  signal.addEventListener('abort', end, { signal: ending.signal });
  const fetched = uris.map(
    async (uri): Promise<[string, Uint8Array]> => [uri, await fetchOne(uri, ending.signal)],
  );
  return Promise.all(fetched).finally(() => ending.abort());
}

function urlOf(address: string, base: string | URL = document.baseURI): URL {
  try {
    return new URL(address, base);
  } catch {
    const beside = base instanceof URL ? ` beside a model at “${base.protocol}…”` : '';
    throw new Error(`“${address}” is not an address${beside}.`);
  }
}

/** The most files of a folder: models have a few, and a larger folder was dropped by mistake. */
const maxFiles = 10_000;

function byPath(files: [string, File][]): ModelFiles {
  if (files.length > maxFiles) {
    throw new Error(`There are more than ${maxFiles} files: choose the model and those it needs.`);
  }
  return Object.fromEntries(files);
}

/** All files in a folder, by their paths. */
async function filesIn(entry: FileSystemEntry | null): Promise<[string, File][]> {
  if (entry?.isFile) {
    const file = await new Promise<File>((done, fail) =>
      (entry as FileSystemFileEntry).file(done, (cause) =>
        fail(sentence(`The file ${entry.name} cannot be read`, cause)),
      ),
    );
    return [[entry.fullPath.slice(1), file]];
  }
  if (!entry?.isDirectory) return [];
  const reader = (entry as FileSystemDirectoryEntry).createReader();
  const files: [string, File][] = [];
  // A folder is handed over a hundred entries at a time.
  for (;;) {
    const entries = await new Promise<FileSystemEntry[]>((done, fail) =>
      reader.readEntries(done, (cause) =>
        fail(sentence(`The folder ${entry.name} cannot be read`, cause)),
      ),
    );
    if (entries.length === 0 || files.length > maxFiles) return files;
    for (const inner of entries) files.push(...(await filesIn(inner)));
  }
}

async function fetchBytes(
  url: URL,
  signal: AbortSignal,
  onProgress?: Task['onProgress'],
): Promise<Uint8Array> {
  const name = nameOf(url);
  let response: Response;
  try {
    const made = provided.get(url.href) ?? request;
    provided.delete(url.href);
    response = await made(signal, url);
  } catch (cause) {
    signal.throwIfAborted();
    throw new Error(`${name} cannot be fetched: the server does not answer.`, { cause });
  }
  if (!response.ok) {
    throw new Error(`${name} cannot be fetched: the server answers ${response.status}.`);
  }
  try {
    return await bytesOf(response, signal, onProgress);
  } catch (cause) {
    signal.throwIfAborted();
    throw new Error(`${name} cannot be fetched: the connection has ended.`, { cause });
  }
}

async function bytesOf(
  response: Response,
  signal: AbortSignal,
  onProgress?: Task['onProgress'],
): Promise<Uint8Array> {
  if (!response.body) return new Uint8Array(await response.arrayBuffer());

  // With a content encoding, the header gives the length before decoding.
  const length = response.headers.has('Content-Encoding')
    ? 0
    : Number(response.headers.get('Content-Length'));
  const chunks: Uint8Array[] = [];
  let received = 0;
  const reader = response.body.getReader();
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    signal.throwIfAborted();
    chunks.push(part.value);
    received += part.value.length;
    if (length > 0) onProgress?.(Math.min(1, received / length));
  }
  const bytes = new Uint8Array(received);
  let offset = 0;
  for (const chunk of chunks) {
    bytes.set(chunk, offset);
    offset += chunk.length;
  }
  return bytes;
}

/** The last part of an address that has one, as that of a folder has not. */
function nameOf(url: URL): string {
  return lastSegment(url.pathname) || url.href;
}

/** The part of a path after its last slash, with escapes decoded. */
export function lastSegment(path: string): string {
  return decoded(path.slice(path.lastIndexOf('/') + 1));
}

function decoded(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}
