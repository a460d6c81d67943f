// SPDX-License-Identifier: MIT
//
// Finds the point of the surface under a place of the view, and tells which points are hidden.

import {
  BufferAttribute,
  BufferGeometry,
  type Camera,
  DoubleSide,
  Mesh,
  MeshBasicMaterial,
  type Ray,
  Raycaster,
  type Vector2,
  type Vector3,
} from 'three';
import { wholeScene } from '../drawing/record_buffer.js';
import type { SceneMesh } from '../buffers/scene_mesh.js';
import type { BuiltTree, RayHit, SearchTree } from '../buffers/search_tree.js';

/**
 * A point of the surface: face and barycentric coordinates as everywhere, and its place in the
 * scene.
 */
export interface SurfaceHit {
  face: number;
  bary: [number, number, number];
  place: Vector3;
}

/** A point is hidden where the surface is nearer than it by more than this, in radii of the model. */
const hidingDistance = 0.01;

/**
 * Finds the surface under a place of the view. Until there is a search tree, which the first
 * picture does not need, it tests every triangle.
 */
export class Picker {
  /** Resolves when the tree is there, or the code to build it when needed, or neither can be. */
  readonly prepared: Promise<void>;
  readonly #mesh: SceneMesh;
  readonly #raycaster = new Raycaster();
  /** The triangles as three.js asks them one after the other. */
  readonly #triangles: Mesh;
  #Tree: typeof SearchTree | undefined;
  #tree: SearchTree | undefined;

  /** `tree` is built elsewhere; if that fails, it is built here when first needed. */
  constructor(mesh: SceneMesh, tree: Promise<BuiltTree | undefined>) {
    this.#mesh = mesh;
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(mesh.positions, 3));
    geometry.setIndex(new BufferAttribute(mesh.indices, 1));
    geometry.boundingSphere = wholeScene;
    this.#triangles = new Mesh(geometry, new MeshBasicMaterial({ side: DoubleSide }));
    this.prepared = this.#prepare(tree);
  }

  /** The nearest point of the surface there, in device coordinates. */
  pick(device: Vector2, camera: Camera): SurfaceHit | undefined {
    camera.updateMatrixWorld();
    this.#raycaster.setFromCamera(device, camera);
    const hit = this.#firstHit(this.#raycaster.ray);
    if (!hit) return undefined;
    const { face, point } = hit;
    return { face, bary: this.#mesh.barycentric(face, point.x, point.y, point.z), place: point };
  }

  /** The point of the surface nearest to one in space; that itself until this is prepared. */
  nearest(place: Vector3): Vector3 {
    return this.#builtTree()?.nearest(place) ?? place.clone();
  }

  /** Whether the surface hides a point that lies on it, or almost. */
  hides(point: Vector3, camera: Camera): boolean {
    const { ray } = this.#raycaster;
    ray.origin.setFromMatrixPosition(camera.matrixWorld);
    const distance = ray.origin.distanceTo(point);
    ray.lookAt(point);
    const hit = this.#firstHit(ray);
    return hit !== undefined && hit.distance < distance - hidingDistance;
  }

  async #prepare(tree: Promise<BuiltTree | undefined>): Promise<void> {
    try {
      const [{ SearchTree }, built] = await Promise.all([
        import('../buffers/search_tree.js'),
        tree,
      ]);
      if (built) this.#tree = new SearchTree(this.#mesh, built);
      this.#Tree = SearchTree;
    } catch {
      // Without a tree everything works, only slowly.
    }
  }

  #firstHit(ray: Ray): RayHit | undefined {
    const tree = this.#builtTree();
    if (tree) return tree.firstHit(ray);
    const [hit] = this.#raycaster.intersectObject(this.#triangles);
    return hit && { face: hit.faceIndex as number, point: hit.point, distance: hit.distance };
  }

  #builtTree(): SearchTree | undefined {
    this.#tree ??= this.#Tree && new this.#Tree(this.#mesh);
    return this.#tree;
  }
}
