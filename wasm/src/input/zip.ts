// SPDX-License-Identifier: MIT
//
// The files of a zip archive (PKWARE's APPNOTE.TXT), each unpacked when it is read. What the
// archive says of their sizes is checked first, and nothing is unpacked beyond it: an archive of a
// few bytes can hold terabytes of zeros.

import { Inflate } from 'fflate';
import { invalidFile } from '../api/errors.js';
import { copyTo } from '../base/growing_array.js';
import { inSlices, type SlicedWork } from '../base/slices.js';
import type { ModelFiles, TaskOptions } from '../api/options.js';

/**
 * The most bytes that all files together may unpack to: models are packed to a quarter or so, and
 * the ratio of small ones does not matter.
 */
const mostUnpacked = (packedBytes: number) => 2 ** 25 + 4 * packedBytes;
/** So little at a time that even zeros, packed a thousandfold, take a few milliseconds. */
const stepBytes = 2 ** 12;

interface Entry {
  name: string;
  /** 0 stored, 8 deflated. */
  method: number;
  isEncrypted: boolean;
  packedSize: number;
  size: number;
  /** The place of the local header, which precedes the data. */
  offset: number;
}

export function zipFiles(archive: Uint8Array, task: TaskOptions): ModelFiles {
  const entries = entriesOf(archive).filter(({ name }) => !name.endsWith('/'));
  const total = entries.reduce((sum, { size }) => sum + size, 0);
  const most = mostUnpacked(archive.length);
  if (total > most) {
    const megabytes = (bytes: number) => `${Math.ceil(bytes / 2 ** 20)} MB`;
    throw invalidFile(
      `the zip of ${megabytes(archive.length)} would unpack to ${megabytes(total)}, more than the ${megabytes(most)} that are unpacked; unpacked, it can be opened as a folder`,
    );
  }
  return Object.fromEntries(
    entries.map((entry) => [
      entry.name,
      { arrayBuffer: async () => (await unpacked(archive, entry, task)).buffer as ArrayBuffer },
    ]),
  );
}

/** The central directory, which is at the end; it alone knows all sizes. */
function entriesOf(archive: Uint8Array): Entry[] {
  const view = viewOf(archive);
  const end = endOfDirectory(view);
  const count = view.getUint16(end + 10, true);
  let at = view.getUint32(end + 16, true);
  if (count === 0xffff || at === 0xffffffff)
    throw invalidFile('the zip is one of 64 bits: unpack it first');
  return Array.from({ length: count }, () => {
    if (at + 46 > end || view.getUint32(at, true) !== 0x02014b50) {
      throw invalidFile(`the zip is damaged: there is no directory entry at byte ${at}`);
    }
    const flags = view.getUint16(at + 8, true);
    const nameLength = view.getUint16(at + 28, true);
    // Names are UTF-8 if bit 11 of the flags is set, else in an old code page: ASCII is in both.
    const name = new TextDecoder().decode(archive.subarray(at + 46, at + 46 + nameLength));
    const entry: Entry = {
      name: name.replaceAll('\\', '/'),
      method: view.getUint16(at + 10, true),
      isEncrypted: (flags & 1) !== 0,
      packedSize: view.getUint32(at + 20, true),
      size: view.getUint32(at + 24, true),
      offset: view.getUint32(at + 42, true),
    };
    at += 46 + nameLength + view.getUint16(at + 30, true) + view.getUint16(at + 32, true);
    return entry;
  });
}

/** The place of the record that ends the archive; only a comment may follow it. */
function endOfDirectory(view: DataView): number {
  const last = view.byteLength - 22;
  for (let at = last; at >= Math.max(0, last - 0xffff); --at) {
    if (view.getUint32(at, true) === 0x06054b50) return at;
  }
  throw invalidFile('the zip is truncated: its directory is missing');
}

async function unpacked(archive: Uint8Array, entry: Entry, task: TaskOptions): Promise<Uint8Array> {
  const { name, method, isEncrypted, packedSize, size, offset } = entry;
  if (isEncrypted) throw invalidFile(`${name} in the zip is encrypted: unpack it first`);
  if (method !== 0 && method !== 8) {
    throw invalidFile(`${name} in the zip is packed by method ${method}; only 0 and 8 are read`);
  }
  const view = viewOf(archive);
  const damaged = () => invalidFile(`the zip is damaged: ${name} cannot be unpacked`);
  if (offset + 30 > archive.length || view.getUint32(offset, true) !== 0x04034b50) throw damaged();
  const start = offset + 30 + view.getUint16(offset + 26, true) + view.getUint16(offset + 28, true);
  const packed = archive.subarray(start, start + packedSize);
  if (packed.length < packedSize || (method === 0 && packedSize !== size)) throw damaged();
  const work = method === 0 ? copied(packed) : inflated(packed, size);
  const content = await inSlices(work, { signal: task.signal });
  if (!content) throw damaged();
  return content;
}

function* copied(stored: Uint8Array): SlicedWork<Uint8Array> {
  const content = new Uint8Array(stored.length);
  yield* copyTo(content, 0, stored);
  return content;
}

/** Inflates a file; undefined unless it has exactly `size` bytes. Stops as soon as it has more. */
function* inflated(packed: Uint8Array, size: number): SlicedWork<Uint8Array | undefined> {
  const content = new Uint8Array(size);
  let length = 0;
  const inflate = new Inflate((chunk) => {
    content.set(chunk, length); // a RangeError if it does not fit
    length += chunk.length;
  });
  for (let at = 0; at < packed.length; at += stepBytes) {
    try {
      inflate.push(packed.subarray(at, at + stepBytes), at + stepBytes >= packed.length);
    } catch {
      return undefined;
    }
    yield at / packed.length;
  }
  return length === size ? content : undefined;
}

function viewOf(bytes: Uint8Array): DataView {
  return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
}
