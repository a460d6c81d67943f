// SPDX-License-Identifier: MIT
//
// A model in the colours of its file: textures and vertex colours, without their own light effects.
// three.js reads them; its loaders are fetched when somebody wants to see them.

import { findModel } from 'geodesic-voronoi';
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Group,
  InstancedMesh,
  type Material,
  Mesh,
  MeshLambertMaterial,
  type MeshStandardMaterial,
  type Object3D,
  Texture,
} from 'three';
import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js';
import type { DrawingBuilder } from '../buffers/drawing_builder.js';
import { behindLines } from './lines.js';
import type { NamedFiles } from '../session/model_files.js';
import type { ModelFrame } from '../buffers/model_frame.js';
import { wholeScene } from './record_buffer.js';

/** The drawing of a file's own material. */
export interface OriginalMaterial {
  object: Group;
  textures: number;
  /** Frees its memory on the graphics card. */
  dispose(): void;
}

/** Reads a file that the model refers to. */
type Resource = (uri: string) => Promise<Uint8Array | undefined>;

/** Undefined if the file gives its surface no colours. Rejects if they cannot be read. */
export async function originalMaterial(
  { files, file, fetchBeside }: NamedFiles,
  frame: ModelFrame,
  builder: DrawingBuilder,
  signal: AbortSignal,
): Promise<OriginalMaterial | undefined> {
  const { format, bytes, resource: given } = await findModel(files, { file, signal });
  /** Looks among the files of the model, then at its address. */
  const resource = async (uri: string) =>
    (await given(uri).catch(() => undefined)) ?? fetchBeside?.(uri, signal);
  const surface =
    format === 'glTF'
      ? await gltfScene(bytes, resource)
      : format === 'PLY'
        ? await plyScene(bytes, builder, signal)
        : undefined;
  if (!surface) return undefined;
  const object = new Group();
  object.scale.setScalar(frame.scale);
  object.position.fromArray(frame.centre).multiplyScalar(-frame.scale);
  surface.updateMatrixWorld(true);
  surface.traverse((part) => {
    if (part instanceof Mesh) object.add(plainly(part));
  });
  const parts = object.children as Mesh<BufferGeometry, MeshLambertMaterial>[];
  const materials = parts.map(({ material }) => material);
  const textures = new Set(materials.map(({ map }) => map).filter((map) => map !== null));
  const isColoured = materials.some(
    ({ vertexColors, color }) => vertexColors || color.getHex() !== 0xffffff,
  );
  if (textures.size === 0 && !isColoured) return undefined;
  const dispose = () => {
    for (const part of parts) {
      part.geometry.dispose();
      if (part instanceof InstancedMesh) part.dispose();
    }
    for (const each of [...materials, ...textures]) each.dispose();
    for (const { image } of textures) (image as ImageBitmap).close();
  };
  return { object, textures: textures.size, dispose };
}

/** Gives a part the lighting of the other layers. Skins are not posed, as in the library's mesh. */
function plainly(part: Mesh): Mesh {
  const { color, map, vertexColors, transparent, opacity, alphaTest, flatShading } =
    part.material as MeshStandardMaterial;
  const material = new MeshLambertMaterial({
    ...{ color, map, vertexColors, transparent, opacity, alphaTest, flatShading },
    side: DoubleSide,
    ...behindLines,
  });
  const isSkinned = 'isSkinnedMesh' in part;
  const mesh = part instanceof InstancedMesh ? part.clone(false) : new Mesh();
  mesh.geometry = morphed(part);
  mesh.material = material;
  mesh.matrixAutoUpdate = false;
  if (isSkinned) mesh.matrix.identity();
  else mesh.matrix.copy(part.matrixWorld);
  mesh.frustumCulled = false;
  return mesh;
}

/**
 * The geometry of a part with its morph targets applied, as in the library's mesh: the page's three.js
 * has none, and could not draw them.
 */
function morphed({ geometry, morphTargetInfluences: weights = [] }: Mesh): BufferGeometry {
  const targets = Object.entries(geometry.morphAttributes);
  if (targets.length === 0) return geometry;
  const result = new BufferGeometry().setIndex(geometry.index);
  for (const [name, attribute] of Object.entries(geometry.attributes))
    result.setAttribute(name, attribute);
  for (const [name, differences] of targets) {
    if (!geometry.hasAttribute(name)) continue;
    const before = geometry.getAttribute(name);
    const { count, itemSize } = before;
    const after = new BufferAttribute(new Float32Array(count * itemSize), itemSize);
    const active = differences
      .map((difference, target) => ({ difference, weight: weights[target] ?? 0 }))
      .filter(({ weight }) => weight !== 0);
    for (let i = 0; i < count; ++i) {
      for (let k = 0; k < itemSize; ++k) {
        let value = before.getComponent(i, k);
        for (const { difference, weight } of active)
          if (k < difference.itemSize) value += weight * difference.getComponent(i, k);
        after.setComponent(i, k, value);
      }
    }
    result.setAttribute(name, after);
  }
  return result;
}

