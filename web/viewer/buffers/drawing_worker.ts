// SPDX-License-Identifier: MIT
//
// The script of the worker that `DrawingBuilder` starts: through each port that it gets come a
// mesh, then what is to be drawn of it.

import type { Mesh } from 'geodesic-voronoi';
import { type DiagramLines, diagramGeometry } from './diagram_geometry.js';
import { cornersToAsk, type DistanceSamples, distanceTriangles } from './distance_triangles.js';
import { meshEdges } from './mesh_edges.js';
import { adjacencyOf } from './places.js';
import { type Parts, partTriangles } from './part_triangles.js';
import { sceneArrays } from './scene_arrays.js';
import { SceneMesh } from './scene_mesh.js';
import { buffersOf } from './transfer.js';
import type { DrawnPixels, PictureFormat } from '../stage/picture_file.js';

/** The tasks of one port, by their names. Code that no first picture needs is fetched when asked for. */
function newTasks() {
  let mesh: SceneMesh;
  return {
    answers: () => true,
    scene: (given: Pick<Mesh, 'positions' | 'indices'>) => {
      const arrays = sceneArrays(given);
      const { positions, indices, normals } = arrays;
      // Arrays in the answer are transferred; the worker keeps a copy of those it needs.
      mesh = new SceneMesh({
        ...arrays,
        positions: positions.slice(),
        indices: indices.slice(),
        normals: normals.slice(),
      });
      return arrays;
    },
    // It fails where a page finds modules by an import map, which its workers do not.
    tree: async () => (await import('./search_tree.js')).buildTree(mesh),
    edges: () => meshEdges(mesh.indices),
    adjacency: () => adjacencyOf(mesh),
    corners: (faceLabel: Int32Array) => cornersToAsk(mesh, faceLabel),
    diagram: (diagram: DiagramLines) => diagramGeometry(mesh, diagram),
    parts: (partition: Parts, tones: Uint16Array) => partTriangles(mesh, partition, tones),
    distances: (samples: DistanceSamples) => distanceTriangles(mesh, samples),
    ply: async (bytes: Uint8Array) => (await import('./ply_surface.js')).plySurface(bytes),
    picture: async (drawn: DrawnPixels, format: PictureFormat) =>
      (await import('../stage/picture_file.js')).pictureFile(drawn, format),
  };
}
export type DrawingTasks = ReturnType<typeof newTasks>;

/** A request to the worker; the answer has the same number, and is undefined after a failure. */
export interface DrawingRequest<Name extends keyof DrawingTasks> {
  id: number;
  name: Name;
  args: Parameters<DrawingTasks[Name]>;
}
export interface DrawingAnswer {
  id: number;
  result: unknown;
}

globalThis.onmessage = ({ data: port }: MessageEvent<MessagePort>) => {
  const tasks = newTasks() as Record<string, (...args: unknown[]) => unknown>;
  const answer = (id: number, result: unknown) =>
    port.postMessage({ id, result } satisfies DrawingAnswer, [...buffersOf(result)]);

  // The other side gets this as an error of the worker; else it would wait for an answer for ever.
  port.onmessageerror = () => {
    throw new Error('a message cannot be received');
  };
  // Most answers are made at once, in the order of the requests.
  port.onmessage = ({ data }: MessageEvent<DrawingRequest<keyof DrawingTasks>>) => {
    const { id, name, args } = data;
    try {
      const result = tasks[name](...args);
      if (!(result instanceof Promise)) answer(id, result);
      else void result.catch(() => undefined).then((made) => answer(id, made));
    } catch {
      answer(id, undefined);
    }
  };
};
