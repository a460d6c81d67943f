// SPDX-License-Identifier: MIT
//
// node tests/bench/hostile.mjs [NAME...]: how long the native glTF reader and the command take over files
// that are made to take long (of a processor, so that others may work beside), and how much memory. Each
// should be read or refused within 2 s and 1 s more per 10 MB, and 300 MB and 4 times the file: what is
// not is marked. Linux only.

import { spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, statSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { zipSync } from 'fflate';
import { glbOf } from '../wasm/meshes.mjs';

const path = (name) => fileURLToPath(new URL(`../../${name}`, import.meta.url));
const megabyte = 2 ** 20;
const large = 60 * megabyte;

/** So much of a text, over and over. */
const filled = (text, length = large) => Buffer.alloc(length, text);
const joined = (...parts) => Buffer.concat(parts.map((part) => Buffer.from(part)));
const nested = (open, close) =>
  joined(
    filled(open, large / 2),
    filled(close, Math.floor(large / 2 / open.length) * close.length),
  );

const asset = '{"asset":{"version":"2.0"},';
const gltf = (member, content, end) => joined(asset, `"${member}":`, content, `${end}}`);
const triangle = (change = {}) => ({
  asset: { version: '2.0' },
  nodes: [{ mesh: 0 }],
  meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
  accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: 'VEC3' }],
  bufferViews: [{ buffer: 0, byteLength: 36 }],
  buffers: [{ byteLength: 36 }],
  ...change,
});
const json = (document) => Buffer.from(JSON.stringify(document));
const places = new Uint8Array(Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0).buffer);

function soup(bytes) {
  const count = Math.floor(bytes / 36) * 3;
  const numbers = Float32Array.from({ length: 3 * count }, (_, i) => Math.sin(i * 1.618));
  const json = triangle({
    accessors: [{ bufferView: 0, componentType: 5126, count, type: 'VEC3' }],
    bufferViews: [{ buffer: 0, byteLength: 12 * count }],
    buffers: [{ byteLength: 12 * count }],
  });
  return glbOf(json, new Uint8Array(numbers.buffer));
}

function sharedMesh(instances, count) {
  return json(
    triangle({
      nodes: Array.from({ length: instances }, () => ({ mesh: 0 })),
      accessors: [{ componentType: 5126, count, type: 'VEC3' }],
    }),
  );
}

const compressedUse = ',"extensionsUsed":["KHR_draco_mesh_compression"]';
const plyHeader = (format, ...lines) =>
  ['ply', `format ${format} 1.0`, ...lines, 'end_header', ''].join('\n');
const vertex = (count) => [
  `element vertex ${count}`,
  ...['x', 'y', 'z'].map((x) => `property float ${x}`),
];
const face = (count, length = 'uchar', index = 'int') => [
  `element face ${count}`,
  `property list ${length} ${index} vertex_indices`,
];
const zip = (name, bytes, level = 9) => zipSync({ [name]: [bytes, { level }] });

