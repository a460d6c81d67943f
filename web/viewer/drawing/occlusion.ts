// SPDX-License-Identifier: MIT
//
// Soft shadows in hollows and between parts of a model that come close to each other.

import {
  ClampToEdgeWrapping,
  Data3DTexture,
  LinearFilter,
  type MeshLambertMaterial,
  RGFormat,
  UnsignedByteType,
} from 'three';
import {
  byteOfPlane,
  deviations,
  halfWidth,
  lift,
  resolution,
} from '../buffers/surface_density.js';

export function occlusionTexture(density: Uint8Array): Data3DTexture {
  const texture = new Data3DTexture(
    density as Uint8Array<ArrayBuffer>,
    resolution,
    resolution,
    resolution,
  );
  texture.format = RGFormat;
  texture.type = UnsignedByteType;
  texture.minFilter = LinearFilter;
  texture.magFilter = LinearFilter;
  texture.wrapS = texture.wrapT = texture.wrapR = ClampToEdgeWrapping;
  texture.unpackAlignment = 1;
  texture.needsUpdate = true;
  return texture;
}

/** Darkens a material by the amount of surface nearby, looked up at its vertices' own positions. */
export function occlude(material: MeshLambertMaterial, texture: Data3DTexture): void {
  const before = material.onBeforeCompile;
  material.onBeforeCompile = (shader, renderer) => {
    before.call(material, shader, renderer);
    shader.uniforms.surfaceDensity = { value: texture };
    shader.vertexShader = shader.vertexShader
      .replace('#include <common>', '#include <common>\nvarying vec3 vPlace;')
      .replace('#include <begin_vertex>', '#include <begin_vertex>\nvPlace = position;');
    shader.fragmentShader = shader.fragmentShader
      .replace('#include <common>', `#include <common>\n${openness}`)
      .replace(
        '#include <opaque_fragment>',
        `outgoingLight *= openness(inverseTransformDirection(normal, viewMatrix));
        #include <opaque_fragment>`,
      );
  };
}

/** How open the surface is: 1 on a plane, less in hollows, a little more on ridges. */
const openness = /* glsl */ `
  precision highp sampler3D;
  uniform sampler3D surfaceDensity;
  varying vec3 vPlace;

  vec2 densityAt(vec3 place) {
    return texture(surfaceDensity, place / ${(2 * halfWidth).toFixed(4)} + 0.5).rg;
  }

  float openness(vec3 outward) {
    float narrow = densityAt(vPlace + outward * ${(lift * deviations[0]).toFixed(5)}).r;
    float wide = densityAt(vPlace + outward * ${(lift * deviations[1]).toFixed(5)}).g;
    vec2 excess = vec2(narrow, wide) * ${(255 / byteOfPlane).toFixed(4)} - 1.0;
    vec2 light = 1.0 - vec2(0.16, 0.3) * excess;
    return clamp(light.x * light.y, 0.4, 1.05);
  }
`;
