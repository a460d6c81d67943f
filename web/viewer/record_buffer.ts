// SPDX-License-Identifier: MIT
import { type BufferAttribute, type InterleavedBuffer, Sphere, Vector3 } from 'three';

/** Numbers of the same kind for every record, as the graphics card gets them. */
export type UploadedBuffer = BufferAttribute | InterleavedBuffer;

/**
 * Bounds all that is drawn (see `ModelFrame`). Given to geometries of records, or bounds would be
 * computed of them that hold for no longer than the records.
 */
export const wholeScene = new Sphere(new Vector3(), 1);

/** Uploading this many records that have not changed is cheaper than another call. */
const negligibleGap = 32;
/** More calls than this in a frame cost drivers more than uploading all of the buffer. */
const mostRanges = 64;
/** How much larger than needed a buffer is made. */
const slack = 1.4;

/**
 * Records of a fixed size, without order, that come and go: in buffers in which those that go make room
 * for those that come, and of which only the records that are written are uploaded. Every record has a
 * key that tells what it belongs to.
 */
export class RecordBuffer<Key> {
  readonly #make: (capacity: number) => readonly UploadedBuffer[];
  #buffers: readonly UploadedBuffer[];
  #capacity = 1;
  /** Per record. */
  #keys: Key[] = [];

  /** `make` makes the buffers for so many records. */
  constructor(make: (capacity: number) => readonly UploadedBuffer[]) {
    this.#make = make;
    this.#buffers = make(this.#capacity);
  }

  get count(): number {
    return this.#keys.length;
  }

  /** They are others after a call that needed larger ones. */
  get buffers(): readonly UploadedBuffer[] {
    return this.#buffers;
  }

  /** These records and no others: one per key, whose numbers stand one after the other per buffer. */
  set(keys: readonly Key[], numbers: readonly ArrayLike<number>[]): void {
    this.#keys = [];
    this.#reserve(keys.length);
    this.#keys = [...keys];
    this.#buffers.forEach((buffer, b) => {
      (buffer.array as Float32Array).set(numbers[b]);
      uploadAll(buffer, numbers[b].length);
    });
  }

  /** Other records instead of those whose key says that they are gone. O(count), with little for each. */
  replace(
    isGone: (key: Key) => boolean,
    keys: readonly Key[],
    numbers: readonly ArrayLike<number>[],
  ): void {
    const holes = this.#recordsWhere(isGone);
    this.#reserve(this.count - holes.length + keys.length);
    const written: number[] = [];
    keys.forEach((key, i) => {
      const record = i < holes.length ? holes[i] : this.count;
      this.#keys[record] = key;
      this.#write(record, numbers, i);
      written.push(record);
    });
    for (const hole of this.#closed(holes.slice(keys.length))) written.push(hole);
    this.#buffers.forEach((buffer) => {
      uploadRecords(buffer, written, this.#width(buffer));
    });
  }

  /** Writes the numbers in one of the buffers anew for the records with such a key. */
  rewrite(
    isConcerned: (key: Key) => boolean,
    b: number,
    write: (key: Key, target: { [i: number]: number }, at: number) => void,
  ): void {
    const buffer = this.#buffers[b];
    const width = this.#width(buffer);
    const records = this.#recordsWhere(isConcerned);
    for (const record of records) write(this.#keys[record], buffer.array, width * record);
    uploadRecords(buffer, records, width);
  }

  /** Ascending. */
  #recordsWhere(isMeant: (key: Key) => boolean): number[] {
    const records: number[] = [];
    for (let record = 0; record < this.count; ++record) {
      if (isMeant(this.#keys[record])) records.push(record);
    }
    return records;
  }

  /** Moves the last records into holes (ascending) until there is none; returns those written. */
  #closed(holes: readonly number[]): number[] {
    const written: number[] = [];
    let open = holes.length;
    for (let i = 0; i < open; ++i) {
      while (open > i && holes[open - 1] === this.count - 1) {
        this.#keys.pop();
        --open;
      }
      if (open === i) break;
      const last = this.count - 1;
      this.#keys[holes[i]] = this.#keys[last];
      const arrays = this.#buffers.map(({ array }) => array);
      this.#write(holes[i], arrays, last);
      this.#keys.pop();
      written.push(holes[i]);
    }
    return written;
  }

  #write(record: number, numbers: readonly ArrayLike<number>[], i: number): void {
    for (let b = 0; b < this.#buffers.length; ++b) {
      const width = this.#width(this.#buffers[b]);
      const from = numbers[b];
      const to = this.#buffers[b].array;
      for (let k = 0; k < width; ++k) to[width * record + k] = from[width * i + k];
    }
  }

  #width({ array }: UploadedBuffer): number {
    return array.length / this.#capacity;
  }

  #reserve(count: number): void {
    if (count <= this.#capacity) return;
    const before = this.#buffers;
    this.#capacity = Math.ceil(slack * count);
    this.#buffers = this.#make(this.#capacity);
    if (this.count === 0) return;
    this.#buffers.forEach((buffer, b) => (buffer.array as Float32Array).set(before[b].array));
  }
}

/** Has the next drawing upload these records of a buffer, each so many numbers wide, and little else. */
export function uploadRecords(
  buffer: UploadedBuffer,
  records: ArrayLike<number>,
  width: number,
): void {
  if (records.length === 0) return;
  let first = records[0];
  let last = first;
  const addRange = () => buffer.addUpdateRange(width * first, width * (last + 1 - first));
  for (let i = 1; i < records.length; ++i) {
    const record = records[i];
    if (record < last || record > last + negligibleGap) {
      addRange();
      first = record;
    }
    last = record;
  }
  addRange();
  if (buffer.updateRanges.length > mostRanges) uploadAll(buffer);
  buffer.needsUpdate = true;
}

/**
 * Has the next drawing upload all of a buffer, or so many numbers from its beginning. It is a range like
 * others: without any, those that are added before the drawing would be all that is uploaded.
 */
export function uploadAll(buffer: UploadedBuffer, length = buffer.array.length): void {
  buffer.clearUpdateRanges();
  buffer.addUpdateRange(0, length);
  buffer.needsUpdate = true;
}
