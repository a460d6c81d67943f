// SPDX-License-Identifier: MIT
//
// The sites as they are drawn: markers as large as their regions have room for, which glide to new
// places.

import { type Camera, type Object3D, Vector3 } from 'three';
import { Glide } from './glide.js';
import { Markers } from './markers.js';
import type { SceneMesh } from '../buffers/scene_mesh.js';
import type { Sites } from '../session/site_history.js';
import type { Theme } from './theme.js';

/** The radius of a site's marker, as a share of that of a disc as large as its region. */
const markerShare = 0.14;

export class SiteDrawing {
  readonly #mesh: SceneMesh;
  readonly #markers = new Markers({ least: 2.5, most: 9 });
  #places = new Float32Array();
  #normals = new Float32Array();
  /** The places at which the markers are seen. */
  readonly #glide = new Glide();
  #front = 0;
  #regionAreas: Float64Array = new Float64Array();
  #selected = -1;

  constructor(mesh: SceneMesh) {
    this.#mesh = mesh;
  }

  get object(): Object3D {
    return this.#markers.object;
  }

  set theme(theme: Theme) {
    this.#markers.theme = theme;
  }

  /** See `Markers`. */
  set front(side: number) {
    this.#front = side;
    this.#markers.front = side;
  }

  /** Sets the sites; their markers glide there in so many milliseconds. */
  set(sites: Sites, selected: number, milliseconds: number): void {
    this.#places = new Float32Array(3 * sites.length);
    this.#normals = new Float32Array(3 * sites.length);
    sites.forEach(({ face, bary }, i) => {
      this.#mesh.writePoint(face, bary, this.#places, 3 * i);
      this.#mesh.writeNormal(face, bary, this.#normals, 3 * i);
    });
    this.#selected = selected;
    this.#glide.to(this.#places, milliseconds, performance.now());
    this.#show();
  }

  /** Marks one of the sites as selected; -1 for none. */
  set selected(index: number) {
    this.#selected = index;
    this.#show();
  }

  /** Draws the sites where they have glided to; returns whether they glide on. */
  glide(): boolean {
    this.#show();
    return !this.#glide.isOver(performance.now());
  }

  /** Per site the area of its region, in the model's unit; empty without regions. */
  set regionAreas(areas: Float64Array) {
    this.#regionAreas = areas;
    this.#markers.usual = this.usualSize || 1; // without regions, nothing is crowded
    this.#show();
  }

  /** The radius of a disc as large as a region of mean area, in the scene; 0 without regions. */
  get usualRadius(): number {
    const areas = this.#regionAreas;
    return this.#radiusOf(areas.reduce((sum, area) => sum + area, 0) / Math.max(1, areas.length));
  }

  /** The marker's size for a region of mean area. */
  get usualSize(): number {
    return markerShare * this.usualRadius;
  }

  /** Whether a site lies on the far side of a closed surface: what is seen of it faces inwards. */
  isTurnedAway(index: number, camera: Camera): boolean {
    const view = new Vector3().setFromMatrixPosition(camera.matrixWorld).sub(this.place(index));
    return this.#front !== 0 && this.seenFrom(index).dot(view) < 0;
  }

  /** The direction from which a site is seen: outwards, also where a closed surface's normals point inwards. */
  seenFrom(index: number): Vector3 {
    return new Vector3().fromArray(this.#normals, 3 * index).multiplyScalar(this.#front || 1);
  }

  place(index: number): Vector3 {
    return new Vector3().fromArray(this.#places, 3 * index);
  }

  dispose(): void {
    this.#markers.dispose();
  }

  /** Sizes markers by their regions; equally while the numbers of sites and regions differ. */
  #show(): void {
    const areas = this.#regionAreas;
    const sizes =
      areas.length === this.#places.length / 3
        ? Float32Array.from(areas, (area) => markerShare * this.#radiusOf(area))
        : this.usualSize;
    const places = this.#glide.at(performance.now());
    this.#markers.set(places, this.#normals, sizes, this.#selected);
  }

  #radiusOf(area: number): number {
    return this.#mesh.frame.scale * Math.sqrt(area / Math.PI);
  }
}
