// SPDX-License-Identifier: MIT
//
// Lines of the scene: bisectors, outlines, paths, the dual's sides, the wireframe.

import type { DiagramData, PolygonMesh } from 'geodesic-voronoi';
import {
  BufferAttribute,
  BufferGeometry,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
  LineBasicMaterial,
  LineSegments,
  Vector3,
} from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { Slices } from '../stage/next_frame.js';
import { type Keys, type Marks, RecordBuffer, wholeScene } from './record_buffer.js';
import type { SceneMesh } from '../buffers/scene_mesh.js';

/** The longest piece of a side laid onto the surface, in radii of the model. */
const longestPiece = 0.02;

/** The width of a line in pixels at an end, as GLSL of LineMaterial: not more than `widest`. */
const limitedWidth = `min(
  linewidth,
  0.5 * widest * resolution.y * projectionMatrix[1][1] / (position.y < 0.5 ? clipStart : clipEnd).w
)`;

/** Whether the surface is seen from behind there, as GLSL of LineMaterial. */
const isFromBehind =
  'front * dot((modelViewMatrix * vec4(instanceNormal, 0.0)).xyz, start.xyz) > 0.0';

/**
 * The polygon offset of a surface with lines on it. Lines are some pixels wide, so on a slope their
 * depth differs by the slope times half their width: that is what the factor adds.
 */
export const behindLines = { polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 2 };

/** The polygon offset of a surface behind another one with lines, in the same place. */
export const behindSurface = { polygonOffset: true, polygonOffsetFactor: 3, polygonOffsetUnits: 4 };

/** The width of a line with its rim, in widths of the line. */
const rimmedWidth = 2;

/** Line segments of a width in CSS pixels, at any zoom. */
export class FatLines {
  readonly object: LineSegments2;
  readonly #segments: RecordBuffer;
  /** Numbers per segment: x, y, z of both ends and, if it has one, of the normal. */
  readonly #size: number;
  readonly #front = { value: 0 };
  readonly #widest = { value: 1e9 };
  /** Wider lines at the same places, drawn before these. */
  #rim: LineSegments2 | undefined;
  readonly #widestRim = { value: 1e9 };

