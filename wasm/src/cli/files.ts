// SPDX-License-Identifier: MIT
//
// Files that the command reads and writes.

import { randomUUID } from 'node:crypto';
import { createReadStream, rmSync } from 'node:fs';
import {
  access,
  chmod,
  constants,
  readdir,
  readFile,
  readlink,
  realpath,
  rename,
  rm,
  stat,
  writeFile,
} from 'node:fs/promises';
import { basename, dirname, join, resolve, sep } from 'node:path';
import type { Readable } from 'node:stream';
import { getSystemErrorMap } from 'node:util';
import { gltfResourceUris } from '../input/gltf_document.js';
import { placeOf } from '../input/model_files.js';
import type { ModelFile, ModelFiles } from '../api/options.js';
import { integer } from '../base/sentences.js';
import { standard, type Values } from './options.js';

/** A file cannot be read or written: exit status 1. */
export class FileError extends Error {}

export function readBytes(path: string): Promise<Uint8Array> {
  return path === standard ? readPipe(process.stdin, 'standard input') : readFileAt(path);
}

/** The files of a model: all of a folder, or a file with those of its own folder that it refers to. */
export async function readModel(named: string): Promise<{ files: ModelFiles; file?: string }> {
  const { path, file } = await partsOf(named);
  return { files: await modelFiles(path), file };
}

/** The path of a model, and the one that a # after it chooses of several in a folder or a zip. */
async function partsOf(named: string): Promise<{ path: string; file?: string }> {
  const mark = named.indexOf('#');
  if (mark < 0 || named === standard || (await exists(named))) return { path: named };
  return { path: named.slice(0, mark), file: named.slice(mark + 1) };
}

/** The real paths of the files that models were read from: no output replaces one. */
const modelPaths = new Set<string>();

async function modelFiles(path: string): Promise<ModelFiles> {
  if (path !== standard && (await kindOf(path)) === 'folder') return folderFiles(path);
  const bytes = await readBytes(path);
  if (path === standard) return { '': handedOver(bytes) };
  const files = new Map<string, ModelFile>([[basename(path), handedOver(bytes)]]);
  modelPaths.add(await targetOf(path));
  for (const uri of gltfResourceUris(bytes)) {
    const place = placeOf('', uri);
    const file = place === undefined ? undefined : await fileWithin(dirname(path), place);
    if (file) files.set(uri, file);
  }
  return Object.fromEntries(files);
}

/** The most files of a folder: models have a few, and a larger folder was named by mistake. */
const maxFiles = 10_000;

/** All files of a folder and those in it, by their paths; read when they are needed. */
async function folderFiles(folder: string): Promise<ModelFiles> {
  const files = new Map<string, ModelFile>();
  let count = 0;
  const visit = async (path: string): Promise<void> => {
    const entries = await readdir(join(folder, path), { withFileTypes: true });
    for (const entry of entries) {
      const place = path === '' ? entry.name : `${path}/${entry.name}`;
      if (++count > maxFiles) {
        throw new FileError(
          `${folder} has more than ${integer(maxFiles)} files in it: name the model itself`,
        );
      }
      // Links are not followed: they lead anywhere, also in circles.
      if (entry.isDirectory()) await visit(place);
      else if (entry.isFile()) files.set(place, fileAt(join(folder, place)));
    }
  };
  try {
    await visit('');
  } catch (error) {
    if (error instanceof FileError) throw error;
    throw new FileError(`${folder} cannot be read: ${reason(error)}`);
  }
  return Object.fromEntries(files);
}

/** A file that a model refers to, if it is there. No model may reach outside its folder. */
async function fileWithin(folder: string, place: string): Promise<ModelFile | undefined> {
  const path = join(folder, place);
  const target = await realpath(path).catch(() => undefined);
  if (target === undefined) return undefined;
  if (!target.startsWith(join(await realpath(folder), sep))) {
    throw new FileError(`${path} is a link to a place outside the model's folder`);
  }
  if ((await kindOf(target)) !== 'file') throw new FileError(`${path} is no file`);
  return fileAt(target);
}

function fileAt(path: string): ModelFile {
  return {
    async arrayBuffer() {
      try {
        modelPaths.add(await realpath(path));
        return bufferOf(await readFile(path));
      } catch (error) {
        throw new FileError(reason(error));
      }
    },
  };
}

/** Bytes that are given away once, so that nobody keeps them while a mesh is built. */
function handedOver(bytes: Uint8Array): ModelFile {
  let kept: Uint8Array | undefined = bytes;
  return {
    async arrayBuffer() {
      if (!kept) throw new FileError('it refers to itself');
      const given = bufferOf(kept);
      kept = undefined;
      return given;
    },
  };
}

/** Nothing is copied unless the bytes are a part of their buffer, as small ones are. */
function bufferOf({ buffer, byteOffset, byteLength }: Uint8Array): ArrayBuffer {
  const isAll = byteLength === buffer.byteLength;
  return (isAll ? buffer : buffer.slice(byteOffset, byteOffset + byteLength)) as ArrayBuffer;
}

/** The most bytes read from a pipe, which may never end. */
const maxPiped = 2 ** 30;

async function readPipe(pipe: Readable, name: string): Promise<Uint8Array> {
  const chunks: Buffer[] = [];
  let length = 0;
  for await (const chunk of pipe) {
    length += chunk.length;
    if (length > maxPiped) throw new FileError(`${name} has more than ${maxPiped / 2 ** 20} MB`);
    chunks.push(chunk);
  }
  return Buffer.concat(chunks);
}

