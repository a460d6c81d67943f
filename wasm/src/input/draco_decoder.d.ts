// SPDX-License-Identifier: MIT
//
// What is used of Draco's decoder, the package draco3d, which the build copies to dist/input.

export type Pointer = number;

interface Status {
  ok(): boolean;
  error_msg(): string;
}

interface Mesh {
  readonly ptr: Pointer;
  num_faces(): number;
  num_points(): number;
}

interface Attribute {
  readonly ptr: Pointer;
  num_components(): number;
}

interface Decoder {
  DecodeArrayToMesh(bytes: Int8Array, length: number, mesh: Mesh): Status;
  GetTrianglesUInt32Array(mesh: Mesh, byteLength: number, target: Pointer): boolean;
  GetAttributeByUniqueId(mesh: Mesh, id: number): Attribute;
  GetAttributeDataArrayForAllPoints(
    mesh: Mesh,
    attribute: Attribute,
    type: number,
    byteLength: number,
    target: Pointer,
  ): boolean;
}

type NumberType = 'INT8' | 'UINT8' | 'INT16' | 'UINT16' | 'UINT32' | 'FLOAT32';

export type DracoModule = { readonly [Name in `DT_${NumberType}`]: number } & {
  Decoder: new () => Decoder;
  Mesh: new () => Mesh;
  readonly HEAPU8: Uint8Array;
  destroy(object: Decoder | Mesh): void;
  _malloc(bytes: number): Pointer;
  _free(pointer: Pointer): void;
};

export default function createDracoModule(options: {
  instantiateWasm(
    imports: WebAssembly.Imports,
    done: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void,
  ): object;
  print(text: string): void;
  printErr(text: string): void;
}): Promise<DracoModule>;
