// SPDX-License-Identifier: MIT
//
// The script of the worker that writes files: seconds of work, for large models.

import { zipSync } from 'fflate';
import {
  type Partition,
  diagramGlb,
  diagramJson,
  diagramObj,
  partitionCsv,
  partitionGlb,
  partitionObj,
  partitionPly,
  partitionStl,
  polygonGlb,
  polygonObj,
  polygonPly,
  polygonStl,
} from 'geodesic-voronoi';

/** A zip of the regions, a file each: STL has no names to tell them apart. */
function partitionStls(partition: Partition): Uint8Array<ArrayBuffer> {
  const labels = new Set(partition.triangles.label);
  const digits = String(partition.regions.area.length - 1).length;
  const nameOf = (label: number) =>
    label < 0 ? 'unreachable.stl' : `region-${String(label).padStart(digits, '0')}.stl`;
  return zipSync(
    Object.fromEntries(
      Array.from(labels, (region) => [nameOf(region), partitionStl(partition, { region })]),
    ),
  );
}

const encoders = {
  diagramGlb,
  diagramJson: (...diagram: Parameters<typeof diagramJson>) =>
    JSON.stringify(diagramJson(...diagram)),
  diagramObj,
  partitionCsv,
  partitionGlb,
  partitionObj,
  partitionPly,
  partitionStls,
  polygonGlb,
  polygonObj,
  polygonPly,
  polygonStl,
};
type Encoders = typeof encoders;

/** An encoder by its name, and its arguments. */
export type Encoding = {
  [Name in keyof Encoders]: [Name, ...Parameters<Encoders[Name]>];
}[keyof Encoders];

export interface EncodingRequest {
  encoding: Encoding;
  /** The media type of the file. */
  type: string;
}

/** A worker's own scope. It answers with the file, or with why there is none. */
const scope = globalThis as unknown as {
  onmessage: ((event: MessageEvent<EncodingRequest>) => void) | null;
  onmessageerror: (() => void) | null;
  postMessage(message: unknown): void;
};

/** What is written may be too large for the memory there is. */
scope.onmessageerror = () => scope.postMessage('its worker cannot receive it');
scope.onmessage = ({ data: { encoding, type } }) => {
  const [name, ...args] = encoding;
  const encode = encoders[name] as (...args: unknown[]) => BlobPart;
  try {
    // A blob is handed over without a copy.
    scope.postMessage(new Blob([encode(...args)], { type }));
  } catch (error) {
    scope.postMessage((error as Error).message);
  }
};
