// SPDX-License-Identifier: MIT
//
// The lists and buffers of a glTF that is being decompressed: finds, checks and adds bytes.

import { isObject } from '../base/checks.js';
import { copyTo } from '../base/growing_array.js';
import { counted, integer } from '../base/sentences.js';
import type { SlicedWork } from '../base/slices.js';
import {
  gltfFault,
  type GltfDocument,
  type JsonObject,
  objectsOf,
  type Resources,
} from './gltf_document.js';

/** The most bytes that may be decompressed in all: a file of a few bytes can ask for any amount. */
const maxDecompressedBytes = 2 ** 30;
/** Contents begin at multiples of this in the new buffer, the alignment of the largest numbers. */
const alignment = 8;

const listNames = ['accessors', 'buffers', 'bufferViews'] as const;
type ListName = (typeof listNames)[number];

export class GltfData {
  readonly #document: GltfDocument;
  readonly #resources: Resources;
  /** The contents of data URIs that were needed, by buffer: many views may be of one. */
  readonly decoded = new Map<number, Uint8Array>();
  readonly #added: Uint8Array[] = [];
  #addedBytes = 0;

  constructor(document: GltfDocument, resources: Resources) {
    this.#document = document;
    this.#resources = resources;
    // Entries that are no objects count as empty ones.
    for (const name of listNames) document.json[name] = objectsOf(document.json[name]);
  }

  list(name: ListName): JsonObject[] {
    return this.#document.json[name] as JsonObject[];
  }

  /** An entry of a list; `what` names who wants it. */
  entry(name: ListName, index: unknown, what: string): JsonObject {
    const list = this.list(name);
    const i = whole(index, what);
    if (i < list.length) return list[i];
    throw gltfFault(`${what} is number ${i} of ${list.length} ${name}`);
  }

  /** The bytes of a buffer view, or of an extension of the same form. */
  bytesOf({ buffer, byteOffset = 0, byteLength }: JsonObject, what: string): Uint8Array {
    const content = this.#bufferBytes(buffer, what);
    const start = whole(byteOffset, `the byteOffset of ${what}`);
    const length = whole(byteLength, `the byteLength of ${what}`);
    if (start + length <= content.length) return content.subarray(start, start + length);
    throw gltfFault(
      `${what} should have ${counted(length, 'byte')} from byte ${start} on, but its buffer has ${integer(content.length)}`,
    );
  }

  /** Adds a content to the new buffer; returns its place there. */
  add(content: Uint8Array): { buffer: number; byteOffset: number; byteLength: number } {
    const byteOffset = this.#addedBytes;
    this.reserve(content.length);
    this.#addedBytes += Math.ceil(content.length / alignment) * alignment;
    this.#added.push(content);
    return { buffer: this.list('buffers').length, byteOffset, byteLength: content.length };
  }

  /** Throws if this many more bytes exceed the limit. */
  reserve(bytes: number): void {
    if (this.#addedBytes + bytes <= maxDecompressedBytes) return;
    throw gltfFault(
      `it would decompress to more than ${maxDecompressedBytes / 2 ** 20} MB, the most that is read; simplify or split the model`,
    );
  }

  /** The new buffer. */
  *added(): SlicedWork<Uint8Array> {
    const all = new Uint8Array(this.#addedBytes);
    let at = 0;
    for (const content of this.#added) {
      yield* copyTo(all, at, content);
      at += Math.ceil(content.length / alignment) * alignment;
    }
    return all;
  }

  #bufferBytes(index: unknown, what: string): Uint8Array {
    const { uri } = this.entry('buffers', index, `the buffer of ${what}`);
    const { binary } = this.#document;
    if (uri === undefined && index === 0 && binary) return binary;
    if (typeof uri !== 'string')
      throw gltfFault(`buffer ${index}, which ${what} needs, has no uri`);
    if (/^data:/i.test(uri)) return this.#decodedBuffer(index as number, uri);
    const content = this.#resources.get(uri);
    if (content) return content;
    throw gltfFault(`buffer ${index} needs the file "${uri}", which is missing`);
  }

  #decodedBuffer(index: number, uri: string): Uint8Array {
    const content = this.decoded.get(index) ?? dataUriContent(uri, `buffer ${index}`);
    this.decoded.set(index, content);
    return content;
  }
}

/** An index or a size. */
export function whole(value: unknown, what: string): number {
  if (Number.isSafeInteger(value) && (value as number) >= 0) return value as number;
  const shown = isObject(value) ? 'no number' : String(value);
  throw gltfFault(`${what} is ${shown}, and not a whole number from 0`);
}

function dataUriContent(uri: string, owner: string): Uint8Array {
  const comma = uri.indexOf(',');
  try {
    const text = decodeURIComponent(uri.slice(comma + 1));
    if (comma < 0) throw new RangeError('no comma');
    const isBase64 = /;base64$/i.test(uri.slice(0, comma));
    const characters = isBase64 ? atob(text) : text;
    // By a loop: `Uint8Array.from` makes a list of all characters first, many times as large.
    const content = new Uint8Array(characters.length);
    for (let i = 0; i < content.length; ++i) content[i] = characters.charCodeAt(i);
    return content;
  } catch (cause) {
    throw gltfFault(`the data URI of ${owner} cannot be decoded`, cause);
  }
}
