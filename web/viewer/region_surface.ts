// SPDX-License-Identifier: MIT
import type { DiagramData } from 'geodesic-voronoi';
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Group,
  Mesh,
  MeshLambertMaterial,
} from 'three';
import { toneColour } from './region_colours.js';
import type { SceneMesh } from './scene_mesh.js';

/** Faces without a region: those the mesh builder dropped, and all before the first diagram. */
const neutralColour = 0xd9d6d0;
/** Faces that no site reaches. */
const unreachableColour = 0x9a9ca1;
/** Where the painted density is greatest and least. */
const denseColour = 0x4a1942;
const sparseColour = 0xffffff;
const tintOpacity = 0.75;

/** `DiagramData.faceLabel` of a face that several regions share. */
const shared = -2;
const unreachable = -1;

/**
 * The model's surface filled by region. Faces with one owner are drawn whole from arrays made once;
 * only their colours and the list of them change with the diagram. The parts of shared faces are
 * drawn as they were traced: the fill ends exactly where the bisector runs.
 */
export class RegionSurface {
  readonly object = new Group();
  readonly #mesh: SceneMesh;
  readonly #wholeFaces: BufferGeometry;
  readonly #material: MeshLambertMaterial;
  #parts: Mesh<BufferGeometry, MeshLambertMaterial> | undefined;
  #diagram: { data: DiagramData; tones: Uint16Array } | undefined;
  #filled = true;
  #tints: Float32Array | undefined;

