// SPDX-License-Identifier: MIT
//
// The script of the worker that `CellBuilder` starts: it gets a mesh, then cells to be cut.

import type { CellRequest } from './cell_builder.js';
import { cellTriangles } from './cell_triangles.js';
import { SceneMesh } from './scene_mesh.js';

/** A worker's own scope. */
const scope = globalThis as unknown as {
  onmessage: ((event: MessageEvent<CellRequest>) => void) | null;
  postMessage(message: unknown, transfer: Transferable[]): void;
};
let mesh: SceneMesh;

scope.onmessage = ({ data: request }) => {
  if ('positions' in request) {
    mesh = new SceneMesh(request);
    return;
  }
  const result = cellTriangles(mesh, request);
  const { keys, position, normal } = result;
  scope.postMessage(result, [keys.buffer, position.buffer, normal.buffer] as ArrayBuffer[]);
};