  /**
   * Segments are given by x, y, z of both ends; with normals, also by that of the surface there, in
   * the same array.
   */
  constructor({ width, hasNormals = false }: { width: number; hasNormals?: boolean }) {
    this.#size = hasNormals ? 9 : 6;
    this.#segments = new RecordBuffer((n) => [
      new InstancedInterleavedBuffer(new Float32Array(this.#size * n), this.#size),
    ]);
    const material = lineMaterial(width, { widest: this.#widest, front: this.#front });
    this.object = new LineSegments2(new LineSegmentsGeometry(), material);
    this.object.frustumCulled = false;
    this.object.visible = false;
  }

  /** The greatest width in the scene: far away, lines are thinner than their pixels. */
  set widest(width: number) {
    this.#widest.value = width;
    this.#widestRim.value = rimmedWidth * width;
  }

  /**
   * The side that is seen of the surface, as the sign of its normals; 0 if both may be. Lines where
   * the other side faces the camera are not drawn: the polygon offset of a thin wall would let them
   * show through it.
   */
  set front(side: number) {
    this.#front.value = side;
  }

  /** The colour of a rim, for lines on a surface of any colour; undefined for none. */
  set rim(colour: number | undefined) {
    const { object } = this;
    if (this.#rim) {
      object.remove(this.#rim);
      this.#rim.material.dispose();
      this.#rim = undefined;
    }
    // Drawn after the surface and before the lines; without depth, the lines are drawn over it.
    object.renderOrder = colour === undefined ? 0 : 0.5;
    if (colour === undefined) return;
    const width = rimmedWidth * object.material.linewidth;
    const material = lineMaterial(width, { widest: this.#widestRim, front: this.#front });
    material.color.set(colour);
    material.depthWrite = false;
    this.#rim = new LineSegments2(object.geometry, material);
    this.#rim.frustumCulled = false;
    this.#rim.renderOrder = 0.25;
    object.add(this.#rim);
  }

  set colour(colour: number) {
    this.object.material.color.set(colour);
  }

  get count(): number {
    return this.#segments.count;
  }

  /** Sets the segments. */
  set(segments: Float32Array): void {
    this.#segments.set(new Int32Array((2 * segments.length) / this.#size), [segments]);
    this.#adopt();
  }

  /**
   * Like `set`, but with two keys per segment, by which some can be replaced later. Takes over the arrays;
   * there may be room for more segments than keys.
   */
  adopt(segments: Float32Array, keys: Keys): void {
    const buffer = new InstancedInterleavedBuffer(segments, this.#size);
    this.#segments.adopt(keys, [buffer], segments.length / this.#size);
    this.#adopt();
  }

  /** Replaces the segments that are gone by others. */
  replace(gone: Marks, segments: Float32Array, keys: Keys): void {
    this.#segments.replace(gone, keys, [segments]);
    this.#adopt();
  }

  dispose(): void {
    this.rim = undefined;
    this.object.geometry.dispose();
    this.object.material.dispose();
  }

  #adopt(): void {
    const [buffer] = this.#segments.buffers as readonly InstancedInterleavedBuffer[];
    const start = this.object.geometry.getAttribute('instanceStart');
    if (!(start instanceof InterleavedBufferAttribute) || start.data !== buffer) {
      // A new geometry, since the old one would keep its first buffers.
      this.object.geometry.dispose();
      const geometry = new LineSegmentsGeometry();
      geometry.setAttribute('instanceStart', new InterleavedBufferAttribute(buffer, 3, 0));
      geometry.setAttribute('instanceEnd', new InterleavedBufferAttribute(buffer, 3, 3));
      if (this.#size > 6)
        geometry.setAttribute('instanceNormal', new InterleavedBufferAttribute(buffer, 3, 6));
      geometry.boundingSphere = wholeScene;
      this.object.geometry = geometry;
      if (this.#rim) this.#rim.geometry = geometry;
    }
    this.object.geometry.instanceCount = this.count;
    this.object.visible = this.count > 0;
  }
}

function lineMaterial(
  width: number,
  uniforms: Record<'widest' | 'front', { value: number }>,
): LineMaterial {
  // Only multisampling smooths lines: alpha coverage would let the page shine through the canvas.
  const material = new LineMaterial({ linewidth: width });
  Object.assign(material.uniforms, uniforms);
  material.vertexShader = material.vertexShader
    .replace(
      'uniform float linewidth;',
      'uniform float linewidth, widest, front;\nattribute vec3 instanceNormal;',
    )
    .replace('offset *= linewidth;', `offset *= ${isFromBehind} ? 0.0 : ${limitedWidth};`);
  return material;
}

/** Both ends of every segment of a region's loops, in the scene. */
export function outlineEnds(
  mesh: SceneMesh,
  { points, loops }: Pick<DiagramData, 'points' | 'loops'>,
  label: number,
): Float32Array {
  const chain: number[] = [];
  for (let loop = 0; loop < loops.label.length; ++loop) {
    if (loops.label[loop] !== label) continue;
    const first = loops.offset[loop];
    const end = loops.offset[loop + 1];
    for (let i = first; i < end; ++i) {
      chain.push(loops.points[i], loops.points[i + 1 < end ? i + 1 : first]);
    }
  }
  return mesh.frame.toScene(points.position, chain);
}

/**
 * Both ends of every piece of chains of points, in the scene; chain i is the points from
 * `offset[i]` on.
 */
export function chainEnds(
  mesh: SceneMesh,
  { points, offset }: { points: { position: ArrayLike<number> }; offset: ArrayLike<number> },
): Float32Array {
  const places = mesh.frame.toScene(points.position);
  const ends = new Float32Array(2 * places.length); // more than there are: the last of a chain begins no piece
  let written = 0;
  for (let chain = 0; chain + 1 < offset.length; ++chain) {
    for (let i = offset[chain]; i + 1 < offset[chain + 1]; ++i, written += 6) {
      for (let k = 0; k < 6; ++k) ends[written + k] = places[3 * i + k];
    }
  }
  return ends.subarray(0, written);
}

/**
 * Both ends of every piece of a dual's sides that reach the mesh boundary, in the scene. The pieces
 * are laid onto the surface: straight sides would run below it where it is convex.
 * `nearest` finds the point of the surface.
 */
export async function boundarySides(
  mesh: SceneMesh,
  { points, faces, vertexLabel }: PolygonMesh,
  siteCount: number,
  nearest: (place: Vector3) => Vector3,
): Promise<Float32Array> {
  if (vertexLabel.length === siteCount) return new Float32Array();
  const places = mesh.frame.toScene(points.position);
  const ends: number[] = [];
  const drawn = new Set<number>();
  const from = new Vector3();
  const to = new Vector3();
  const work = new Slices();
  for (let f = 0; f + 1 < faces.offset.length; ++f) {
    if (work.isDue) await work.next();
    const [first, end] = [faces.offset[f], faces.offset[f + 1]];
    for (let i = first; i < end; ++i) {
      const a = faces.points[i];
      const b = faces.points[i + 1 < end ? i + 1 : first];
      const side = Math.min(a, b) * points.face.length + Math.max(a, b);
      if (Math.max(a, b) < siteCount || drawn.has(side)) continue;
      drawn.add(side);
      from.fromArray(places, 3 * a);
      to.fromArray(places, 3 * b);
      const pieces = Math.ceil(from.distanceTo(to) / longestPiece);
      let last = from.clone();
      for (let k = 1; k <= pieces; ++k) {
        const next = nearest(from.clone().lerp(to, k / pieces));
        ends.push(...last, ...next);
        last = next;
      }
    }
  }
  return Float32Array.from(ends);
}

/** The edges of the model's triangles (see `meshEdges`), as thin lines. */
export function wireframe(
  mesh: SceneMesh,
  edges: Uint32Array,
): LineSegments<BufferGeometry, LineBasicMaterial> {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(mesh.positions, 3));
  geometry.setIndex(new BufferAttribute(edges, 1));
  geometry.boundingSphere = wholeScene;
  const material = new LineBasicMaterial({ transparent: true, opacity: 0.28 });
  const lines = new LineSegments(geometry, material);
  lines.frustumCulled = false;
  return lines;
}
