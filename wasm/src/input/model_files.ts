// SPDX-License-Identifier: MIT
//
// The files of a model: which of them is the model, and which file a URI in it refers to.

import { isA } from '../base/checks.js';
import { GeodesicVoronoiError, invalidFile } from '../api/errors.js';
import type { ModelFile, ModelFiles, TaskOptions } from '../api/options.js';

const modelName = /\.(glb|gltf|obj|off|ply|stl)$/i;
const archiveName = /\.zip$/i;

export class FileSet {
  readonly #files: ReadonlyMap<string, ModelFile>;
  readonly #paths: ReadonlyMap<string, string>;

  /** `files` are named by paths, or by the URIs that a glTF uses for them. */
  constructor(files: ModelFiles) {
    this.#files = new Map(Object.entries(files));
    this.#paths = new Map([...this.#files.keys()].map((path) => [normalised(path) ?? path, path]));
  }

  /**
   * The one file that is a model, or an archive with one in it; a file alone may have any name. Of
   * several, the wanted one, or the archive that it may be in.
   */
  model(wanted?: string): string {
    if (wanted !== undefined && this.#files.has(wanted)) return wanted;
    const paths = this.#visible();
    const models = this.models();
    const archives = paths.filter((path) => archiveName.test(path));
    const isModelGiven = wanted === undefined && models.length > 0;
    const candidates = paths.length === 1 ? paths : isModelGiven ? models : archives;
    if (candidates.length === 1) return candidates[0];
    if (wanted !== undefined) throw this.missing(wanted);
    if (candidates.length > 1) {
      throw new GeodesicVoronoiError(
        'several-models',
        `${listed(candidates)} are several models: choose one by its path`,
      );
    }
    const found = paths.length > 0 ? ` in ${listed(paths)}` : ': there are no files';
    throw invalidFile(
      `there is no model${found}; a model is a .glb, .gltf, .obj, .off, .ply or .stl, or a .zip with one`,
    );
  }

  /** The paths of files that are named like models. */
  models(): string[] {
    return this.#visible().filter((path) => modelName.test(path));
  }

  /** The error if the wanted file is not there. */
  missing(wanted: string): GeodesicVoronoiError {
    return invalidFile(`there is no ${wanted} in ${listed(this.#visible()) || 'the file'}`);
  }

  async read(path: string, { signal }: TaskOptions): Promise<Uint8Array> {
    const file = this.#files.get(path)!;
    // Browsers decode no text in memory that threads share, and these might change it meanwhile.
    if (isA(file, 'Uint8Array'))
      return isA(file.buffer, 'ArrayBuffer') ? file : new Uint8Array(file);
    try {
      return new Uint8Array(await file.arrayBuffer());
    } catch (cause) {
      signal?.throwIfAborted();
      // A fault of an archive is reported by what reads it.
      if (cause instanceof GeodesicVoronoiError) throw cause;
      throw invalidFile(`${path || 'the file'} cannot be read: ${(cause as Error).message}`, {
        cause,
      });
    }
  }

  /**
   * The path of the file that a model means by a URI, if it is there. A model may not reach outside
   * its folder.
   */
  resource(model: string, uri: string): string | undefined {
    if (this.#files.has(uri)) return uri;
    const place = placeOf(model, uri);
    return place === undefined ? undefined : (this.#paths.get(place) ?? this.#fileNamed(place));
  }

  /** The paths of all but hidden files; a file alone may have any name. */
  #visible(): string[] {
    const all = [...this.#files.keys()];
    return all.length === 1 ? all : all.filter((path) => !isHidden(path));
  }

  /** Files that were chosen one by one have lost their folders: there, the name alone decides. */
  #fileNamed(place: string): string | undefined {
    const hasFolders = [...this.#paths.keys()].some((path) => path.includes('/'));
    return hasFolders ? undefined : this.#paths.get(place.slice(place.lastIndexOf('/') + 1));
  }
}

/**
 * The path of the file that a model means by a URI; nothing if that is outside the model's folder.
 */
export function placeOf(model: string, uri: string): string | undefined {
  const hasScheme = /^[a-z][a-z0-9+.-]*:/i.test(uri);
  return hasScheme ? undefined : normalised(`${folderOf(model)}${decoded(uri)}`);
}

/** Whether a path is one of the hidden files that systems leave in folders and archives. */
function isHidden(path: string): boolean {
  return path.split('/').some((name) => name === '__MACOSX' || /^\.[^.]/.test(name));
}

function folderOf(path: string): string {
  return path.slice(0, path.lastIndexOf('/') + 1);
}

/** Without `.` and `..`; nothing if it leads outside. */
function normalised(path: string): string | undefined {
  if (/^[\\/]/.test(path)) return undefined;
  const names: string[] = [];
  for (const name of path.split(/[\\/]/)) {
    if (name === '..' && names.pop() === undefined) return undefined;
    if (name !== '..' && name !== '.' && name !== '') names.push(name);
  }
  return names.join('/');
}

function decoded(uri: string): string {
  try {
    return decodeURIComponent(uri);
  } catch {
    return uri; // a bare % is part of the name then
  }
}

/** A few names, and how many more there are. */
function listed(paths: readonly string[]): string {
  const most = 5;
  const rest = paths.length - most;
  if (rest > 0) return `${paths.slice(0, most).join(', ')} and ${rest} more`;
  return paths.length < 2 ? paths.join() : `${paths.slice(0, -1).join(', ')} and ${paths.at(-1)}`;
}
