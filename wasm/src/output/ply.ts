// SPDX-License-Identifier: MIT
//
// Writing binary PLY.

const types = {
  uchar: { size: 1, setter: 'setUint8' },
  int: { size: 4, setter: 'setInt32' },
  float: { size: 4, setter: 'setFloat32' },
  double: { size: 8, setter: 'setFloat64' },
} as const;
type PlyType = keyof typeof types;

/** Columns of a table: names, their type, and the numbers row by row. */
export interface PlyColumns {
  names: string[];
  type: PlyType;
  values: ArrayLike<number>;
}

/** A binary PLY of vertices, polygons (lists of vertices) and a number per polygon. */
export function ply(
  comment: string,
  vertices: PlyColumns[],
  polygons: { offset: ArrayLike<number>; points: ArrayLike<number> },
  faces: PlyColumns[],
): Uint8Array<ArrayBuffer> {
  const vertexCount = vertices[0].values.length / vertices[0].names.length;
  const faceCount = polygons.offset.length - 1;
  const lengthOf = (f: number) => polygons.offset[f + 1] - polygons.offset[f];
  let longest = 0;
  for (let f = 0; f < faceCount; ++f) longest = Math.max(longest, lengthOf(f));
  const lengthType = longest < 256 ? 'uchar' : 'int';
  const header = headerOf([
    `comment ${comment}`,
    `element vertex ${vertexCount}`,
    ...propertiesOf(vertices),
    `element face ${faceCount}`,
    `property list ${lengthType} int vertex_indices`,
    ...propertiesOf(faces),
  ]);
  const bytes = new Uint8Array(
    header.length +
      vertexCount * rowBytes(vertices) +
      faceCount * (types[lengthType].size + rowBytes(faces)) +
      4 * polygons.points.length,
  );
  bytes.set(header);
  const view = new DataView(bytes.buffer);
  let offset = header.length;
  const put = (type: PlyType, x: number) => {
    view[types[type].setter](offset, x, true);
    offset += types[type].size;
  };
  const putRow = (columns: PlyColumns[], row: number) => {
    for (const { names, type, values } of columns)
      for (let k = 0; k < names.length; ++k) put(type, values[row * names.length + k]);
  };
  for (let v = 0; v < vertexCount; ++v) putRow(vertices, v);
  for (let f = 0; f < faceCount; ++f) {
    put(lengthType, lengthOf(f));
    for (let i = polygons.offset[f]; i < polygons.offset[f + 1]; ++i)
      put('int', polygons.points[i]);
    putRow(faces, f);
  }
  return bytes;
}

function headerOf(lines: string[]): Uint8Array {
  const all = ['ply', 'format binary_little_endian 1.0', ...lines, 'end_header'];
  return new TextEncoder().encode(`${all.join('\n')}\n`);
}

function propertiesOf(columns: PlyColumns[]): string[] {
  return columns.flatMap(({ names, type }) => names.map((name) => `property ${type} ${name}`));
}

function rowBytes(columns: PlyColumns[]): number {
  return columns.reduce((sum, { names, type }) => sum + names.length * types[type].size, 0);
}
