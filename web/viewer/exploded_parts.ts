// SPDX-License-Identifier: MIT
import type { Partition } from 'geodesic-voronoi';
import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshLambertMaterial } from 'three';
import type { LabelColours } from './region_surface.js';
import type { SceneMesh } from './scene_mesh.js';

/** How far, in radii of the model, a part at distance 1 moves at most. */
export const widestSpread = 1;

/** The regions as patches that move apart: each away from the middle of the model. */
export class ExplodedParts {
  readonly object: Mesh<BufferGeometry, MeshLambertMaterial>;
  readonly #together: Float32Array;
  /** Per corner, where its part moves at spread 1. */
  readonly #directions: Float32Array;

  constructor(mesh: SceneMesh, { points, triangles, regions }: Partition, colours: LabelColours) {
    const places = mesh.frame.toScene(points.position);
    const centres = mesh.frame.toScene(regions.centroid);
    const corners = triangles.points.length;
    this.#together = new Float32Array(3 * corners);
    this.#directions = new Float32Array(3 * corners);
    const normals = new Float32Array(3 * corners);
    const colour = new Uint8Array(3 * corners);
    for (let c = 0; c < corners; ++c) {
      const triangle = Math.floor(c / 3);
      const label = triangles.label[triangle];
      const point = triangles.points[c];
      this.#together.set(places.subarray(3 * point, 3 * point + 3), 3 * c);
      if (label >= 0) this.#directions.set(centres.subarray(3 * label, 3 * label + 3), 3 * c);
      mesh.writeNormal(
        triangles.face[triangle],
        triangles.bary.subarray(3 * c, 3 * c + 3),
        normals,
        3 * c,
      );
      colours.write(label, 0, colour, 3 * c);
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(this.#together.slice(), 3));
    geometry.setAttribute('normal', new BufferAttribute(normals, 3));
    geometry.setAttribute('color', new BufferAttribute(colour, 3, true));
    const material = new MeshLambertMaterial({ vertexColors: true, side: DoubleSide });
    this.object = new Mesh(geometry, material);
    this.object.frustumCulled = false;
  }

  /** 0: together, 1: as far apart as they go. */
  spread(share: number): void {
    const position = this.object.geometry.getAttribute('position') as BufferAttribute;
    const factor = widestSpread * share;
    for (let i = 0; i < this.#together.length; ++i)
      position.array[i] = this.#together[i] + factor * this.#directions[i];
    position.needsUpdate = true;
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.object.material.dispose();
  }
}
