// SPDX-License-Identifier: MIT
//
// Arrays on the graphics card that change in parts.

import { type BufferAttribute, type InterleavedBuffer, Sphere, Vector3 } from 'three';
import { roomFor } from '../buffers/record_room.js';

/** Numbers of the same kind for every record, as the graphics card gets them. */
type UploadedBuffer = BufferAttribute | InterleavedBuffer;

/**
 * Bounds everything that is drawn (see `ModelFrame`). Geometries of records get it, because bounds
 * computed from the records would be wrong once these change.
 */
export const wholeScene = new Sphere(new Vector3(), 1);

/** Uploading this many unchanged records costs less than another range to upload. */
const negligibleGap = 32;
/** The most ranges per frame: drivers complain of more calls, and uploading the gaps costs less. */
const mostRanges = 8;

/** Two numbers per record that tell what it belongs to: `keys[2 * i]` and `keys[2 * i + 1]`. */
export type Keys = Int32Array;
/** A choice of records: those whose first or second key is marked by a 1. */
export interface Marks {
  readonly first?: Uint8Array;
  readonly second?: Uint8Array;
}
export const noMarks = new Uint8Array();

/**
 * Records of a fixed size, in no order, that come and go. New records fill the room of removed
 * ones, and little more is uploaded than the records that are written.
 */
export class RecordBuffer {
  readonly #make: (capacity: number) => readonly UploadedBuffer[];
  #buffers: readonly UploadedBuffer[];
  #capacity = 1;
  #count = 0;
  #keys: Keys = new Int32Array(2);

  /** `make` makes buffers for the given number of records. */
  constructor(make: (capacity: number) => readonly UploadedBuffer[]) {
    this.#make = make;
    this.#buffers = make(this.#capacity);
  }

  get count(): number {
    return this.#count;
  }

  /** The buffers; replaced by larger ones when a call needs these. */
  get buffers(): readonly UploadedBuffer[] {
    return this.#buffers;
  }

  /** Replaces all records; each buffer gets its list of numbers, record after record. */
  set(keys: Keys, numbers: readonly ArrayLike<number>[]): void {
    this.#count = 0;
    this.#reserve(keys.length / 2);
    this.#count = keys.length / 2;
    this.#keys.set(keys);
    this.#buffers.forEach((buffer, b) => {
      (buffer.array as Float32Array).set(numbers[b]);
      uploadAll(buffer, numbers[b].length);
    });
  }

  /** Replaces all records, and the buffers by filled ones with room for `capacity` records. */
  adopt(keys: Keys, buffers: readonly UploadedBuffer[], capacity: number): void {
    this.#count = keys.length / 2;
    this.#capacity = capacity;
    this.#buffers = buffers;
    this.#keys = new Int32Array(2 * capacity);
    this.#keys.set(keys);
  }

  /** Replaces the records that are gone by others. O(count), with little work for each. */
  replace(gone: Marks, keys: Keys, numbers: readonly ArrayLike<number>[]): void {
    const holes = this.#marked(gone);
    const added = keys.length / 2;
    this.#reserve(this.#count - holes.length + added);
    const arrays = this.#buffers.map(({ array }) => array);
    const written: number[] = [];
    for (let i = 0; i < added; ++i) {
      const record = i < holes.length ? holes[i] : this.#count++;
      this.#write(record, keys, arrays, numbers, i);
      written.push(record);
    }
    this.#close(holes.slice(added), arrays, written);
    this.#buffers.forEach((buffer) => {
      uploadRecords(buffer, written, this.#width(buffer));
    });
  }

  /** Writes the numbers in one of the buffers anew for the records that are meant. */
  rewrite(
    meant: Marks,
    b: number,
    write: (keys: Keys, record: number, target: { [i: number]: number }, at: number) => void,
  ): void {
    const buffer = this.#buffers[b];
    const width = this.#width(buffer);
    const records = this.#marked(meant);
    for (const record of records) write(this.#keys, record, buffer.array, width * record);
    uploadRecords(buffer, records, width);
  }

  /** The marked records, ascending. Each case has its own loop, to read as little as possible. */
  #marked({ first, second }: Marks): number[] {
    const keys = this.#keys;
    const end = 2 * this.#count;
    const records: number[] = [];
    if (first && second) {
      for (let i = 0; i < end; i += 2)
        if (first[keys[i]] | second[keys[i + 1]]) records.push(i / 2);
    } else if (first) {
      for (let i = 0; i < end; i += 2) if (first[keys[i]]) records.push(i / 2);
    } else if (second) {
      for (let i = 0; i < end; i += 2) if (second[keys[i + 1]]) records.push(i / 2);
    }
    return records;
  }

  /** Fills holes (ascending) with the last records; adds the filled places to `written`. */
  #close(holes: readonly number[], arrays: readonly ArrayLike<number>[], written: number[]): void {
    let open = holes.length;
    for (let i = 0; i < open; ++i) {
      while (open > i && holes[open - 1] === this.#count - 1) {
        --this.#count;
        --open;
      }
      if (open === i) break;
      this.#write(holes[i], this.#keys, arrays, arrays, --this.#count);
      written.push(holes[i]);
    }
  }

  /** Copies record number i of the given ones. */
  #write(
    record: number,
    keys: Keys,
    arrays: readonly { [i: number]: number; readonly length: number }[],
    numbers: readonly ArrayLike<number>[],
    i: number,
  ): void {
    this.#keys[2 * record] = keys[2 * i];
    this.#keys[2 * record + 1] = keys[2 * i + 1];
    for (let b = 0; b < arrays.length; ++b) {
      const to = arrays[b];
      const from = numbers[b];
      const width = to.length / this.#capacity;
      for (let k = 0; k < width; ++k) to[width * record + k] = from[width * i + k];
    }
  }

  #width({ array }: UploadedBuffer): number {
    return array.length / this.#capacity;
  }

  #reserve(count: number): void {
    if (count <= this.#capacity) return;
    const { buffers: before } = this;
    const keysBefore = this.#keys;
    this.#capacity = roomFor(count);
    this.#buffers = this.#make(this.#capacity);
    this.#keys = new Int32Array(2 * this.#capacity);
    if (this.#count === 0) return;
    this.#keys.set(keysBefore);
    this.#buffers.forEach((buffer, b) => (buffer.array as Float32Array).set(before[b].array));
  }
}

