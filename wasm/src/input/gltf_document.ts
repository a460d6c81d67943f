// SPDX-License-Identifier: MIT
//
// A glTF before it is read: the files that it refers to, and whether anything in it is compressed.
// Faults are left to the reader in C++, which gets the glTF as it is.

import { isObject, requireBytes } from '../base/checks.js';
import { GeodesicVoronoiError } from '../api/errors.js';
import { parseJsonMembers } from './json_members.js';

/** A value of JSON about which nothing is known yet. */
export type JsonObject = Record<string, unknown>;

/** Files that a glTF names, by the URIs that it uses. */
export type Resources = ReadonlyMap<string, Uint8Array>;

export interface GltfDocument {
  json: JsonObject;
  /** The binary chunk of a GLB. */
  binary?: Uint8Array;
}

/** A glTF with the files that it names. */
export interface GltfFile {
  bytes: Uint8Array;
  resources: Resources;
}

/** Both have the same form. */
export const meshoptExtensions = ['EXT_meshopt_compression', 'KHR_meshopt_compression'];
export const dracoExtension = 'KHR_draco_mesh_compression';

/**
 * The files that a glTF's triangles need besides the glTF itself: the URIs of its buffers, as it
 * writes them, each once. Empty if the bytes are no glTF; `mesh()` then says what is wrong.
 */
export function gltfResourceUris(bytes: Uint8Array): string[] {
  requireBytes('bytes', bytes);
  return resourceUris(parseGltfHead(bytes) ?? {});
}

export function resourceUris({ buffers }: JsonObject): string[] {
  const uris = objectsOf(buffers)
    .filter((buffer) => !isFallback(buffer))
    .map(({ uri }) => uri)
    .filter((uri) => typeof uri === 'string')
    .filter((uri) => !/^data:/i.test(uri));
  return [...new Set(uris)];
}

/** Whether a buffer is there only for readers that cannot decompress. */
function isFallback(buffer: JsonObject): boolean {
  return meshoptExtensions.some((name) => extensionOf(buffer, name)?.fallback === true);
}

export function isCompressed(json: JsonObject): boolean {
  const names = [json.extensionsUsed, json.extensionsRequired].flat();
  return [dracoExtension, ...meshoptExtensions].some((name) => names.includes(name));
}

export function extensionOf({ extensions }: JsonObject, name: string): JsonObject | undefined {
  return isObject(extensions) && isObject(extensions[name]) ? extensions[name] : undefined;
}

/** The objects of a list; `{}` replaces entries that are no objects, so that indices stay. */
export function objectsOf(list: unknown): JsonObject[] {
  return Array.isArray(list) ? list.map((entry) => (isObject(entry) ? entry : {})) : [];
}

/** The members that say which files a glTF needs and whether it is compressed. */
const headMembers = ['buffers', 'extensionsUsed', 'extensionsRequired'];
/** The members that its triangles come from. */
const triangleMembers = ['asset', 'scene', 'scenes', 'nodes', 'meshes', 'accessors', 'bufferViews'];

/** The head of a glTF; undefined if it is not JSON. */
export function parseGltfHead(bytes: Uint8Array): JsonObject | undefined {
  try {
    return parseJsonMembers(chunksOf(bytes).text, headMembers);
  } catch {
    return undefined;
  }
}

/** Everything that a glTF's triangles need. */
export function parseGltf(bytes: Uint8Array): GltfDocument {
  const { text, binary } = chunksOf(bytes);
  try {
    return { json: parseJsonMembers(text, [...headMembers, ...triangleMembers]), binary };
  } catch (cause) {
    throw gltfFault(`what is compressed in it cannot be read: ${(cause as Error).message}`, cause);
  }
}

/** The JSON and the binary chunk of a GLB; of anything else, all is JSON. */
function chunksOf(bytes: Uint8Array): { text: Uint8Array; binary?: Uint8Array } {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const glbMagic = 0x46546c67;
  const headerBytes = 20;
  if (bytes.length < headerBytes || view.getUint32(0, true) !== glbMagic) return { text: bytes };
  const end = headerBytes + view.getUint32(12, true);
  const text = bytes.subarray(headerBytes, end);
  if (end + 8 > bytes.length) return { text };
  return { text, binary: bytes.subarray(end + 8, end + 8 + view.getUint32(end, true)) };
}

export function gltfFault(message: string, cause?: unknown): GeodesicVoronoiError {
  return new GeodesicVoronoiError('invalid-gltf', message, { cause });
}

export function damagedData(where: string, cause?: unknown): GeodesicVoronoiError {
  return gltfFault(`${where} cannot be decompressed: its data are damaged`, cause);
}