/** Each a file by its name. */
const files = {
  'million-nodes.gltf': () => gltf('nodes', `[${'{},'.repeat(1e6)}{}]`, ''),
  'zeros.gltf': () => sharedMesh(1, 1e9),
  'instances-of-zeros.gltf': () => sharedMesh(5000, 5e7),
  'zeros-just-read.gltf': () => sharedMesh(1, 2 ** 20),
  'nested-arrays.gltf': () => gltf('nodes', nested('[', ']'), ''),
  'nested-objects.gltf': () => gltf('extras', joined(nested('{"a":', '')), ''),
  'flat-objects.gltf': () => gltf('nodes', joined('[', filled('{},'), '{}]'), ''),
  'flat-buffers.gltf': () => gltf('buffers', joined('[', filled('{},'), '{}]'), ''),
  'flat-extras.gltf': () => gltf('extras', joined('[', filled('{},'), '{}]'), ''),
  'flat-numbers.gltf': () => gltf('scenes', joined('[{"nodes":[', filled('0,'), '0]}]'), ''),
  'flat-strings.gltf': () => gltf('extensionsUsed', joined('[', filled('"",'), '""]'), ''),
  'long-name.gltf': () => gltf('nodes', joined('[{"name":"', filled('a'), '"}]'), ''),
  'long-key.gltf': () => gltf('extras', joined('{"', filled('\\"'), '":0}'), ''),
  'long-number.gltf': () => gltf('scene', filled('9'), ''),
  'draco-flat-objects.gltf': () => gltf('nodes', joined('[', filled('{},'), '{}]'), compressedUse),
  'draco-flat-extras.gltf': () => gltf('extras', joined('[', filled('{},'), '{}]'), compressedUse),
  'draco-nested.gltf': () => gltf('nodes', nested('[', ']'), compressedUse),
  'data-uri.gltf': () =>
    json(triangle({ buffers: [{ byteLength: 36, uri: `data:;base64,${filled('AAAA')}` }] })),
  'data-uri-percent.gltf': () =>
    json(triangle({ buffers: [{ byteLength: 36, uri: `data:,${filled('%00')}` }] })),
  'meshopt-bomb.gltf': () => {
    const extension = { buffer: 0, byteLength: 36, byteStride: 16, count: 6e7, mode: 'ATTRIBUTES' };
    return glbOf(
      triangle({
        bufferViews: [
          { buffer: 0, byteLength: 36, extensions: { EXT_meshopt_compression: extension } },
        ],
        extensionsUsed: ['EXT_meshopt_compression'],
      }),
      places,
    );
  },
  'soup.glb': () => soup(large),
  'zeros.bin': () => filled('\0'),
  'vertices.obj': () => filled('v 0 0 0\n'),
  'faces.obj': () => joined('v 0 0 0\nv 1 0 0\nv 0 1 0\n', filled('f 1 2 3\n')),
  'far-vertices.obj': () => joined('v 0 0 0\n', filled('f 1 9999999 3\n')),
  'one-face.obj': () => joined('v 0 0 0\nv 1 0 0\nv 0 1 0\nf', filled(' 1 2 3')),
  'one-line.obj': () => joined('v 0 0 0\n', filled('a')),
  'spaces.obj': () => joined('v 0 0 0\n', filled(' ')),
  'empty-lines.obj': () => joined('v 0 0 0\n', filled('\n')),
  'returns.obj': () => joined('v 0 0 0\n', filled('\r')),
  'continued.obj': () => joined('v 0 0 0\n', filled('f 1 \\\n')),
  'polygons.obj': () =>
    joined('v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n', filled(`f${' 1 2 4 3'.repeat(4000)}\n`)),
  'garbage.stl': () => joined('solid a facet\n', filled('vertex 1e400 nan x ')),
  'vertices.stl': () =>
    joined('solid a\nfacet normal 0 0 0\nouter loop\n', filled('vertex 0 0 0\n')),
  'triangles.stl': () =>
    joined(
      'solid a\n',
      filled('facet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n'),
    ),
  'binary.stl': () => {
    const count = Math.floor(large / 50);
    const bytes = Buffer.alloc(84 + 50 * count, '\x11\x22\x33\x3f');
    bytes.writeUInt32LE(count, 80);
    return bytes;
  },
  'counts.ply': () => Buffer.from(plyHeader('ascii', ...vertex(1e11), ...face(1e11))),
  'no-properties.ply': () =>
    Buffer.from(plyHeader('ascii', ...Array(2000).fill('element nothing 999999999999'))),
  'one-face.ply': () =>
    joined(
      plyHeader('binary_little_endian', ...vertex(3), ...face(1, 'uint', 'uchar')),
      places,
      Uint8Array.of(0, 0, 192, 3),
      filled('\0\x01\x02'),
    ),
  'strip.ply': () =>
    joined(
      plyHeader(
        'binary_little_endian',
        ...vertex(3),
        'element tristrips 1',
        'property list uint uchar vertex_indices',
      ),
      places,
      Uint8Array.of(0, 0, 192, 3),
      filled('\0\x01\x02'),
    ),
  'one-line.ply': () => joined(plyHeader('ascii', ...vertex(1e7), ...face(1)), filled('0 ')),
  'faces.ply': () =>
    joined(
      plyHeader(
        'binary_little_endian',
        ...vertex(3),
        ...face(Math.floor(large / 4), 'uchar', 'uchar'),
      ),
      places,
      filled('\x03\0\x01\x02'),
    ),
  'lists.ply': () =>
    joined(
      plyHeader(
        'binary_little_endian',
        'element a 99999999999',
        'property list uchar uchar b',
        ...vertex(1),
        ...face(1),
      ),
      filled('\0'),
    ),
  'zeros.zip': () => zip('a.obj', filled('\0', 1000 * megabyte)),
  'lines.zip': () => zip('a.obj', filled('\n', 120 * megabyte)),
  'vertices.zip': () => zip('a.obj', filled('v 0 0 0\n', 36 * megabyte)),
  'faces.zip': () =>
    zip('a.obj', joined('v 0 0 0\nv 1 0 0\nv 0 1 0\n', filled('f 1 2 3\n', 32 * megabyte))),
  'entries.zip': () =>
    zipSync(
      Object.fromEntries(Array.from({ length: 65000 }, (_, i) => [`${i}.txt`, Buffer.alloc(0)])),
    ),
  'directory.zip': () => joined(filled('PK\x05\x06'), Buffer.alloc(22)),
};
/** Lists of sites, for the command alone. */
const siteFiles = {
  'nested.json': () => nested('[', ']'),
  'nested-bary.json': () => joined('{"face":[0],"bary":', nested('[', ']'), '}'),
  'objects.json': () => joined('{"face":[', filled('{},'), '0],"bary":[]}'),
  'numbers.json': () => joined('{"vertex":[', filled('0,'), '0]}'),
};

