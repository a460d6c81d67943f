// SPDX-License-Identifier: MIT
//
// Writing binary glTF.

import { toFloat32 } from './file_options.js';

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
  readonly #places: Float64Array;
  readonly #scale: number;
  readonly #origin: number[];
  readonly #accessors: object[] = [];
  readonly #bufferViews: object[] = [];
  readonly #data: Elements[] = [];
  #byteLength = 0;

  /** A file of some places, x, y, z each, of which all lengths are multiplied with `scale`. */
  constructor(places: Float64Array, scale: number) {
    this.#places = places;
    this.#scale = scale;
    this.#origin = originOf(places);
  }

  /** Adds the positions of some of the places; one that is not finite is at the origin of all. */
  positions(points: ArrayLike<number>): number {
    const positions = new Float32Array(3 * points.length);
    for (let i = 0; i < positions.length; ++i) {
      const x = this.#places[3 * points[Math.floor(i / 3)] + (i % 3)];
      if (Number.isFinite(x))
        positions[i] = toFloat32(this.#scale * (x - this.#origin[i % 3]), this.#scale, 'a GLB');
    }
    return this.attribute(positions, 'VEC3');
  }

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
      ...(type === 'VEC3' && data instanceof Float32Array && extremes(data)),
    });
    this.#data.push(data);
    this.#byteLength += data.byteLength;
    return this.#accessors.length - 1;
  }

  /** The file: a scene of all `nodes`, with the other objects and what the accessors need. */
  finish({ nodes, ...objects }: { nodes: object[] } & Record<string, unknown>): GlbBytes {
    const translation = this.#origin.map((x) => this.#scale * x);
    const isMoved = translation.some((x) => x !== 0);
    const json = {
      ...head,
      ...objects,
      scenes: [{ nodes: nodes.map((_, i) => i) }],
      nodes: nodes.map((node) => ({ ...node, ...(isMoved && { translation }) })),
      accessors: this.#accessors,
      bufferViews: this.#bufferViews,
      buffers: [{ byteLength: this.#byteLength }],
    };
    return glb(json, this.#data, this.#byteLength);
  }
}

type GlbBytes = Uint8Array<ArrayBuffer>;

const head = { asset: { version: '2.0', generator: 'geodesic-voronoi' }, scene: 0 };

/** A file of nothing: glTF has neither empty primitives nor empty lists. */
export function emptyGlb(): GlbBytes {
  return glb({ ...head, scenes: [{}] }, [], 0);
}

/**
 * Where the coordinates of a file count from: the centre of the places if it is farther from zero
 * than they are from each other. The numbers of a GLB, of 32 bits, would not tell them apart there.
 */
function originOf(places: Float64Array): number[] {
  const { min, max } = extremes(places);
  const centre = min.map((x, k) => x / 2 + max[k] / 2);
  const size = Math.hypot(...min.map((x, k) => max[k] - x));
  return Math.hypot(...centre) > size ? centre : [0, 0, 0];
}

/** The least and the greatest of each of three coordinates, of those that are finite. */
function extremes(data: Float32Array | Float64Array): { min: number[]; max: number[] } {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < data.length; ++i) {
    const k = i % 3;
    if (!Number.isFinite(data[i])) continue;
    if (data[i] < min[k]) min[k] = data[i];
    if (data[i] > max[k]) max[k] = data[i];
  }
  return { min, max };
}

/** A JSON chunk and, if there is data, a BIN chunk. */
function glb(json: object, data: Elements[], binLength: number): GlbBytes {
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
