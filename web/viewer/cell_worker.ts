// SPDX-License-Identifier: MIT
//
// The script of the worker that `CellBuilder` starts. Through each port that it gets come a mesh, then
// cells to be cut.

import type { CellRequest } from './cell_builder.js';
import { cellTriangles } from './cell_triangles.js';
import { SceneMesh } from './scene_mesh.js';

globalThis.onmessage = ({ data: port }: MessageEvent<MessagePort>) => {
  let mesh: SceneMesh;
  port.onmessage = ({ data: request }: MessageEvent<CellRequest>) => {
    if ('positions' in request) {
      mesh = new SceneMesh(request);
      return;
    }
    const result = cellTriangles(mesh, request);
    const { keys, position, normal } = result;
    port.postMessage(result, [keys.buffer, position.buffer, normal.buffer] as ArrayBuffer[]);
  };
};
