// SPDX-License-Identifier: MIT
//
// Writing binary glTF.

type Elements = Float32Array | Uint32Array | Uint8Array;

const componentTypes = new Map<unknown, number>([
  [Float32Array, 5126],
  [Uint32Array, 5125],
  [Uint8Array, 5121],
]);

/** Numbers per element. */
const sizes = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };

/** A binary glTF in the making: accessors first, then the objects that name them. */
export class GlbBuilder {
  readonly #accessors: object[] = [];
  readonly #bufferViews: object[] = [];
  readonly #data: Elements[] = [];
  #byteLength = 0;

  /** Adds a vertex attribute. Bytes stand for 0 … 1; elements take a multiple of four bytes. */
  attribute(data: Elements, type: keyof typeof sizes): number {
    const arrayBuffer = 34962;
    return this.#accessor(data, type, arrayBuffer);
  }

  indices(data: Uint32Array): number {
    const elementArrayBuffer = 34963;
    return this.#accessor(data, 'SCALAR', elementArrayBuffer);
  }

  #accessor(data: Elements, type: keyof typeof sizes, target: number): number {
    this.#bufferViews.push({
      buffer: 0,
      byteOffset: this.#byteLength,
      byteLength: data.byteLength,
      target,
    });
    this.#accessors.push({
      bufferView: this.#bufferViews.length - 1,
      componentType: componentTypes.get(data.constructor),
      count: data.length / sizes[type],
      type,
      ...(data instanceof Uint8Array && { normalized: true }),
      ...(type === 'VEC3' && extremes(data)),
    });
    this.#data.push(data);
    this.#byteLength += data.byteLength;
    return this.#accessors.length - 1;
  }

  /** The file: `objects` with an `asset` and what the accessors need. */
  finish(objects: object): Uint8Array<ArrayBuffer> {
    const json = {
      asset: { version: '2.0', generator: 'geodesic-voronoi' },
      ...objects,
      // glTF has no empty lists.
      ...(this.#data.length > 0 && {
        accessors: this.#accessors,
        bufferViews: this.#bufferViews,
        buffers: [{ byteLength: this.#byteLength }],
      }),
    };
    return glb(json, this.#data, this.#byteLength);
  }
}

/** The least and the greatest of each of three coordinates. */
function extremes(data: Elements): { min: number[]; max: number[] } {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < data.length; ++i) {
    const k = i % 3;
    if (data[i] < min[k]) min[k] = data[i];
    if (data[i] > max[k]) max[k] = data[i];
  }
  return { min, max };
}

/** A JSON chunk and, if there is data, a BIN chunk. */
function glb(json: object, data: Elements[], binLength: number): Uint8Array<ArrayBuffer> {
  const text = new TextEncoder().encode(JSON.stringify(json));
  const jsonLength = 4 * Math.ceil(text.length / 4);
  const length = 12 + 8 + jsonLength + (binLength > 0 ? 8 + binLength : 0);
  const bytes = new Uint8Array(length);
  const view = new DataView(bytes.buffer);
  const writeWords = (offset: number, ...words: number[]) =>
    words.forEach((word, i) => view.setUint32(offset + 4 * i, word, true));

  writeWords(0, 0x46546c67 /* glTF */, 2, length, jsonLength, 0x4e4f534a /* JSON */);
  bytes.fill(0x20, 20, 20 + jsonLength);
  bytes.set(text, 20);
  if (binLength === 0) return bytes;
  let offset = 20 + jsonLength;
  writeWords(offset, binLength, 0x004e4942 /* BIN */);
  offset += 8;
  for (const array of data) {
    bytes.set(new Uint8Array(array.buffer, array.byteOffset, array.byteLength), offset);
    offset += array.byteLength;
  }
  return bytes;
}
