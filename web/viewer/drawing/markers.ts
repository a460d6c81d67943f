// SPDX-License-Identifier: MIT
//
// Sites and Voronoi points, as discs that lie on the surface.

import {
  BufferAttribute,
  Color,
  DoubleSide,
  GreaterDepth,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  Mesh,
  ShaderMaterial,
  Vector2,
} from 'three';
import { RecordBuffer, wholeScene } from './record_buffer.js';
import type { Theme } from './theme.js';

/** The rim's share of the radius. */
const rimShare = 0.3;

/** On the screen, the least radius of a marker is at most this many times that of a usual one. */
const crowding = 2.2;

/** Emphasised markers are this much larger. */
const emphasisedSize = 1.35;

/**
 * Discs in the tangent plane: narrow when seen from the side, and vanishing with the surface at the
 * silhouette. They are lifted towards the camera so that hollows do not cut into them; less when
 * seen from the side, so that no marker shows from behind the silhouette.
 *
 * Of the emphasised marker, what the surface hides is drawn once more, faintly (HIDDEN).
 */
const vertexShader = /* glsl */ `
  attribute vec3 place;
  attribute vec3 outward;
  attribute float size;
  attribute float emphasised;
  uniform float least;
  uniform float most;
  uniform float usual;
  uniform float front;
  uniform float pixelsPerUnitAtOne;
  varying vec2 vCorner;
  varying float vPixels;
  varying float vEmphasised;

  void main() {
    vec3 centre = (modelViewMatrix * vec4(place, 1.0)).xyz;
    vec3 normal = normalize(normalMatrix * outward);
    vec3 view = -normalize(centre);
    float facing = dot(normal, view);
    float slope = front == 0.0 ? abs(facing) : max(0.0, front * facing);
    #ifdef HIDDEN
      slope = emphasised * abs(facing);
    #endif
    float pixelsPerUnit = pixelsPerUnitAtOne / -centre.z;
    float lowest = min(least, ${crowding.toFixed(1)} * usual * pixelsPerUnit);
    float pixels = clamp(size * pixelsPerUnit, lowest, most) * mix(1.0, ${emphasisedSize}, emphasised);
    // Hides the slivers that are left of discs at the silhouette, and discs on the back.
    pixels *= smoothstep(0.02, 0.15, slope);
    // A pixel more, for a smooth edge.
    float radius = (pixels + 1.0) / pixelsPerUnit;
    vec3 axis = abs(normal.x) < 0.9 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
    vec3 first = normalize(cross(normal, axis));
    vec3 corner = centre + radius * (position.x * first + position.y * cross(normal, first));
    corner *= 1.0 - 0.7 * radius * slope / length(centre);
    gl_Position = projectionMatrix * vec4(corner, 1.0);
    vCorner = position.xy * (pixels + 1.0);
    vPixels = pixels;
    vEmphasised = emphasised;
  }
`;

const fragmentShader = /* glsl */ `
  uniform vec3 fill;
  uniform vec3 edge;
  uniform vec3 emphasis;
  varying vec2 vCorner;
  varying float vPixels;
  varying float vEmphasised;

  void main() {
    float distance = length(vCorner);
    // The width of a pixel of the screen, which is wide where the disc is seen from the side.
    float pixel = max(fwidth(distance), 1e-4);
    float opacity = vPixels > 0.0 ? clamp((vPixels - distance) / pixel + 0.5, 0.0, 1.0) : 0.0;
    if (opacity <= 0.0) discard;
    float inner = vPixels * (1.0 - ${rimShare});
    float core = clamp((inner - distance) / pixel + 0.5, 0.0, 1.0);
    #ifdef HIDDEN
      opacity *= 0.4;
    #endif
    gl_FragColor = vec4(mix(edge, mix(fill, emphasis, vEmphasised), core), opacity);
    #include <colorspace_fragment>
  }
`;

