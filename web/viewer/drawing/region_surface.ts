// SPDX-License-Identifier: MIT
//
// The surface of a model in the colours of its regions.

import type { Diagram, DiagramChange } from 'geodesic-voronoi';
import {
  BufferAttribute,
  BufferGeometry,
  type Data3DTexture,
  DoubleSide,
  Group,
  Mesh,
  MeshLambertMaterial,
} from 'three';
import { type Cells, type CellTriangles, cellTriangles } from '../buffers/cell_triangles.js';
import { dropped, mixed } from '../buffers/face_label.js';
import { LabelColours } from '../buffers/label_colours.js';
import { behindLines, behindSurface } from './lines.js';
import { occlude } from './occlusion.js';
import {
  type Marks,
  noMarks,
  RecordBuffer,
  uploadAll,
  uploadRecords,
  wholeScene,
} from './record_buffer.js';
import type { SceneMesh } from '../buffers/scene_mesh.js';

/** The share of all faces above which changed faces count as many. */
const manyShare = 1 / 16;

const noCells: CellTriangles = {
  keys: new Int32Array(),
  position: new Float32Array(),
  normal: new Float32Array(),
  points: new Int32Array(),
};

/** A diagram whose `data` are read only to draw all of it: after changes they are put together then. */
export type DiagramSource = Pick<Diagram, 'data'>;

/**
 * The model's surface filled by region. Faces are drawn from arrays made once; only their colours
 * change with the diagram. The cells of mixed faces are drawn in front of these faces as they were
 * traced: the fill ends exactly where the bisector runs. Behind them, each corner of a mixed face
 * has the colour of its region. With `detail`, a cell may have a corner on a side where the face
 * beyond has none; the face behind fills the gaps of a pixel there.
 */