/**
 * Has the next drawing upload these records of a buffer, each `width` numbers wide, and all but the
 * widest gaps between them.
 */
export function uploadRecords(
  buffer: UploadedBuffer,
  records: ArrayLike<number>,
  width: number,
): void {
  if (records.length === 0) return;
  const runs = [...buffer.updateRanges];
  let start = records[0];
  let end = start;
  const addRun = () => runs.push({ start: width * start, count: width * (end - start) });
  for (let i = 0; i < records.length; ++i) {
    if (records[i] < end || records[i] > end + negligibleGap) {
      addRun();
      start = records[i];
    }
    end = records[i] + 1;
  }
  addRun();
  buffer.clearUpdateRanges();
  for (const { start, count } of fewRanges(runs)) buffer.addUpdateRange(start, count);
  buffer.needsUpdate = true;
}

/**
 * Has the next drawing upload a whole buffer, or its first `length` numbers. They are a range:
 * without one three.js would upload all, but ranges may be added before the drawing.
 */
export function uploadAll(buffer: UploadedBuffer, length = buffer.array.length): void {
  buffer.clearUpdateRanges();
  buffer.addUpdateRange(0, length);
  buffer.needsUpdate = true;
}

interface Range {
  start: number;
  count: number;
}

/** At most `mostRanges` ranges, ascending, that hold all of these and leave out the widest gaps. */
function fewRanges(ranges: readonly Range[]): Range[] {
  const ascending = [...ranges].sort((a, b) => a.start - b.start);
  const gaps: Range[] = [];
  let end = ascending[0].start;
  for (const { start, count } of ascending) {
    if (start > end) gaps.push({ start: end, count: start - end });
    end = Math.max(end, start + count);
  }
  const widest = gaps.sort((a, b) => b.count - a.count).slice(0, mostRanges - 1);
  const result: Range[] = [];
  let { start } = ascending[0];
  for (const gap of widest.sort((a, b) => a.start - b.start)) {
    result.push({ start, count: gap.start - start });
    start = gap.start + gap.count;
  }
  result.push({ start, count: end - start });
  return result;
}
