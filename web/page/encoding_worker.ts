// SPDX-License-Identifier: MIT
//
// The script of the worker that writes files: seconds of work, for large models.

import {
  diagramGlb,
  diagramJson,
  diagramObj,
  partitionGlb,
  partitionObj,
  partitionPly,
  polygonGlb,
  polygonObj,
  polygonPly,
} from 'geodesic-voronoi';

/** The encoders, by the names that `encode` takes. */
const encoders = {
  diagramGlb,
  diagramJson: (...diagram: Parameters<typeof diagramJson>) =>
    JSON.stringify(diagramJson(...diagram)),
  diagramObj,
  partitionGlb,
  partitionObj,
  partitionPly,
  polygonGlb,
  polygonObj,
  polygonPly,
};
export type Encoders = typeof encoders;

/** A request: an encoder with its arguments, and the media type of the file. */
export interface EncodingRequest<Name extends keyof Encoders> {
  name: Name;
  args: Parameters<Encoders[Name]>;
  type: string;
}

/** A worker's own scope. */
const scope = globalThis as unknown as {
  onmessage: ((event: MessageEvent<EncodingRequest<keyof Encoders>>) => void) | null;
  postMessage(message: unknown): void;
};

scope.onmessage = ({ data: { name, args, type } }) => {
  const encode = encoders[name] as (...args: unknown[]) => BlobPart;
  // A blob is handed over without a copy.
  scope.postMessage(new Blob([encode(...args)], { type }));
};
