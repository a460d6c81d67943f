// SPDX-License-Identifier: MIT
//
// Buffer views as EXT_meshopt_compression and KHR_meshopt_compression have them, decoded by the
// meshoptimizer library. It trusts the numbers that it is given: they are checked against the
// specification here.

import { MeshoptDecoder } from 'meshoptimizer/decoder';
import { counted } from '../base/sentences.js';
import { type GltfData, whole } from './gltf_data.js';
import { damagedData, gltfFault, type JsonObject } from './gltf_document.js';

const strides: Record<string, (stride: number) => boolean> = {
  ATTRIBUTES: (stride) => stride % 4 === 0 && stride >= 4 && stride <= 256,
  TRIANGLES: (stride) => stride === 2 || stride === 4,
  INDICES: (stride) => stride === 2 || stride === 4,
};
/** Each filter requires certain strides, too. */
const filters: Record<string, (stride: number) => boolean> = {
  NONE: () => true,
  OCTAHEDRAL: (stride) => stride === 4 || stride === 8,
  QUATERNION: (stride) => stride === 8,
  EXPONENTIAL: (stride) => stride % 4 === 0,
  COLOR: (stride) => stride === 4 || stride === 8,
};

/**
 * The largest ratio of a content to its packed form: a control byte stands for at most four columns
 * of 256 rows.
 */
const maxRatio = 1024;

/** Gives the content of a buffer view by its extension; `where` names it in errors. */
export type MeshoptDecoding = (
  compression: JsonObject,
  data: GltfData,
  where: string,
) => Uint8Array<ArrayBuffer>;

export async function openMeshopt(): Promise<MeshoptDecoding> {
  await MeshoptDecoder.ready;
  return decoded;
}

function decoded(compression: JsonObject, data: GltfData, where: string): Uint8Array<ArrayBuffer> {
  const packed = data.bytesOf(compression, where);
  const count = whole(compression.count, `the count of ${where}`);
  const stride = whole(compression.byteStride, `the byteStride of ${where}`);
  const { mode, filter = 'NONE' } = compression;
  requireOneOf('mode', mode, strides, where);
  requireOneOf('filter', filter, filters, where);
  const fits = strides[mode](stride) && filters[filter](stride);
  if (!fits || (filter !== 'NONE' && mode !== 'ATTRIBUTES')) {
    throw gltfFault(
      `${where} is compressed by ${mode} and ${filter}: that has no byteStride ${stride}`,
    );
  }
  if (mode === 'TRIANGLES' && count % 3 !== 0) {
    throw gltfFault(
      `${where} has ${counted(count, 'corner')} of triangles, which is no multiple of three`,
    );
  }
  data.reserve(count * stride);
  // The codec keeps at least one byte for so many, so a few bytes cannot ask for millions.
  if (count * stride > maxRatio * packed.length) {
    throw damagedData(where);
  }
  const content = new Uint8Array(count * stride);
  try {
    MeshoptDecoder.decodeGltfBuffer(content, count, stride, packed, mode, filter);
  } catch (cause) {
    throw damagedData(where, cause);
  }
  return content;
}

function requireOneOf<Name extends string>(
  what: string,
  name: unknown,
  known: Record<Name, unknown>,
  where: string,
): asserts name is Name {
  if (typeof name === 'string' && Object.hasOwn(known, name)) return;
  throw gltfFault(`the ${what} of ${where} is ${JSON.stringify(name)}, which is not known`);
}
