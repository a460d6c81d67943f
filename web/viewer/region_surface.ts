// SPDX-License-Identifier: MIT
import type { DiagramChange, DiagramData } from 'geodesic-voronoi';
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Group,
  Mesh,
  MeshLambertMaterial,
} from 'three';
import { RecordBuffer, uploadAll, uploadRecords, wholeScene } from './record_buffer.js';
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

/** `DiagramData.faceLabel` of a face that several regions share; others below zero have no region. */
const shared = -2;
const unreachable = -1;
const dropped = -3;

/** A diagram to be drawn, with a tone per label; `data` is read only to draw all of it. */
export interface TonedDiagram {
  readonly data: DiagramData;
  tones: Uint16Array;
}

/**
 * The model's surface filled by region. Faces with one owner are drawn whole from arrays made once;
 * only their colours change with the diagram, and in the list of corners shared faces are without
 * extent. Their parts are drawn as they were traced: the fill ends exactly where the bisector runs.
 */
export class RegionSurface {
  readonly object = new Group();
  readonly #mesh: SceneMesh;
  readonly #wholeFaces: BufferGeometry;
  readonly #colour: BufferAttribute;
  readonly #corners: BufferAttribute;
  readonly #material: MeshLambertMaterial;
  readonly #parts: Mesh<BufferGeometry, MeshLambertMaterial>;
  /** Triangles of the parts: per corner place, normal and colour. */
  readonly #triangles = new RecordBuffer<PartTriangle>((n) => [
    new BufferAttribute(new Float32Array(9 * n), 3),
    new BufferAttribute(new Float32Array(9 * n), 3),
    new BufferAttribute(new Uint8Array(9 * n), 3, true),
  ]);
  #diagram: TonedDiagram | undefined;
  /** As `DiagramData.faceLabel`; without a diagram all are as if dropped. */
  readonly #faceLabels: Int32Array;
  #filled = true;
  #tints: Float32Array | undefined;

  constructor(mesh: SceneMesh) {
    this.#mesh = mesh;
    this.#faceLabels = new Int32Array(mesh.faceCount);
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
    this.#colour = this.#wholeFaces.getAttribute('color') as BufferAttribute;
    this.#corners = this.#wholeFaces.index as BufferAttribute;
    const faces = new Mesh(this.#wholeFaces, this.#material);
    faces.frustumCulled = false;
    this.#parts = new Mesh(new BufferGeometry(), this.#material);
    this.#parts.frustumCulled = false;
    this.object.add(faces, this.#parts);
    this.#update();
  }

  /** Whether the regions are filled; without, the surface is neutral. */
  set filled(filled: boolean) {
    if (filled === this.#filled) return;
    this.#filled = filled;
    this.#update();
  }

  /** Without a diagram the surface is neutral. */
  setDiagram(diagram: TonedDiagram | undefined): void {
    this.#diagram = diagram;
    this.#update();
  }

  /** What the diagram has become by a change. */
  changeDiagram({ faces, part }: DiagramChange, diagram: TonedDiagram): void {
    const before = this.#diagram?.tones;
    this.#diagram = diagram;
    if (!this.#filled) return;
    const colours = new LabelColours(diagram.tones);
    const isChanged = new Uint8Array(this.#mesh.faceCount);
    for (const face of faces) isChanged[face] = 1;
    faces.forEach((face, i) => this.#writeFace(face, part.faceLabel[i], colours));
    uploadRecords(this.#corners, faces, 3);
    uploadRecords(this.#colour, faces, 9);
    this.#replaceParts(({ face }) => isChanged[face] > 0, part, colours);
    const recoloured = diagram.tones.map((tone, label) => (tone === before?.[label] ? 0 : 1));
    if (recoloured.includes(1)) this.#recolour(recoloured, colours);
  }

  /** A tint per input vertex, -1 … 1, over the colours; undefined for none. */
  set tints(tints: Float32Array | undefined) {
    if (!tints && !this.#tints) return;
    this.#tints = tints;
    this.#update();
  }

  dispose(): void {
    this.#parts.geometry.dispose();
    this.#wholeFaces.dispose();
    this.#material.dispose();
  }

  #update(): void {
    const diagram = this.#filled ? this.#diagram : undefined;
    const data = diagram?.data;
    const colours = new LabelColours(diagram?.tones);
    for (let face = 0; face < this.#mesh.faceCount; ++face) {
      this.#writeFace(face, data ? data.faceLabel[face] : dropped, colours);
    }
    uploadAll(this.#colour);
    uploadAll(this.#corners);
    this.#replaceParts(undefined, data, colours);
  }

  /** What has not changed of regions that have another colour; they are marked by label. */
  #recolour(recoloured: ArrayLike<number>, colours: LabelColours): void {
    const faces: number[] = [];
    this.#faceLabels.forEach((label, face) => {
      if (!recoloured[label]) return;
      this.#writeFace(face, label, colours);
      faces.push(face);
    });
    uploadRecords(this.#colour, faces, 9);
    this.#triangles.rewrite(
      ({ label }) => recoloured[label] > 0,
      2,
      ({ label, tints }, target, at) => {
        for (let k = 0; k < 3; ++k) colours.write(label, tints?.[k], target, at + 3 * k);
      },
    );
  }

  #writeFace(face: number, label: number, colours: LabelColours): void {
    this.#faceLabels[face] = label;
    const colour = this.#colour.array;
    const corners = this.#corners.array;
    for (let corner = 3 * face; corner < 3 * face + 3; ++corner) {
      const tint = this.#tints?.[this.#mesh.indices[corner]];
      colours.write(label, tint, colour, 3 * corner);
      corners[corner] = label === shared ? 3 * face : corner;
    }
  }

  /** Others instead of those that are gone; of all if that is not given. */
  #replaceParts(
    isGone: ((triangle: PartTriangle) => boolean) | undefined,
    part: Cells | undefined,
    colours: LabelColours,
  ): void {
    const { triangles, numbers } = partTriangles(this.#mesh, part, colours, this.#tints);
    if (isGone) this.#triangles.replace(isGone, triangles, numbers);
    else this.#triangles.set(triangles, numbers);
    const [position, normal, colour] = this.#triangles.buffers as readonly BufferAttribute[];
    if (this.#parts.geometry.getAttribute('position') !== position) {
      // Disposing of the old one frees its buffers on the graphics card.
      this.#parts.geometry.dispose();
      this.#parts.geometry = new BufferGeometry();
      this.#parts.geometry.setAttribute('position', position);
      this.#parts.geometry.setAttribute('normal', normal);
      this.#parts.geometry.setAttribute('color', colour);
      this.#parts.geometry.boundingSphere = wholeScene;
    }
    this.#parts.geometry.setDrawRange(0, 3 * this.#triangles.count);
    this.#parts.visible = this.#triangles.count > 0;
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
    label: number,
    tint: number | undefined,
    target: { [i: number]: number },
    at: number,
  ): void {
    const bytes = this.#of(label);
    const over = tint && tint < 0 ? this.#sparse : this.#dense;
    const share = tint ? tintOpacity * Math.abs(tint) : 0;
    for (let k = 0; k < 3; ++k) target[at + k] = bytes[k] + share * (over[k] - bytes[k]);
  }

  #of(label: number): Uint8Array {
    if (label === unreachable) return this.#unreachable;
    if (label < 0 || !this.#tones) return this.#neutral;
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

type Cells = Pick<DiagramData, 'cells' | 'points'>;

/** A triangle of a part of a shared face, with the tints of its corners if there are any. */
interface PartTriangle {
  face: number;
  label: number;
  tints: readonly number[] | undefined;
}

/** The parts of shared faces as triangle fans; they are convex. With place, normal and colour per corner. */
function partTriangles(
  mesh: SceneMesh,
  part: Cells | undefined,
  colours: LabelColours,
  tints: Float32Array | undefined,
): { triangles: PartTriangle[]; numbers: readonly ArrayLike<number>[] } {
  if (!part) return { triangles: [], numbers: [[], [], []] };
  const { cells, points } = part;
  const places = mesh.frame.toScene(points.position);
  const cornerCount = cells.points.length;
  const position = new Float32Array(3 * cornerCount);
  const normal = new Float32Array(3 * cornerCount);
  const colour = new Uint8Array(3 * cornerCount);
  const tintOf = new Float32Array(cornerCount);
  const triangles: PartTriangle[] = [];
  const corners: number[] = [];
  for (let cell = 0; cell < cells.face.length; ++cell) {
    const face = cells.face[cell];
    const label = cells.label[cell];
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
      if (tints) tintOf[i] = mesh.interpolate(face, bary, tints);
      colours.write(label, tintOf[i], colour, 3 * i);
    }
    const turned = isClockwise(barys);
    for (let i = first + 2; i < end; ++i) {
      const second = turned ? i : i - 1;
      const third = turned ? i - 1 : i;
      corners.push(first, second, third);
      const tintsOfCorners = tints && [tintOf[first], tintOf[second], tintOf[third]];
      triangles.push({ face, label, tints: tintsOfCorners });
    }
  }
  const count = 3 * corners.length;
  return {
    triangles,
    numbers: [
      gathered(position, corners, new Float32Array(count)),
      gathered(normal, corners, new Float32Array(count)),
      gathered(colour, corners, new Uint8Array(count)),
    ],
  };
}

/** The number triples with these indices, in `result`. */
function gathered<Numbers extends Float32Array | Uint8Array>(
  triples: Numbers,
  indices: readonly number[],
  result: Numbers,
): Numbers {
  for (let i = 0; i < indices.length; ++i) {
    const from = 3 * indices[i];
    result[3 * i] = triples[from];
    result[3 * i + 1] = triples[from + 1];
    result[3 * i + 2] = triples[from + 2];
  }
  return result;
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