export class RegionSurface {
  readonly object = new Group();
  readonly #mesh: SceneMesh;
  readonly #wholeFaces: BufferGeometry;
  readonly #colour: BufferAttribute;
  readonly #materials: readonly MeshLambertMaterial[];
  readonly #cells: Mesh<BufferGeometry, MeshLambertMaterial>;
  /** Triangles of the cells: per corner place, normal and colour; their keys are face and label. */
  readonly #cellTriangles = new RecordBuffer((n) =>
    cornerBuffers(new Float32Array(9 * n), new Float32Array(9 * n), new Uint8Array(9 * n)),
  );
  #diagram: DiagramSource | undefined;
  /** Per label. */
  #tones: Uint16Array = new Uint16Array();
  /** The drawn `DiagramData.faceLabel`; without a diagram, all faces count as dropped. */
  readonly #faceLabels: Int32Array;
  /** Working memory, with room for all faces. */
  readonly #changedFaces: Int32Array;
  #filled = true;
  #tints: Float32Array | undefined;

  constructor(mesh: SceneMesh, occlusion: Data3DTexture) {
    this.#mesh = mesh;
    this.#faceLabels = new Int32Array(mesh.faceCount).fill(dropped);
    this.#changedFaces = new Int32Array(mesh.faceCount);
    this.#materials = [behindSurface, behindLines].map((offset) => {
      const material = new MeshLambertMaterial({ vertexColors: true, side: DoubleSide, ...offset });
      occlude(material, occlusion);
      return material;
    });
    this.#wholeFaces = wholeFaceGeometry(mesh);
    this.#colour = this.#wholeFaces.getAttribute('color') as BufferAttribute;
    const faces = new Mesh(this.#wholeFaces, this.#materials[0]);
    faces.frustumCulled = false;
    this.#cells = new Mesh(new BufferGeometry(), this.#materials[1]);
    this.#cells.frustumCulled = false;
    this.object.add(faces, this.#cells);
    this.#drawAll();
  }

  /** The factor that colours are multiplied by. */
  set shade(shade: number) {
    for (const { color } of this.#materials) color.setScalar(shade);
  }

  /** Whether regions are filled with their colours; otherwise the surface is neutral. */
  set filled(filled: boolean) {
    if (filled === this.#filled) return;
    this.#filled = filled;
    this.#drawAll();
  }

  /**
   * Without a diagram the surface is neutral. Of the faces, those that have not changed stay as
   * they are, but for mixed ones, whose cells may be others; `cells` are the diagram's if they have
   * been cut already.
   */
  setDiagram(diagram: DiagramSource | undefined, tones: Uint16Array, cells?: CellTriangles): void {
    const before = this.#tones;
    this.#diagram = diagram;
    this.#tones = tones;
    if (!this.#filled) return;
    const faceLabel = diagram?.data.faceLabel;
    const isRecoloured = recoloured(before, tones);
    const drawn = this.#faceLabels;
    const changed = this.#changedFaces;
    const colours = new LabelColours(tones);
    let count = 0;
    // Runs for every face in every iteration of a tessellation: nothing is allocated per face.
    for (let face = 0; face < drawn.length; ++face) {
      const label = faceLabel ? faceLabel[face] : dropped;
      if (label === drawn[face] && label !== mixed && !(label >= 0 && isRecoloured[label]))
        continue;
      this.#writeFace(face, label, colours);
      changed[count++] = face;
    }
    this.#replaceCells(undefined, cells ?? this.#cut(diagram?.data), colours);
    this.#uploadFaces(changed.subarray(0, count));
  }

  /** Draws what a change made different. */
  changeDiagram({ faces, part }: DiagramChange, diagram: DiagramSource, tones: Uint16Array): void {
    const before = this.#tones;
    this.#diagram = diagram;
    this.#tones = tones;
    if (!this.#filled) return;
    const colours = new LabelColours(tones);
    const isChanged = new Uint8Array(this.#mesh.faceCount);
    for (let i = 0; i < faces.length; ++i) {
      isChanged[faces[i]] = 1;
      this.#writeFace(faces[i], part.faceLabel[i], colours);
    }
    this.#replaceCells({ first: isChanged }, this.#cut(part), colours);
    this.#uploadFaces(faces);
    const isRecoloured = recoloured(before, tones);
    if (isRecoloured.includes(1)) this.#recolour({ second: isRecoloured }, colours);
  }

  /**
   * A tint per input vertex, -1 … 1, over the colours, which fade; undefined for none. Draws what
   * differs.
   */
  set tints(tints: Float32Array | undefined) {
    const before = this.#tints;
    this.#tints = tints?.slice();
    if (!tints && !before) return;
    const { indices, faceCount } = this.#mesh;
    const differs = (v: number) => before?.[v] !== tints?.[v];
    // A loop, since every dab of a brush looks at all faces: `Uint8Array.from` takes several times as long.
    const isMeant = new Uint8Array(faceCount);
    for (let face = 0, i = 0; face < faceCount; ++face, i += 3) {
      if (differs(indices[i]) || differs(indices[i + 1]) || differs(indices[i + 2]))
        isMeant[face] = 1;
    }
    this.#recolour({ first: isMeant }, this.#colours());
  }

  dispose(): void {
    this.#cells.geometry.dispose();
    this.#wholeFaces.dispose();
    for (const material of this.#materials) material.dispose();
  }

  #drawAll(): void {
    const data = this.#filled ? this.#diagram?.data : undefined;
    const colours = this.#colours();
    for (let face = 0; face < this.#mesh.faceCount; ++face) {
      this.#writeFace(face, data ? data.faceLabel[face] : dropped, colours);
    }
    this.#replaceCells(undefined, this.#cut(data), colours);
    uploadAll(this.#colour);
  }

  /**
   * Recolours faces and cells that are otherwise unchanged: those whose face is marked in
   * `meant.first`, or whose label in `meant.second`.
   */
  #recolour(meant: Marks, colours: LabelColours): void {
    const { first = noMarks, second = noMarks } = meant;
    const faces = new Set<number>();
    const labels = this.#faceLabels;
    for (let face = 0; face < labels.length; ++face) {
      if (!(first[face] > 0 || second[labels[face]] > 0)) continue;
      this.#writeFace(face, labels[face], colours);
      faces.add(face);
    }
    const [position] = this.#cellTriangles.buffers;
    this.#cellTriangles.rewrite(meant, 2, (keys, record, target, at) => {
      this.#writeColours(keys, record, position.array, colours, target, at);
      faces.add(keys[2 * record]);
    });
    uploadRecords(this.#colour, Int32Array.from(faces).sort(), 9);
  }

  #writeFace(face: number, label: number, colours: LabelColours): void {
    this.#faceLabels[face] = label;
    const colour = this.#colour.array;
    const tints = this.#tints;
    for (let corner = 3 * face; corner < 3 * face + 3; ++corner) {
      if (tints) {
        colours.writeTinted(label, tints[this.#mesh.indices[corner]], colour, 3 * corner);
      } else {
        colours.write(label, colour, 3 * corner);
      }
    }
  }

  /** Uploads the changed faces; all of them if many have changed, which is quicker. */
  #uploadFaces(faces: ArrayLike<number>): void {
    if (faces.length > manyShare * this.#mesh.faceCount) {
      uploadAll(this.#colour);
      return;
    }
    uploadRecords(this.#colour, faces, 9);
  }

  #colours(): LabelColours {
    return new LabelColours(this.#filled ? this.#tones : undefined);
  }

  #cut(part: Cells | undefined): CellTriangles | undefined {
    return part && cellTriangles(this.#mesh, part);
  }

  /** Replaces the cells that are gone; all cells if `gone` is not given. */
  #replaceCells(
    gone: Marks | undefined,
    cells: CellTriangles | undefined,
    colours: LabelColours,
  ): void {
    const { keys, position, normal } = cells ?? noCells;
    const colour = new Uint8Array(position.length);
    for (let triangle = 0; triangle < keys.length / 2; ++triangle) {
      this.#writeColours(keys, triangle, position, colours, colour, 9 * triangle);
    }
    const capacity = position.length / 9;
    if (gone) this.#cellTriangles.replace(gone, keys, [position, normal, colour]);
    else this.#cellTriangles.adopt(keys, cornerBuffers(position, normal, colour), capacity);
    this.#adoptCells();
  }

  /** The colours of the three corners of a triangle of a cell, and of the face's corners there. */
  #writeColours(
    keys: Int32Array,
    triangle: number,
    position: ArrayLike<number>,
    colours: LabelColours,
    target: { [i: number]: number },
    at: number,
  ): void {
    const face = keys[2 * triangle];
    const label = keys[2 * triangle + 1];
    for (let k = 0; k < 9; k += 3) {
      if (this.#tints) {
        const tint = this.#tintAt(face, position, 9 * triangle + k);
        colours.writeTinted(label, tint, target, at + k);
      } else {
        colours.write(label, target, at + k);
      }
    }
    const { cornerPositions } = this.#mesh;
    const colour = this.#colour.array;
    for (let corner = 9 * face; corner < 9 * face + 9; corner += 3) {
      for (let k = 0; k < 9; k += 3) {
        if (!isSame(cornerPositions, corner, position, 9 * triangle + k)) continue;
        for (let channel = 0; channel < 3; ++channel)
          colour[corner + channel] = target[at + k + channel];
      }
    }
  }

  /** The tint at the place `position[at…]` of a face. */
  #tintAt(face: number, position: ArrayLike<number>, at: number): number {
    const [x, y, z] = [position[at], position[at + 1], position[at + 2]];
    return this.#mesh.interpolate(face, this.#mesh.barycentric(face, x, y, z), this.#tints ?? []);
  }

  #adoptCells(): void {
    const [position, normal, colour] = this.#cellTriangles.buffers as readonly BufferAttribute[];
    if (this.#cells.geometry.getAttribute('position') !== position) {
      // Disposing of the old one frees its buffers on the graphics card.
      this.#cells.geometry.dispose();
      this.#cells.geometry = new BufferGeometry();
      this.#cells.geometry.setAttribute('position', position);
      this.#cells.geometry.setAttribute('normal', normal);
      this.#cells.geometry.setAttribute('color', colour);
      this.#cells.geometry.boundingSphere = wholeScene;
    }
    this.#cells.geometry.setDrawRange(0, 3 * this.#cellTriangles.count);
    this.#cells.visible = this.#cellTriangles.count > 0;
  }
}

/** Marks the labels with another tone than before, and those that are new or gone. */
function recoloured(before: Uint16Array, after: Uint16Array): Uint8Array {
  const count = Math.max(before.length, after.length);
  return Uint8Array.from({ length: count }, (_, label) => (before[label] === after[label] ? 0 : 1));
}

/** Whether two arrays have the same three numbers at two places. */
function isSame(a: ArrayLike<number>, i: number, b: ArrayLike<number>, j: number): boolean {
  return a[i] === b[j] && a[i + 1] === b[j + 1] && a[i + 2] === b[j + 2];
}

/** Buffers of three corners per triangle. */
function cornerBuffers(position: Float32Array, normal: Float32Array, colour: Uint8Array) {
  return [
    new BufferAttribute(position, 3),
    new BufferAttribute(normal, 3),
    new BufferAttribute(colour, 3, true),
  ];
}

function wholeFaceGeometry(mesh: SceneMesh): BufferGeometry {
  const { indices } = mesh;
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(mesh.cornerPositions, 3));
  geometry.setAttribute('normal', new BufferAttribute(mesh.normals, 3));
  geometry.setAttribute('color', new BufferAttribute(new Uint8Array(3 * indices.length), 3, true));
  geometry.boundingSphere = wholeScene;
  return geometry;
}
