// SPDX-License-Identifier: MIT
//
// Primitives as KHR_draco_mesh_compression has them, decoded by Google's library.

import { awake } from '../base/compile.js';
import createDracoModule, { type DracoModule, type Pointer } from './draco_decoder.js';
import { damagedData, gltfFault, type JsonObject } from './gltf_document.js';

/** A mesh that has been decompressed, to be freed before the next one. */
export interface DracoMesh {
  /** Three per triangle, of 32 bits. */
  indices(): Uint8Array;
  /** The attribute of an id, with numbers of the type that its accessor has. */
  attribute(id: number, accessor: JsonObject, what: string): DracoAttribute;
  free(): void;
}

/** Decompresses a mesh; `where` names it in errors, after which the decoder is of no use any more. */
export type DracoDecoding = (packed: Uint8Array, where: string) => DracoMesh;

interface DracoAttribute {
  content: Uint8Array;
  count: number;
}

/** The library's names of glTF's types. */
const types = {
  5120: { name: 'DT_INT8', bytes: 1 },
  5121: { name: 'DT_UINT8', bytes: 1 },
  5122: { name: 'DT_INT16', bytes: 2 },
  5123: { name: 'DT_UINT16', bytes: 2 },
  5125: { name: 'DT_UINT32', bytes: 4 },
  5126: { name: 'DT_FLOAT32', bytes: 4 },
} as const;
const sizes = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };

/** A decoder for the meshes of one file, so that bad data cannot spoil another one. */
export async function openDraco(compiled: WebAssembly.Module): Promise<DracoDecoding> {
  const draco = await instantiated(compiled);
  return (packed, where) => decoded(draco, packed, where);
}

function decoded(draco: DracoModule, packed: Uint8Array, where: string): DracoMesh {
  /** Runs work that may trap on malformed data. */
  const guarded = <Result>(work: () => Result): Result => {
    try {
      return work();
    } catch (cause) {
      throw damagedData(where, cause);
    }
  };

  const { decoder, mesh } = guarded(() => {
    const decoder = new draco.Decoder();
    const mesh = new draco.Mesh();
    const status = decoder.DecodeArrayToMesh(new Int8Array(packed), packed.length, mesh);
    if (!status.ok() || mesh.ptr === 0) throw new RangeError(status.error_msg());
    return { decoder, mesh };
  });

  return {
    indices: () =>
      guarded(() =>
        copied(draco, 12 * mesh.num_faces(), (pointer, bytes) =>
          decoder.GetTrianglesUInt32Array(mesh, bytes, pointer),
        ),
      ),
    attribute(id, { componentType, type }, what) {
      const number = types[componentType as keyof typeof types];
      const size = sizes[type as keyof typeof sizes];
      if (!number || !size) {
        throw gltfFault(
          `${what} has the type ${type} and componentType ${componentType}, which no compressed attribute can have`,
        );
      }
      const count = mesh.num_points();
      const content = guarded(() => {
        const attribute = decoder.GetAttributeByUniqueId(mesh, id);
        if (attribute.ptr === 0 || attribute.num_components() !== size) throw new RangeError(what);
        return copied(draco, count * size * number.bytes, (pointer, bytes) =>
          decoder.GetAttributeDataArrayForAllPoints(
            mesh,
            attribute,
            draco[number.name],
            bytes,
            pointer,
          ),
        );
      });
      return { content, count };
    },
    free: () => {
      draco.destroy(mesh);
      draco.destroy(decoder);
    },
  };
}

function instantiated(compiled: WebAssembly.Module): Promise<DracoModule> {
  return new Promise((resolve, reject) => {
    createDracoModule({
      instantiateWasm(imports, done) {
        const instance = awake(() => WebAssembly.instantiate(compiled, imports));
        instance.then((started) => done(started, compiled)).catch(reject);
        return {};
      },
      print: () => {},
      printErr: () => {},
    }).then(resolve, reject);
  });
}

/** A copy of the bytes that a function of the library writes to a buffer. */
function copied(
  draco: DracoModule,
  bytes: number,
  write: (pointer: Pointer, bytes: number) => boolean,
): Uint8Array {
  const pointer = draco._malloc(bytes);
  if (pointer === 0 || !write(pointer, bytes)) throw new RangeError('nothing was written');
  const content = draco.HEAPU8.slice(pointer, pointer + bytes);
  draco._free(pointer);
  return content;
}
