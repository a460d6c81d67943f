// SPDX-License-Identifier: MIT
//
// From the files of a model to its triangles. What a format needs is loaded with its first file.

import { invalidFile } from '../api/errors.js';
import { readGltf } from './gltf_reader.js';
import type { MeshOrigin, MeshPart } from '../api/results.js';
import { imported } from '../base/compile.js';
import { inSlices } from '../base/slices.js';
import type { Triangles } from '../base/triangles.js';
import type { CompiledModule, GltfLimits, ModelFiles, TaskOptions } from '../api/options.js';
import { decompressed } from './gltf_decompression.js';
import {
  type GltfFile,
  isCompressed,
  parseGltf,
  parseGltfHead,
  resourceUris,
} from './gltf_document.js';
import { toSizeLimits } from './limits.js';
import { FileSet } from './model_files.js';
import { type FileFormat, formatOf } from './model_format.js';

/** WebAssembly modules, compiled when they are first needed. */
export interface InputModules {
  gltf(): Promise<CompiledModule>;
  draco(): Promise<CompiledModule>;
}

/** What a mesh is read from. */
export interface FileInput {
  files: ModelFiles;
  limits: GltfLimits;
  /** The path of the model to read, of several. */
  file?: string;
}

/** What is read from the files of a model. */
export interface Model {
  triangles: Triangles;
  origin: MeshOrigin;
  parts: MeshPart[];
  notes: string[];
}

/** The model among files. */
export interface FoundModel {
  /** Its path. */
  file: string;
  format: Exclude<FileFormat, 'zip'>;
  bytes: Uint8Array;
  /** The content of the file that a URI of the model refers to, if it is there. */
  resource(uri: string): Promise<Uint8Array | undefined>;
}

/** The one model among files, or the wanted one; of a .zip, the one in it. */
export async function modelIn(
  files: ModelFiles,
  wanted: string | undefined,
  task: TaskOptions,
): Promise<FoundModel> {
  const found = await modelAmong(files, wanted, task);
  const isArchive = found.format === 'zip';
  const model = isArchive
    ? await modelAmong(
        (await imported(import('./zip.js'))).zipFiles(found.bytes, task),
        wanted,
        task,
      )
    : found;
  task.signal?.throwIfAborted();
  const { format } = model;
  // There are zips that hold themselves.
  if (format === 'zip') {
    throw invalidFile(`${model.file} in the zip is a zip itself: unpack it first`);
  }
  return { ...model, format };
}

/** The paths of all models among files; of a .zip alone, those in it. */
export async function modelsIn(files: ModelFiles, task: TaskOptions): Promise<string[]> {
  task.signal?.throwIfAborted();
  const models = new FileSet(files).models();
  if (models.length > 0) return models;
  const { file, format, bytes } = await modelAmong(files, undefined, task);
  if (format !== 'zip') return [file];
  return new FileSet((await imported(import('./zip.js'))).zipFiles(bytes, task)).models();
}

async function modelAmong(
  files: ModelFiles,
  wanted: string | undefined,
  task: TaskOptions,
): Promise<Omit<FoundModel, 'format'> & { format: FileFormat }> {
  const set = new FileSet(files);
  const file = set.model(wanted);
  const bytes = await set.read(file, task);
  const format = formatOf(bytes, file);
  if (format !== 'zip' && wanted !== undefined && file !== wanted) throw set.missing(wanted);
  // Each is read once, and unpacked once: a glTF may have thousands of buffers in one file.
  const contents = new Map<string, Promise<Uint8Array>>();
  const resource = async (uri: string) => {
    const path = set.resource(file, uri);
    if (path === undefined) return undefined;
    const content = contents.get(path) ?? set.read(path, task);
    contents.set(path, content);
    return content;
  };
  return { file, format, bytes, resource };
}

export async function readModel(
  { files, limits, file: wanted }: FileInput,
  modules: InputModules,
  task: TaskOptions,
): Promise<Model> {
  const { file, format, bytes, resource } = await modelIn(files, wanted, task);
  if (format === 'glTF') {
    const readable = await readableGltf(bytes, resource, modules.draco, task);
    const module = await modules.gltf();
    const { parts, notes, ...triangles } = await readGltf(module, readable, limits, task);
    return { triangles, parts, notes, origin: { file, format } };
  }
  const read = await imported(readers[format]());
  const { notes, ...triangles } = await inSlices(read(bytes, toSizeLimits(limits)), task);
  // An empty array for each: a worker hands over every buffer once.
  const none = {
    normals: new Float64Array(),
    uvs: new Float64Array(),
    density: new Float64Array(),
  };
  const isStl = format === 'binary STL' || format === 'text STL';
  const origin = { file, format: isStl ? 'STL' : format } as const;
  return { triangles: { ...none, ...triangles }, parts: [], notes, origin };
}

/** The readers of formats without parts. */
const readers = {
  OBJ: async () => (await import('./obj_reader.js')).readObj,
  OFF: async () => (await import('./off_reader.js')).readOff,
  PLY: async () => (await import('./ply_reader.js')).readPly,
  'binary STL': async () => (await import('./stl_reader.js')).readBinaryStl,
  'text STL': async () => (await import('./stl_reader.js')).readTextStl,
};

/** The glTF with those of its files that are there, and nothing in it compressed. */
async function readableGltf(
  bytes: Uint8Array,
  resource: (uri: string) => Promise<Uint8Array | undefined>,
  dracoModule: () => Promise<CompiledModule>,
  task: TaskOptions,
): Promise<GltfFile> {
  const head = parseGltfHead(bytes) ?? {};
  const resources = new Map<string, Uint8Array>();
  for (const uri of resourceUris(head)) {
    const content = await resource(uri);
    if (content) resources.set(uri, content);
  }
  return isCompressed(head)
    ? decompressed(parseGltf(bytes), resources, dracoModule, task)
    : { bytes, resources };
}