  constructor(mesh: SceneMesh) {
    this.#mesh = mesh;
    this.#material = new MeshLambertMaterial({
      vertexColors: true,
      side: DoubleSide,
      // Lines lie in the surface and are some pixels wide: on a slope the depth differs across
      // them by the slope times half their width, which is what the factor pushes back.
      polygonOffset: true,
      polygonOffsetFactor: 2,
      polygonOffsetUnits: 2,
    });
    this.#wholeFaces = wholeFaceGeometry(mesh);
    const faces = new Mesh(this.#wholeFaces, this.#material);
    faces.frustumCulled = false;
    this.object.add(faces);
    this.#update();
  }

  /** Whether the regions are filled; without, the surface is neutral. */
  set filled(filled: boolean) {
    if (filled === this.#filled) return;
    this.#filled = filled;
    this.#update();
  }

  /** `tones` per label. Without a diagram the surface is neutral. */
  setDiagram(diagram: { data: DiagramData; tones: Uint16Array } | undefined): void {
    this.#diagram = diagram;
    this.#update();
  }

  /** A tint per input vertex, -1 … 1, over the colours; undefined for none. */
  set tints(tints: Float32Array | undefined) {
    if (!tints && !this.#tints) return;
    this.#tints = tints;
    this.#update();
  }

  dispose(): void {
    this.#removeParts();
    this.#wholeFaces.dispose();
    this.#material.dispose();
  }

  #update(): void {
    const diagram = this.#filled ? this.#diagram : undefined;
    const colours = new LabelColours(diagram?.tones);
    const colour = this.#wholeFaces.getAttribute('color') as BufferAttribute;
    const index = this.#wholeFaces.index as BufferAttribute;
    let end = 0;
    for (let face = 0; face < this.#mesh.faceCount; ++face) {
      const label = diagram ? diagram.data.faceLabel[face] : undefined;
      if (label === shared) continue;
      for (let corner = 3 * face; corner < 3 * face + 3; ++corner) {
        const tint = this.#tints?.[this.#mesh.indices[corner]];
        colours.write(label, tint, colour.array, 3 * corner);
        index.array[end++] = corner;
      }
    }
    colour.needsUpdate = true;
    index.needsUpdate = true;
    this.#wholeFaces.setDrawRange(0, end);

    this.#removeParts();
    if (diagram && diagram.data.cells.face.length > 0) {
      this.#parts = new Mesh(partGeometry(this.#mesh, diagram.data, colours, this.#tints), this.#material);
      this.#parts.frustumCulled = false;
      this.object.add(this.#parts);
    }
  }

  #removeParts(): void {
    if (!this.#parts) return;
    this.object.remove(this.#parts);
    this.#parts.geometry.dispose();
    this.#parts = undefined;
  }
}

/** Colours as vertex attributes hold them: linear, a byte per channel. */
export class LabelColours {
  readonly #ofTone: Uint8Array[] = [];
  readonly #tones: Uint16Array | undefined;
  readonly #neutral = linearBytes(neutralColour);
  readonly #unreachable = linearBytes(unreachableColour);
  readonly #dense = linearBytes(denseColour);
  readonly #sparse = linearBytes(sparseColour);

  constructor(tones: Uint16Array | undefined) {
    this.#tones = tones;
  }

  write(
    label: number | undefined,
    tint: number | undefined,
    target: { [i: number]: number },
    at: number,
  ): void {
    const bytes = this.#of(label);
    const over = tint && tint < 0 ? this.#sparse : this.#dense;
    const share = tint ? tintOpacity * Math.abs(tint) : 0;
    for (let k = 0; k < 3; ++k) target[at + k] = bytes[k] + share * (over[k] - bytes[k]);
  }

  #of(label: number | undefined): Uint8Array {
    if (label === unreachable) return this.#unreachable;
    if (label === undefined || label < 0 || !this.#tones) return this.#neutral;
    const tone = this.#tones[label];
    return (this.#ofTone[tone] ??= linearBytes(toneColour(tone)));
  }
}

function linearBytes(srgb: number): Uint8Array {
  const { r, g, b } = new Color(srgb);
  return Uint8Array.of(Math.round(255 * r), Math.round(255 * g), Math.round(255 * b));
}

function wholeFaceGeometry(mesh: SceneMesh): BufferGeometry {
  const { positions, indices } = mesh;
  const corners = new Float32Array(3 * indices.length);
  for (let corner = 0; corner < indices.length; ++corner) {
    for (let axis = 0; axis < 3; ++axis) {
      corners[3 * corner + axis] = positions[3 * indices[corner] + axis];
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(corners, 3));
  geometry.setAttribute('normal', new BufferAttribute(mesh.normals, 3));
  geometry.setAttribute('color', new BufferAttribute(new Uint8Array(3 * indices.length), 3, true));
  geometry.setIndex(new BufferAttribute(new Uint32Array(indices.length), 1));
  return geometry;
}

/** The parts of shared faces as triangle fans; they are convex. */
function partGeometry(
  mesh: SceneMesh,
  data: DiagramData,
  colours: LabelColours,
  tints: Float32Array | undefined,
): BufferGeometry {
  const { cells, points } = data;
  const places = mesh.frame.toScene(points.position);
  const corners = cells.points.length;
  const position = new Float32Array(3 * corners);
  const normal = new Float32Array(3 * corners);
  const colour = new Uint8Array(3 * corners);
  const triangles: number[] = [];
  for (let cell = 0; cell < cells.face.length; ++cell) {
    const face = cells.face[cell];
    const first = cells.offset[cell];
    const end = cells.offset[cell + 1];
    const barys: number[][] = [];
    for (let i = first; i < end; ++i) {
      const place = places.subarray(3 * cells.points[i], 3 * cells.points[i] + 3);
      position.set(place, 3 * i);
      // A point names one of the faces it lies on, which need not be this one.
      const bary = mesh.barycentric(face, place[0], place[1], place[2]);
      barys.push(bary);
      mesh.writeNormal(face, bary, normal, 3 * i);
      const tint = tints && mesh.interpolate(face, bary, tints);
      colours.write(cells.label[cell], tint, colour, 3 * i);
    }
    const turned = isClockwise(barys);
    for (let i = first + 2; i < end; ++i) triangles.push(first, ...(turned ? [i, i - 1] : [i - 1, i]));
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(position, 3));
  geometry.setAttribute('normal', new BufferAttribute(normal, 3));
  geometry.setAttribute('color', new BufferAttribute(colour, 3, true));
  geometry.setIndex(triangles);
  return geometry;
}

/**
 * Whether a polygon in a face winds against the face, as the parts do of a triangle that the mesh
 * builder turned over. Its normals are those of the input's triangle.
 */
function isClockwise(barys: readonly (readonly number[])[]): boolean {
  let doubleArea = 0;
  let last = barys[barys.length - 1];
  for (const bary of barys) {
    doubleArea += last[1] * bary[2] - bary[1] * last[2];
    last = bary;
  }
  return doubleArea < 0;
}
