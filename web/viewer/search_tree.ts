// SPDX-License-Identifier: MIT
import { BufferAttribute, BufferGeometry, DoubleSide, type Ray, type Vector3 } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import type { SceneMesh } from './scene_mesh.js';

/** Where a ray meets the surface first. */
export interface RayHit {
  face: number;
  point: Vector3;
  distance: number;
}

/** Finds the triangles of a model quickly. Building it takes a while, and its code is large. */
export class SearchTree {
  readonly #tree: MeshBVH;
  /** Of the tree's triangles: it has none with corners that are no numbers. */
  readonly #faces: Int32Array;

  constructor({ positions, indices, faceCount }: SceneMesh) {
    const hasFinitePosition = (corner: number) => {
      const v = 3 * indices[corner];
      return Number.isFinite(positions[v] + positions[v + 1] + positions[v + 2]);
    };
    this.#faces = Int32Array.from({ length: faceCount }, (_, face) => face).filter((face) =>
      [0, 1, 2].every((k) => hasFinitePosition(3 * face + k)),
    );
    const corners = new Uint32Array(3 * this.#faces.length);
    this.#faces.forEach((face, i) => corners.set(indices.subarray(3 * face, 3 * face + 3), 3 * i));
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setIndex(new BufferAttribute(corners, 1));
    // Indirect: the tree must not reorder the triangles, whose order is their number.
    this.#tree = new MeshBVH(geometry, { indirect: true });
  }

  firstHit(ray: Ray): RayHit | undefined {
    const hit = this.#tree.raycastFirst(ray, DoubleSide);
    if (hit?.faceIndex == null) return undefined;
    return { face: this.#faces[hit.faceIndex], point: hit.point, distance: hit.distance };
  }

  /** The point of the surface nearest to one in space. */
  nearest(place: Vector3): Vector3 {
    return this.#tree.closestPointToPoint(place)?.point.clone() ?? place.clone();
  }
}