async function readFileAt(path: string): Promise<Uint8Array> {
  const kind = await kindOf(path);
  // Some devices never end.
  if (kind === 'device') throw new FileError(`${path} is a device and no file`);
  try {
    return await (kind === 'pipe' ? readPipe(createReadStream(path), path) : readFile(path));
  } catch (error) {
    if (error instanceof FileError) throw error;
    throw new FileError(`${path} cannot be read: ${reason(error)}`);
  }
}

/** Where a result goes; opened before the work, so that a wrong path is known at once. */
export class Output {
  /** As it was given, for errors. */
  readonly #name: string;
  /** Where that leads by its links. */
  readonly #path: string;
  readonly #isQuiet: boolean;

  private constructor(name: string, path: string, isQuiet: boolean) {
    this.#name = name;
    this.#path = path;
    this.#isQuiet = isQuiet;
  }

  static async open({ output: name, quiet }: Pick<Values, 'output' | 'quiet'>): Promise<Output> {
    if (name === standard) return new Output(name, name, quiet);
    try {
      const path = await targetOf(name);
      const kind = await kindOf(path);
      if (kind === 'folder' || name.endsWith('/')) throw new FileError('it is a folder');
      await access(kind === 'none' ? dirname(path) : path, constants.W_OK);
      return new Output(name, path, quiet);
    } catch (error) {
      throw new FileError(`${name} cannot be written: ${reason(error)}`);
    }
  }

  /** A line about a result that went to a file. */
  summarise(line: string): void {
    if (this.#path !== standard && !this.#isQuiet) process.stderr.write(`${line}\n`);
  }

  /** Refuses to replace what a model was read from; known when the model is, before the work. */
  requireNoModel(): void {
    if (modelPaths.has(this.#path))
      throw new FileError(`${this.#name} cannot be written: the model is read from it`);
  }

  /**
   * Writes all or nothing: a file appears, or is replaced, when it is complete. Devices and pipes are
   * written to, as are files in folders that take no others.
   */
  async write(content: string | Uint8Array): Promise<void> {
    if (this.#path === standard) return writeStandardOutput(content);
    this.requireNoModel();
    try {
      const kind = await kindOf(this.#path);
      const isReplaced =
        (kind === 'file' || kind === 'none') && (await isWritable(dirname(this.#path)));
      await (isReplaced ? replaceFile : writeFile)(this.#path, content);
    } catch (error) {
      throw new FileError(`${this.#name} cannot be written: ${reason(error)}`);
    }
  }
}

async function kindOf(path: string): Promise<'file' | 'folder' | 'pipe' | 'device' | 'none'> {
  const entry = await stat(path).catch(() => undefined);
  if (!entry) return 'none';
  if (entry.isDirectory()) return 'folder';
  if (entry.isFIFO()) return 'pipe';
  return entry.isFile() ? 'file' : 'device';
}

export async function exists(path: string): Promise<boolean> {
  return (await kindOf(path)) !== 'none';
}

function isWritable(path: string): Promise<boolean> {
  return access(path, constants.W_OK).then(
    () => true,
    () => false,
  );
}

/** Where a path leads by its links, even if there is nothing yet. */
async function targetOf(path: string): Promise<string> {
  try {
    return await realpath(path);
  } catch (error) {
    if ((error as NodeJS.ErrnoException).code !== 'ENOENT') throw error;
    // A pipe in /dev/fd is there, and yet has no real path.
    const link = (await exists(path)) ? undefined : await readlink(path).catch(() => undefined);
    return link === undefined ? resolve(path) : targetOf(resolve(dirname(path), link));
  }
}

async function replaceFile(path: string, content: string | Uint8Array): Promise<void> {
  const draft = join(dirname(path), `.${randomUUID()}.tmp`);
  /** Ends as a signal does by default, and leaves nothing behind. */
  const end = (signal: NodeJS.Signals) => {
    rmSync(draft, { force: true });
    for (const name of endSignals) process.off(name, end);
    process.kill(process.pid, signal);
  };
  for (const name of endSignals) process.on(name, end);
  try {
    await writeFile(draft, content);
    const replaced = await stat(path).catch(() => undefined);
    if (replaced) await chmod(draft, replaced.mode);
    await rename(draft, path);
  } catch (error) {
    await rm(draft, { force: true });
    throw error;
  } finally {
    for (const name of endSignals) process.off(name, end);
  }
}

/** The signals by which other programs ask one to end. */
const endSignals = ['SIGINT', 'SIGTERM', 'SIGHUP'] as const;

export function writeStandardOutput(content: string | Uint8Array): Promise<void> {
  return new Promise((done, fail) => {
    process.stdout.write(content, (error) => {
      // The reader of a pipe, for example head, may close it early.
      if (error && (error as NodeJS.ErrnoException).code !== 'EPIPE')
        fail(new FileError(`standard output cannot be written: ${reason(error)}`));
      else done();
    });
  });
}

/** What is clearer than the system's own words, such as 'illegal operation on a directory'. */
const reasons: Record<string, string> = {
  ENOENT: 'there is no such file or folder',
  EACCES: 'permission is denied',
  ELOOP: 'its links lead in circles',
  EISDIR: 'it is a folder',
  ENOTDIR: 'part of its path is no folder',
  ENOSPC: 'the disk is full',
  EFBIG: 'no file may be as large here',
};

function reason(error: unknown): string {
  const { code = '', errno = 0, message } = error as NodeJS.ErrnoException;
  return reasons[code] ?? getSystemErrorMap().get(errno)?.[1] ?? message;
}
