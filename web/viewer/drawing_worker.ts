// SPDX-License-Identifier: MIT
//
// The script of the worker that `DrawingBuilder` starts: through each port that it gets come a mesh, then
// what is to be drawn of it.

import { cellTriangles } from './cell_triangles.js';
import { distanceTriangles } from './distance_triangles.js';
import type { DrawingRequest } from './drawing_builder.js';
import { partTriangles } from './part_triangles.js';
import { SceneMesh } from './scene_mesh.js';

globalThis.onmessage = ({ data: port }: MessageEvent<MessagePort>) => {
  let mesh: SceneMesh;
  const answer = (result: object) => {
    const buffers = Object.values(result).map(
      ({ buffer }: ArrayBufferView) => buffer as ArrayBuffer,
    );
    port.postMessage(result, buffers);
  };
  port.onmessage = ({ data: request }: MessageEvent<DrawingRequest>) => {
    switch (request.kind) {
      case 'mesh':
        mesh = new SceneMesh(request.mesh);
        return;
      case 'cells':
        return answer(cellTriangles(mesh, request.cells));
      case 'parts':
        return answer(partTriangles(mesh, request.partition, request.tones));
      case 'distances':
        return answer(distanceTriangles(mesh, request.samples));
    }
  };
};
