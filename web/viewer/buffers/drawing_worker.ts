// SPDX-License-Identifier: MIT
//
// The script of the worker that `DrawingBuilder` starts: through each port that it gets come a
// mesh, then what is to be drawn of it.

import { diagramGeometry } from './diagram_geometry.js';
import { distanceTriangles } from './distance_triangles.js';
import type { DrawingAnswer, DrawingRequest, DrawingTask } from './drawing_builder.js';
import { meshEdges } from './mesh_edges.js';
import { partTriangles } from './part_triangles.js';
import { sceneArrays } from './scene_arrays.js';
import { SceneMesh } from './scene_mesh.js';
import { buffersOf } from './transfer.js';

globalThis.onmessage = ({ data: port }: MessageEvent<MessagePort>) => {
  let mesh: SceneMesh;

  const make = (task: DrawingTask): unknown => {
    switch (task.kind) {
      case 'mesh': {
        const arrays = sceneArrays(task.mesh);
        const { positions, indices, normals } = arrays;
        // Arrays in the answer are transferred; the worker keeps a copy of those it needs.
        mesh = new SceneMesh({
          ...arrays,
          positions: positions.slice(),
          indices: indices.slice(),
          normals: normals.slice(),
        });
        return arrays;
      }
      case 'tree':
        return builtTree(mesh);
      case 'edges':
        return meshEdges(mesh.indices);
      case 'diagram':
        return diagramGeometry(mesh, task.diagram);
      case 'parts':
        return partTriangles(mesh, task.partition, task.tones);
      case 'distances':
        return distanceTriangles(mesh, task.samples);
      case 'ply':
        return import('./ply_surface.js').then(({ plySurface }) => plySurface(task.bytes));
      case 'picture':
        return import('../stage/picture_file.js').then(({ pictureFile }) =>
          pictureFile(task.drawn, task.format),
        );
    }
  };

  const answer = (id: number, result: unknown) =>
    port.postMessage({ id, result } satisfies DrawingAnswer, [...buffersOf(result)]);

  // Most answers are made at once, in the order of the requests; undefined is that of a failure.
  port.onmessage = ({ data: { id, task } }: MessageEvent<DrawingRequest>) => {
    try {
      const result = make(task);
      if (!(result instanceof Promise)) answer(id, result);
      else void result.catch(() => undefined).then((made) => answer(id, made));
    } catch {
      answer(id, undefined);
    }
  };
};

/** Its code is fetched when it is first asked for: no first picture needs it. */
async function builtTree(mesh: SceneMesh): Promise<unknown> {
  // It fails where a page finds modules by an import map, which its workers do not.
  return (await import('./search_tree.js')).buildTree(mesh);
}
