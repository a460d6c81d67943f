// SPDX-License-Identifier: MIT
import { BufferAttribute, BufferGeometry, Color, Points, ShaderMaterial, Vector2 } from 'three';
import { RecordBuffer, wholeScene } from './record_buffer.js';

/** A disc's sizes in CSS pixels and its colours. */
export interface MarkerStyle {
  diameter: number;
  ring: number;
  fill: number;
  edge: number;
  /** The fill of emphasised markers, which are also larger. */
  emphasis: number;
}

/**
 * Discs of constant size on screen. They are lifted off the surface towards the camera by their own
 * radius, so that the surface they stand on does not cut into them but whatever is before it hides them.
 */
const vertexShader = /* glsl */ `
  attribute float emphasised;
  uniform float diameter;
  uniform float pixelRatio;
  uniform float pixelsPerUnitAtOne;
  varying float vEmphasised;
  varying float vPixels;

  void main() {
    float size = diameter * mix(1.0, 1.4, emphasised);
    vec4 place = modelViewMatrix * vec4(position, 1.0);
    place.xyz *= 1.0 - 0.5 * size / pixelsPerUnitAtOne;
    gl_Position = projectionMatrix * place;
    gl_PointSize = size * pixelRatio;
    vEmphasised = emphasised;
    vPixels = size * pixelRatio;
  }
`;

const fragmentShader = /* glsl */ `
  uniform vec3 fill;
  uniform vec3 edge;
  uniform vec3 emphasis;
  uniform float ring;
  uniform float pixelRatio;
  varying float vEmphasised;
  varying float vPixels;

  void main() {
    float radius = 0.5 * vPixels;
    float inside = radius - length(gl_PointCoord - 0.5) * vPixels;
    float opacity = smoothstep(0.0, 1.5, inside);
    if (opacity <= 0.0) discard;
    float core = smoothstep(-0.75, 0.75, inside - ring * pixelRatio);
    gl_FragColor = vec4(mix(edge, mix(fill, emphasis, vEmphasised), core), opacity);
    #include <colorspace_fragment>
  }
`;

export class Markers {
  readonly object: Points<BufferGeometry, ShaderMaterial>;
  /** Place, and 1 if emphasised. */
  readonly #markers = new RecordBuffer((n) => [
    new BufferAttribute(new Float32Array(3 * n), 3),
    new BufferAttribute(new Float32Array(n), 1),
  ]);

  constructor({ diameter, ring, fill, edge, emphasis }: MarkerStyle) {
    const material = new ShaderMaterial({
      vertexShader,
      fragmentShader,
      transparent: true,
      depthWrite: false,
      uniforms: {
        diameter: { value: diameter },
        ring: { value: ring },
        fill: { value: new Color(fill) },
        edge: { value: new Color(edge) },
        emphasis: { value: new Color(emphasis) },
        pixelRatio: { value: 1 },
        pixelsPerUnitAtOne: { value: 1000 },
      },
    });
    this.object = new Points(new BufferGeometry(), material);
    this.object.frustumCulled = false;
    // After lines, which are drawn as if opaque.
    this.object.renderOrder = 1;
    const size = new Vector2();
    this.object.onBeforeRender = (renderer, _scene, camera) => {
      renderer.getSize(size);
      const { uniforms } = material;
      uniforms.pixelRatio.value = renderer.getPixelRatio();
      // projectionMatrix[1][1] is 1 / tan(half the field of view).
      uniforms.pixelsPerUnitAtOne.value = 0.5 * size.y * camera.projectionMatrix.elements[5];
      material.uniformsNeedUpdate = true;
    };
  }

  /** Places in the scene, and which of them is emphasised, if any. */
  set(places: Float32Array, emphasised = -1): void {
    const count = places.length / 3;
    const flags = new Float32Array(count);
    if (emphasised >= 0 && emphasised < count) flags[emphasised] = 1;
    this.#markers.set(new Int32Array(2 * count), [places, flags]);
    this.#adopt();
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.object.material.dispose();
  }

  #adopt(): void {
    const [position, emphasised] = this.#markers.buffers as readonly BufferAttribute[];
    if (this.object.geometry.getAttribute('position') !== position) {
      this.object.geometry.dispose();
      this.object.geometry = new BufferGeometry();
      this.object.geometry.setAttribute('position', position);
      this.object.geometry.setAttribute('emphasised', emphasised);
      this.object.geometry.boundingSphere = wholeScene;
    }
    this.object.geometry.setDrawRange(0, this.#markers.count);
  }
}
