// SPDX-License-Identifier: MIT
//
// The surface coloured by the distance to the nearest site, with isolines.

import {
  BufferAttribute,
  BufferGeometry,
  type Data3DTexture,
  DoubleSide,
  Group,
  Mesh,
  MeshLambertMaterial,
} from 'three';
import { type DistanceScale, distanceColours } from './distance_scale.js';
import type { DistanceTriangles } from '../buffers/distance_triangles.js';
import { behindLines, behindSurface } from './lines.js';
import { occlude } from './occlusion.js';
import { wholeScene } from './record_buffer.js';
import type { SceneMesh } from '../buffers/scene_mesh.js';

/** The distance at every point of the surface, and what the colours for it mean. */
export interface DrawnDistances {
  triangles: DistanceTriangles;
  /** In the model's units. */
  scale: DistanceScale;
}

export class DistanceSurface {
  readonly object = new Group();
  readonly #uniforms = { longest: { value: 1 }, isolineStep: { value: 1 } };

  constructor(mesh: SceneMesh, { triangles, scale }: DrawnDistances, occlusion: Data3DTexture) {
    const { faceReach, position, normal, reach } = triangles;
    this.#uniforms.longest.value = mesh.frame.scale * scale.longest;
    this.#uniforms.isolineStep.value = mesh.frame.scale * scale.step;
    const faces = geometryOf(mesh.cornerPositions, mesh.normals, faceReach);
    this.#add(faces, behindSurface, occlusion);
    this.#add(geometryOf(position, normal, reach), behindLines, occlusion);
  }

  dispose(): void {
    for (const { geometry, material } of this.object.children as Mesh<
      BufferGeometry,
      MeshLambertMaterial
    >[]) {
      geometry.dispose();
      material.dispose();
    }
  }

  #add(geometry: BufferGeometry, offset: typeof behindLines, occlusion: Data3DTexture): void {
    const material = new MeshLambertMaterial({ side: DoubleSide, ...offset });
    material.onBeforeCompile = (shader) => {
      Object.assign(shader.uniforms, this.#uniforms);
      shader.vertexShader = shader.vertexShader
        .replace(
          '#include <common>',
          '#include <common>\nattribute float reach;\nvarying float vReach;',
        )
        .replace('#include <begin_vertex>', '#include <begin_vertex>\nvReach = reach;');
      shader.fragmentShader = shader.fragmentShader
        .replace('#include <common>', `#include <common>\n${colouring}`)
        .replace('#include <color_fragment>', 'diffuseColor.rgb = distanceColour();');
    };
    // As in `ExplodedParts`: for three.js, `occlude` makes all programs the same.
    material.customProgramCacheKey = () => 'distances';
    occlude(material, occlusion);
    const surface = new Mesh(geometry, material);
    surface.frustumCulled = false;
    this.object.add(surface);
  }
}

function geometryOf(
  position: Float32Array,
  normal: Float32Array,
  reach: Float32Array,
): BufferGeometry {
  const geometry = new BufferGeometry()
    .setAttribute('position', new BufferAttribute(position, 3))
    .setAttribute('normal', new BufferAttribute(normal, 3))
    .setAttribute('reach', new BufferAttribute(reach, 1));
  geometry.boundingSphere = wholeScene;
  return geometry;
}

/**
 * Reads the distance (see `DistanceTriangles`) and tells its colour; an isoline is two pixels wide.
 */
const colouring = /* glsl */ `
  uniform float longest;
  uniform float isolineStep;
  varying float vReach;

  vec3 toLinear(vec3 srgb) {
    return mix(srgb / 12.92, pow((srgb + 0.055) / 1.055, vec3(2.4)), step(0.04045, srgb));
  }

  vec3 scaleColour(float share) {
    const vec3 stops[${distanceColours.length}] = vec3[](${distanceColours.map(glslColour).join(', ')});
    float place = clamp(share, 0.0, 1.0) * ${distanceColours.length - 1}.0;
    int i = min(int(place), ${distanceColours.length - 2});
    return toLinear(mix(stops[i], stops[i + 1], place - float(i)));
  }

  vec3 distanceColour() {
    if (vReach > 1e5) return vec3(0.35);
    float distance = sqrt(max(vReach + dot(vPlace, vPlace), 0.0));
    float steps = distance / isolineStep;
    float fromIsoline = abs(fract(steps + 0.5) - 0.5) / max(fwidth(steps), 1e-6);
    float line = distance < 0.5 * isolineStep ? 0.0 : 1.0 - smoothstep(0.5, 1.5, fromIsoline);
    vec3 colour = scaleColour(distance / longest);
    float brightness = dot(colour, vec3(0.3, 0.6, 0.1));
    return mix(colour, vec3(brightness > 0.2 ? 0.02 : 0.75), 0.65 * line);
  }
`;

function glslColour(colour: string): string {
  const channels = [1, 3, 5].map((at) => (parseInt(colour.slice(at, at + 2), 16) / 255).toFixed(4));
  return `vec3(${channels.join(', ')})`;
}