export class Markers {
  readonly object: Mesh<InstancedBufferGeometry, ShaderMaterial>;
  /** The emphasised marker where the surface hides it. */
  readonly #hidden: Mesh<InstancedBufferGeometry, ShaderMaterial>;
  /** Place, outward direction, size, and 1 if emphasised. */
  readonly #markers = new RecordBuffer((n) => [
    new InstancedBufferAttribute(new Float32Array(3 * n), 3),
    new InstancedBufferAttribute(new Float32Array(3 * n), 3),
    new InstancedBufferAttribute(new Float32Array(n), 1),
    new InstancedBufferAttribute(new Float32Array(n), 1),
  ]);

  /** Takes the least radius, less where regions are small on the screen, and the greatest, in CSS pixels. */
  constructor({ least, most }: { least: number; most: number }) {
    const parameters = {
      vertexShader,
      fragmentShader,
      transparent: true,
      depthWrite: false,
      side: DoubleSide,
      uniforms: {
        least: { value: least },
        most: { value: most },
        usual: { value: 1 },
        front: { value: 0 },
        fill: { value: new Color() },
        edge: { value: new Color() },
        emphasis: { value: new Color() },
        pixelsPerUnitAtOne: { value: 1000 },
      },
    };
    const material = new ShaderMaterial(parameters);
    // With the same uniforms.
    const hidden = { ...parameters, defines: { HIDDEN: '' }, depthFunc: GreaterDepth };
    this.object = new Mesh(new InstancedBufferGeometry(), material);
    this.#hidden = new Mesh(this.object.geometry, new ShaderMaterial(hidden));
    this.object.add(this.#hidden);
    for (const each of [this.object, this.#hidden]) {
      each.frustumCulled = false;
      // After lines, which are drawn as if opaque.
      each.renderOrder = 1;
    }
    const size = new Vector2();
    this.object.onBeforeRender = (renderer, _scene, camera) => {
      renderer.getSize(size);
      // projectionMatrix[1][1] is 1 / tan(half the field of view).
      material.uniforms.pixelsPerUnitAtOne.value =
        0.5 * size.y * camera.projectionMatrix.elements[5];
      material.uniformsNeedUpdate = true;
    };
  }

  set theme({ ink, paper, accent }: Theme) {
    const { uniforms } = this.object.material;
    uniforms.fill.value.set(ink);
    uniforms.edge.value.set(paper);
    uniforms.emphasis.value.set(accent);
  }

  /**
   * From which side markers are seen: 1 or -1, the side that their outward directions point to or the other,
   * of a closed surface; 0: from both. On the far side of a thin wall they would be lifted through it.
   */
  set front(side: number) {
    this.object.material.uniforms.front.value = side;
  }

  /** The radius in the scene of a marker in a region of usual size. */
  set usual(radius: number) {
    this.object.material.uniforms.usual.value = radius;
  }

  /**
   * Places and outward directions in the scene, radii in it (one for all, or for each), and which
   * of them is emphasised, if any.
   */
  set(
    places: Float32Array,
    outward: Float32Array,
    sizes: number | Float32Array,
    emphasised = -1,
  ): void {
    const count = places.length / 3;
    const flags = new Float32Array(count);
    if (emphasised >= 0 && emphasised < count) flags[emphasised] = 1;
    this.#hidden.visible = emphasised >= 0;
    const each = typeof sizes === 'number' ? new Float32Array(count).fill(sizes) : sizes;
    this.#markers.set(new Int32Array(2 * count), [places, outward, each, flags]);
    this.#adopt();
  }

  dispose(): void {
    this.object.geometry.dispose();
    for (const { material } of [this.object, this.#hidden]) material.dispose();
  }

  #adopt(): void {
    const [place, outward, size, emphasised] = this.#markers
      .buffers as readonly InstancedBufferAttribute[];
    if (this.object.geometry.getAttribute('place') !== place) {
      this.object.geometry.dispose();
      const geometry = new InstancedBufferGeometry();
      const square = Float32Array.of(-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0);
      geometry.setAttribute('position', new BufferAttribute(square, 3));
      geometry.setIndex([0, 1, 2, 0, 2, 3]);
      geometry.setAttribute('place', place);
      geometry.setAttribute('outward', outward);
      geometry.setAttribute('size', size);
      geometry.setAttribute('emphasised', emphasised);
      geometry.boundingSphere = wholeScene;
      this.object.geometry = this.#hidden.geometry = geometry;
    }
    this.object.geometry.instanceCount = this.#markers.count;
  }
}
