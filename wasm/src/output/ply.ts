// SPDX-License-Identifier: MIT
//
// Writing binary PLY.

const writers = {
  uchar: { size: 1, write: (view: DataView, at: number, x: number) => view.setUint8(at, x) },
  int: { size: 4, write: (view: DataView, at: number, x: number) => view.setInt32(at, x, true) },
  float: {
    size: 4,
    write: (view: DataView, at: number, x: number) => view.setFloat32(at, x, true),
  },
  double: {
    size: 8,
    write: (view: DataView, at: number, x: number) => view.setFloat64(at, x, true),
  },
};

/** Columns of a table: names, their type, and the numbers row by row. */
export interface PlyColumns {
  names: string[];
  type: keyof typeof writers;
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
      faceCount * (writers[lengthType].size + rowBytes(faces)) +
      4 * polygons.points.length,
  );
  bytes.set(header);
  const view = new DataView(bytes.buffer);
  let offset = header.length;
  const put = (type: keyof typeof writers, x: number) => {
    writers[type].write(view, offset, x);
    offset += writers[type].size;
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
  return columns.reduce((sum, { names, type }) => sum + names.length * writers[type].size, 0);
}