/** Runs a command: seconds, the most memory that it had in MB, its status, and its first line. */
function measured(command, args) {
  return new Promise((resolve) => {
    const start = performance.now();
    const child = spawn(command, args, { stdio: ['ignore', 'pipe', 'pipe'] });
    let text = '';
    for (const stream of [child.stdout, child.stderr]) stream.on('data', (part) => (text += part));
    let [most, seconds] = [0, 0];
    const look = setInterval(() => {
      try {
        const status = readFileSync(`/proc/${child.pid}/status`, 'utf8');
        most = Math.max(most, Number(/VmHWM:\s*(\d+)/.exec(status)?.[1] ?? 0));
        const times = readFileSync(`/proc/${child.pid}/stat`, 'utf8')
          .replace(/.*\)/, '')
          .split(' ');
        seconds = (Number(times[12]) + Number(times[13])) / 100;
      } catch {
        // It has just ended.
      }
      if (performance.now() - start > 120_000) child.kill('SIGKILL');
    }, 5);
    child.on('close', (status, signal) => {
      clearInterval(look);
      resolve({
        seconds,
        memory: most / 1024,
        status: signal ?? status,
        line: text.split('\n')[0],
      });
    });
  });
}

function report(name, who, size, { seconds, memory, status, line }) {
  const mostSeconds = 2 + size / 10 / megabyte;
  const mostMemory = 300 + (4 * size) / megabyte;
  const marks = [
    seconds > mostSeconds ? 'SLOW' : '',
    memory > mostMemory ? 'LARGE' : '',
    status !== 0 && status !== 1 ? 'DIED' : '',
  ].join('');
  console.log(
    [
      name.padEnd(24),
      who.padEnd(7),
      `${(size / megabyte).toFixed(1)} MB`.padStart(8),
      `${seconds.toFixed(2)} s`.padStart(8),
      `${memory.toFixed(0)} MB`.padStart(8),
      String(status).padStart(3),
      marks.padEnd(5),
      line.replace(/\/tmp\/[^ ]*\//, '').slice(0, 110),
    ].join('  '),
  );
}

const folder = mkdtempSync(join(tmpdir(), 'geodesic-voronoi-'));
const main = path('dist/cli/main.js');
const wanted = (name) =>
  process.argv.length < 3 || process.argv.slice(2).some((arg) => name.includes(arg));
const command = (...args) => measured(process.execPath, [main, ...args]);

try {
  for (const [name, make] of Object.entries(files).filter(([name]) => wanted(name))) {
    const file = join(folder, name);
    writeFileSync(file, make());
    const { size } = statSync(file);
    if (/gltf|glb/.test(name)) {
      report(
        name,
        'native',
        size,
        await measured(path('build/native/tests/bench/gvd_read_gltf'), [file]),
      );
    }
    report(name, 'command', size, await command('info', file));
    rmSync(file);
  }
  const mesh = join(folder, 'triangle.glb');
  writeFileSync(mesh, glbOf(triangle(), places));
  for (const [name, make] of Object.entries(siteFiles).filter(([name]) => wanted(name))) {
    const file = join(folder, name);
    writeFileSync(file, make());
    report(name, 'command', statSync(file).size, await command('diagram', mesh, '--sites', file));
    rmSync(file);
  }
  const specials = {
    'link-to-zero.glb': (at) => symlinkSync('/dev/zero', at),
    'pipe.glb': (at) => spawnSync('mkfifo', [at]),
  };
  for (const [name, make] of Object.entries(specials).filter(([name]) => wanted(name))) {
    make(join(folder, name));
    report(name, 'command', 0, await command('info', join(folder, name)));
  }
} finally {
  rmSync(folder, { recursive: true });
}
