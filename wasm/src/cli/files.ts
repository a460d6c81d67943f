// SPDX-License-Identifier: MIT
import { randomUUID } from 'node:crypto';
import {
  access,
  constants,
  readFile,
  realpath,
  rename,
  rm,
  stat,
  writeFile,
} from 'node:fs/promises';
import { dirname, isAbsolute, join, relative, resolve } from 'node:path';
import { gltfResourceUris } from '../gltf.js';
import type { GltfResources, SurfacePointsInput } from '../types.js';
import { standard } from './options.js';

/** A file cannot be read or written: exit status 1. */
export class FileError extends Error {}

function readBytes(path: string): Promise<Uint8Array> {
  return path === standard ? readStandardInput() : read(path, path);
}

/** Reads a glTF file with the files that it names, out of its own folder. */
export async function readModel(
  path: string,
): Promise<{ bytes: Uint8Array; resources: GltfResources }> {
  const bytes = await readBytes(path);
  const resources: GltfResources = {};
  for (const uri of gltfResourceUris(bytes)) {
    if (path === standard) {
      throw new FileError(`the model needs ${uri}, but one from standard input has no folder`);
    }
    resources[uri] = await read(resourcePath(path, uri), `${uri}, which ${path} needs,`);
  }
  return { bytes, resources };
}

async function readJson(path: string): Promise<unknown> {
  const text = new TextDecoder().decode(await readBytes(path));
  try {
    return JSON.parse(text);
  } catch (error) {
    throw new FileError(`${nameOf(path)} is not JSON: ${(error as Error).message}`);
  }
}

/** Reads a list of numbers. */
export async function readNumbers(path: string): Promise<number[]> {
  const json = await readJson(path);
  if (Array.isArray(json) && json.every((item) => typeof item === 'number')) return json;
  throw new FileError(`${nameOf(path)} holds no list of numbers`);
}

/** Reads a list of sites or points; also the sites of a diagram that this command wrote. */
export async function readPoints(path: string): Promise<SurfacePointsInput> {
  const json = await readJson(path);
  const list = has(json, 'sites') ? json.sites : json;
  if (has(list, 'vertex') || (has(list, 'face') && has(list, 'bary')))
    return list as SurfacePointsInput;
  throw new FileError(`${nameOf(path)} holds no points: {"face", "bary"} or {"vertex"}`);
}

function has<Key extends string>(value: unknown, key: Key): value is Record<Key, unknown> {
  return typeof value === 'object' && value !== null && key in value;
}

function nameOf(path: string): string {
  return path === standard ? 'standard input' : path;
}

async function readStandardInput(): Promise<Uint8Array> {
  const chunks: Buffer[] = [];
  for await (const chunk of process.stdin) chunks.push(chunk);
  return Buffer.concat(chunks);
}

async function read(path: string, name: string): Promise<Uint8Array> {
  try {
    return await readFile(path);
  } catch (error) {
    throw new FileError(`${name} cannot be read: ${reason(error)}`);
  }
}

/** Where a URI of a model leads. A model comes from anywhere and may not reach outside its folder. */
function resourcePath(model: string, uri: string): string {
  const folder = dirname(resolve(model));
  const path = resolve(folder, decodeUri(uri));
  const inside = relative(folder, path);
  if (/^[a-z][a-z0-9+.-]*:/i.test(uri) || isAbsolute(inside) || inside.split(/[\\/]/)[0] === '..') {
    throw new FileError(`${model} needs ${uri}, which is outside its folder`);
  }
  return path;
}

function decodeUri(uri: string): string {
  try {
    return decodeURIComponent(uri);
  } catch {
    return uri; // a bare % is part of the name then
  }
}

/** Where a result goes; opened before the work, so that a wrong path is known at once. */
export class Output {
  readonly #path: string;

  private constructor(path: string) {
    this.#path = path;
  }

  static async open(path: string): Promise<Output> {
    if (path === standard) return new Output(path);
    try {
      const target = await realpath(path).catch(() => resolve(path));
      if ((await kindOf(target)) === 'folder') throw new FileError('it is a folder');
      await access((await kindOf(target)) === 'special' ? target : dirname(target), constants.W_OK);
      return new Output(target);
    } catch (error) {
      throw new FileError(`${path} cannot be written: ${reason(error)}`);
    }
  }

  get isFile(): boolean {
    return this.#path !== standard;
  }

  /** All or nothing: a file appears, or is replaced, when it is complete. */
  async write(content: string | Uint8Array): Promise<void> {
    if (!this.isFile) return writeStandardOutput(content);
    try {
      const isSpecial = (await kindOf(this.#path)) === 'special';
      await (isSpecial ? writeFile : replaceFile)(this.#path, content);
    } catch (error) {
      throw new FileError(`${this.#path} cannot be written: ${reason(error)}`);
    }
  }
}

/** A device or a pipe is special: written to, not replaced. */
async function kindOf(path: string): Promise<'file' | 'folder' | 'special'> {
  const entry = await stat(path).catch(() => undefined);
  if (entry?.isDirectory()) return 'folder';
  return entry && !entry.isFile() ? 'special' : 'file';
}

async function replaceFile(path: string, content: string | Uint8Array): Promise<void> {
  const draft = join(dirname(path), `.${randomUUID()}.tmp`);
  try {
    await writeFile(draft, content);
    await rename(draft, path);
  } catch (error) {
    await rm(draft, { force: true });
    throw error;
  }
}

function writeStandardOutput(content: string | Uint8Array): Promise<void> {
  return new Promise((done, fail) => {
    process.stdout.write(content, (error) => {
      // Who reads, for example head, may have enough.
      if (error && (error as NodeJS.ErrnoException).code !== 'EPIPE') fail(error);
      else done();
    });
  });
}

const reasons: Record<string, string> = {
  ENOENT: 'there is no such file or folder',
  EACCES: 'permission is denied',
  EISDIR: 'it is a folder',
  ENOTDIR: 'part of its path is no folder',
  ENOSPC: 'the disk is full',
};

function reason(error: unknown): string {
  const { code, message } = error as NodeJS.ErrnoException;
  return reasons[code ?? ''] ?? message;
}
