// SPDX-License-Identifier: MIT
//
// Finds the triangles of a model quickly, by a tree of bounding boxes. Its code is large, and
// building a tree takes a while: both wait for the first picture, and a worker builds the tree if
// possible.

import { BufferAttribute, BufferGeometry, DoubleSide, type Ray, type Vector3 } from 'three';
import { MeshBVH, type SerializedBVH } from 'three-mesh-bvh';
import type { SceneMesh } from './scene_mesh.js';

/** Where a ray meets the surface first. */
export interface RayHit {
  face: number;
  point: Vector3;
  distance: number;
}

/** A tree as arrays that can be handed from a worker. */
export type BuiltTree = SerializedBVH;

export function buildTree(mesh: SceneMesh): BuiltTree {
  // Indirect: the tree must not reorder the triangles, whose order is their number.
  const tree = new MeshBVH(geometryOf(mesh), { indirect: true });
  return { ...MeshBVH.serialize(tree, { cloneBuffers: false }), index: null };
}

export class SearchTree {
  readonly #tree: MeshBVH;

  constructor(mesh: SceneMesh, built = buildTree(mesh)) {
    this.#tree = MeshBVH.deserialize(built, geometryOf(mesh), { setIndex: false });
  }

  firstHit(ray: Ray): RayHit | undefined {
    const hit = this.#tree.raycastFirst(ray, DoubleSide);
    if (hit?.faceIndex == null) return undefined;
    return { face: hit.faceIndex, point: hit.point, distance: hit.distance };
  }

  /** The point of the surface nearest to one in space. */
  nearest(place: Vector3): Vector3 {
    return this.#tree.closestPointToPoint(place)?.point.clone() ?? place.clone();
  }
}

function geometryOf({ positions, indices }: SceneMesh): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setIndex(new BufferAttribute(indices, 1));
  return geometry;
}
