// SPDX-License-Identifier: MIT
import {
  BufferAttribute,
  BufferGeometry,
  type Camera,
  DoubleSide,
  Raycaster,
  type Vector2,
  type Vector3,
} from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import type { SceneMesh } from './scene_mesh.js';

/** A point of the surface: face and barycentric coordinates as everywhere, and its place in the scene. */
export interface SurfaceHit {
  face: number;
  bary: [number, number, number];
  place: Vector3;
}

/** What lies under a place of the view. The search tree is built when first asked. */
export class Picker {
  readonly #mesh: SceneMesh;
  readonly #raycaster = new Raycaster();
  #tree: { bvh: MeshBVH; faces: Int32Array } | undefined;

  constructor(mesh: SceneMesh) {
    this.#mesh = mesh;
  }

  /** The nearest point of the surface there, in device coordinates. */
  pick(device: Vector2, camera: Camera): SurfaceHit | undefined {
    camera.updateMatrixWorld();
    this.#raycaster.setFromCamera(device, camera);
    const { bvh, faces } = this.#builtTree();
    const hit = bvh.raycastFirst(this.#raycaster.ray, DoubleSide);
    if (hit?.faceIndex == null) return undefined;
    const face = faces[hit.faceIndex];
    const { x, y, z } = hit.point;
    return { face, bary: this.#mesh.barycentric(face, x, y, z), place: hit.point };
  }

  /** The point of the surface nearest to one in space. */
  nearest(place: Vector3): Vector3 {
    return this.#builtTree().bvh.closestPointToPoint(place)?.point.clone() ?? place.clone();
  }

  /** Whether the surface hides a point that lies on it or is lifted off it by up to `slack`. */
  hides(point: Vector3, camera: Camera, slack = 0.01): boolean {
    const { ray } = this.#raycaster;
    ray.origin.setFromMatrixPosition(camera.matrixWorld);
    const distance = ray.origin.distanceTo(point);
    ray.lookAt(point);
    const hit = this.#builtTree().bvh.raycastFirst(ray, DoubleSide);
    return hit !== null && hit.distance < distance - slack;
  }

  /** `faces` are the numbers of the tree's triangles: it has none with corners that are no numbers. */
  #builtTree(): { bvh: MeshBVH; faces: Int32Array } {
    if (this.#tree) return this.#tree;
    const { positions, indices, faceCount } = this.#mesh;
    const hasFinitePosition = (corner: number) => {
      const v = 3 * indices[corner];
      return Number.isFinite(positions[v] + positions[v + 1] + positions[v + 2]);
    };
    const faces = Int32Array.from({ length: faceCount }, (_, face) => face).filter((face) =>
      [0, 1, 2].every((k) => hasFinitePosition(3 * face + k)),
    );
    const corners = new Uint32Array(3 * faces.length);
    faces.forEach((face, i) => corners.set(indices.subarray(3 * face, 3 * face + 3), 3 * i));
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setIndex(new BufferAttribute(corners, 1));
    // Indirect: the tree must not reorder the triangles, whose order is their number.
    this.#tree = { bvh: new MeshBVH(geometry, { indirect: true }), faces };
    return this.#tree;
  }
}