async function gltfScene(bytes: Uint8Array, resource: Resource): Promise<Object3D | undefined> {
  const [{ GLTFLoader }, { MeshoptDecoder }] = await Promise.all([
    import('three/addons/loaders/GLTFLoader.js'),
    import('meshoptimizer/decoder'),
  ]);
  const loader = new GLTFLoader();
  loader.setMeshoptDecoder(MeshoptDecoder);
  loader.register((parser) => {
    keepColours(parser);
    readFrom(parser, resource);
    return { name: 'given files' };
  });
  const { scenes, scene } = await loader.parseAsync(bytes.slice().buffer, '');
  return (scene as Object3D | undefined) ?? scenes[0];
}

/** What is drawn of a glTF's material, as the file has it. */
interface GltfColours {
  pbrMetallicRoughness?: { baseColorFactor?: number[]; baseColorTexture?: object };
  alphaMode?: string;
  alphaCutoff?: number;
}

/** Leaves out of a file's materials what is not drawn: three.js would read and decode its pictures. */
function keepColours({ json }: GLTFParser): void {
  json.materials = json.materials?.map((material: GltfColours): GltfColours => {
    const { pbrMetallicRoughness, alphaMode, alphaCutoff } = material;
    const { baseColorFactor, baseColorTexture } = pbrMetallicRoughness ?? {};
    return { pbrMetallicRoughness: { baseColorFactor, baseColorTexture }, alphaMode, alphaCutoff };
  });
}

/** A part of three.js that its types leave out. */
interface GltfFiles {
  loadBuffer(index: number): Promise<ArrayBuffer>;
  loadImageSource(index: number): Promise<Texture>;
}

/**
 * Has three.js take buffers and images from the model's files. It would fetch them otherwise,
 * images even from addresses that a strict content security policy forbids.
 */
function readFrom(parser: GLTFParser, resource: Resource): void {
  const { json } = parser;
  const files = parser as unknown as GltfFiles;
  const loadBuffer = files.loadBuffer.bind(parser);
  files.loadBuffer = async (index) => {
    const { uri } = json.buffers[index];
    // Without an address it is in the glTF itself.
    return uri === undefined ? loadBuffer(index) : (await contentOf(uri, resource)).buffer;
  };
  files.loadImageSource = async (index) => {
    const { uri, bufferView, mimeType } = json.images[index];
    const bytes =
      uri === undefined
        ? await parser.getDependency('bufferView', bufferView)
        : await contentOf(uri, resource);
    const picture = await createImageBitmap(new Blob([bytes], { type: mimeType }), {
      premultiplyAlpha: 'none',
      colorSpaceConversion: 'none',
    });
    const texture = new Texture(picture);
    texture.needsUpdate = true;
    return texture;
  };
}

async function contentOf(uri: string, resource: Resource): Promise<Uint8Array<ArrayBuffer>> {
  const [, isBase64, text] = /^data:[^,]*?(;base64)?,(.*)$/is.exec(uri) ?? [];
  if (text !== undefined) {
    const content = isBase64 ? atob(text) : decodeURIComponent(text);
    return Uint8Array.from(content, (c) => c.charCodeAt(0));
  }
  const bytes = await resource(uri);
  if (!bytes) throw new Error(`it needs ${uri}`);
  return bytes.slice();
}

async function plyScene(
  bytes: Uint8Array,
  builder: DrawingBuilder,
  signal: AbortSignal,
): Promise<Object3D | undefined> {
  const made = await builder.ask('ply', bytes.slice());
  signal.throwIfAborted(); // the builder has ended with the model, and nothing is to be made here
  const surface =
    made === undefined ? (await import('../buffers/ply_surface.js')).plySurface(bytes) : made;
  if (!surface) return undefined;
  const geometry = new BufferGeometry();
  for (const name of ['position', 'normal', 'color'] as const) {
    const { array, normalized } = surface[name];
    geometry.setAttribute(name, new BufferAttribute(array, 3, normalized));
  }
  if (surface.index) geometry.setIndex(new BufferAttribute(surface.index, 1));
  // Otherwise three.js would compute it from all vertices, for the order of drawing.
  geometry.boundingSphere = wholeScene;
  const material: Material = new MeshLambertMaterial({ vertexColors: true });
  return new Mesh(geometry, material);
}
