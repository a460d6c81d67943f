// SPDX-License-Identifier: MIT
//
// The command among other processes: pipes that close, disks that are full, signals, and files that are
// read and written at once. One line at most, the right exit status, and no half of a file.

import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import {
  lstatSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  rmSync,
  statSync,
  writeFileSync,
} from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { zipSync } from 'fflate';
import { bumpySphere, glb, gltf, octahedron } from './meshes.mjs';
import { meshObj } from './model_files.mjs';
import { temporaryFolder } from './temporary_folder.mjs';

const main = fileURLToPath(new URL('../../dist/cli/main.js', import.meta.url));
const isUnix = process.platform !== 'win32';

const folder = temporaryFolder();
writeFileSync(join(folder, 'mesh.glb'), glb(octahedron()));
writeFileSync(join(folder, 'large.glb'), glb(bumpySphere(120, 200)));
writeFileSync(join(folder, 'old.json'), 'old');
const parts = { 'a/one.obj': meshObj(octahedron()), 'two.obj': meshObj(bumpySphere(5, 6)) };
writeFileSync(join(folder, 'parts.zip'), zipSync(parts));
const contents = readdirSync(folder).sort();

/** A line of the shell, in which `gv` is the command. */
function shell(line) {
  const { status, stdout, stderr } = spawnSync(
    'sh',
    ['-c', `gv() { "${process.execPath}" "${main}" "$@"; }\n${line}`],
    { cwd: folder, encoding: 'utf8' },
  );
  return { status, stdout, stderr };
}

/** Nothing is written but one line, if that, and no file is changed. */
function assertTidy(stderr, pattern) {
  assert.match(stderr, pattern);
  assert.doesNotMatch(stderr, /^ +at /m);
  assert.deepEqual(readdirSync(folder).sort(), contents);
  assert.equal(readFileSync(join(folder, 'old.json'), 'utf8'), 'old');
}

const oneLine = (pattern) => new RegExp(`^geodesic-voronoi: .*${pattern}.*\\n$`);

for (const [what, line, status, pattern] of [
  [
    'a reader that has enough',
    'gv diagram large.glb --sites 2000 | head -c 1 >head.tmp; rm head.tmp',
    0,
    /^$/,
  ],
  ['a reader that is gone', 'gv diagram mesh.glb --sites 1 | true', 0, /^$/],
  [
    'a full disk',
    'gv cvt mesh.glb --sites 2 -q -o /dev/full',
    1,
    oneLine('/dev/full.*disk is full'),
  ],
  [
    'a full disk behind standard output',
    'gv info mesh.glb --json >/dev/full',
    1,
    oneLine('standard output.*disk is full'),
  ],
  [
    'a full disk behind a help',
    'gv --help >/dev/full',
    1,
    oneLine('standard output.*disk is full'),
  ],
  [
    'a name that is too long',
    'gv cvt mesh.glb --sites 2 -o $(printf %0300d 1).json',
    1,
    oneLine('cannot be written: name too long'),
  ],
  ['no room for an error', 'gv info nowhere.glb 2>/dev/full', 1, /^$/],
  ['no standard error', 'gv info nowhere.glb 2>&-', 1, /^$/],
  ['no standard input', 'gv info - <&-', 1, oneLine('file is empty')],
  [
    'an empty standard input',
    'gv info - </dev/null',
    1,
    oneLine('standard input: the file is empty'),
  ],
  ['a device for a model', 'gv info /dev/zero', 1, oneLine('/dev/zero is a device and no file')],
  [
    'a device for sites',
    'gv diagram mesh.glb --sites /dev/zero',
    1,
    oneLine('/dev/zero is a device and no file'),
  ],
  [
    'a link to a device',
    'ln -s /dev/zero z.glb; gv info z.glb; code=$?; rm z.glb; exit $code',
    1,
    oneLine('z\\.glb is a device'),
  ],
  [
    'a model and sites through pipes',
    `mkfifo p.tmp; cat mesh.glb >p.tmp & echo '{"vertex": [0]}' |
      gv diagram p.tmp --sites /dev/fd/0 -o /dev/fd/1 | grep -q '"regions"'; code=$?; rm p.tmp; exit $code`,
    0,
    /^1 region, 0 bisector arcs, 0 Voronoi points\n$/,
  ],
  [
    'a folder for output',
    'mkdir d.json; gv diagram mesh.glb --sites 1 -o d.json; code=$?; rmdir d.json; exit $code',
    1,
    oneLine('d\\.json cannot be written: it is a folder'),
  ],
  [
    'a folder for output that is not there',
    'gv partition mesh.glb --sites 1 -o parts/',
    1,
    oneLine('parts/ cannot be written: it is a folder'),
  ],
  [
    'a folder that takes no files',
    'gv diagram mesh.glb --sites 1 -o /proc/d.json',
    1,
    oneLine('/proc/d\\.json cannot be written'),
  ],
  [
    'an output that stops half way',
    'ulimit -f 1; gv diagram large.glb --sites 300 -o old.json',
    1,
    oneLine('old\\.json cannot be written: no file may be as large'),
  ],
  [
    'a model of several that is not there',
    'gv info "parts.zip#three.obj"',
    1,
    oneLine('there is no three\\.obj in a/one\\.obj and two\\.obj'),
  ],
  [
    'several models on standard input',
    'cat parts.zip | gv info -',
    1,
    oneLine('choose one by its path, as FILE#PATH of a file that is saved'),
  ],
  [
    'several models',
    'gv info parts.zip',
    1,
    oneLine(
      'a/one\\.obj and two\\.obj are several models: choose one by its path, as parts\\.zip#PATH',
    ),
  ],
]) {
  test(`${what}: ${line.split(';')[0]}`, { skip: !isUnix }, () => {
    const result = shell(line);
    assert.equal(result.status, status, result.stderr);
    assertTidy(result.stderr, pattern);
  });
}

const mode = (name) => (statSync(join(folder, name)).mode & 0o777).toString(8);

test('an output keeps its mode, and is written where its links lead', { skip: !isUnix }, () => {
  const gv = 'gv diagram mesh.glb --sites 2 -q -o';
  const { status, stderr } = shell(`umask 022; echo old >made.json; chmod 660 made.json
    ln -s made.json link.json; ln -s new.json dangling.json; ln -s dangling.json twice.json
    ln -s circle.json circle.json
    ${gv} link.json && ${gv} twice.json && ${gv} circle.json`);
  const results = ['made', 'new', 'link', 'dangling'].map((name) => {
    const path = join(folder, `${name}.json`);
    const isLink = lstatSync(path).isSymbolicLink();
    return [isLink, mode(`${name}.json`), readFileSync(path, 'utf8').startsWith('{"mesh"')];
  });
  for (const name of ['made', 'new', 'link', 'dangling', 'twice', 'circle'])
    rmSync(join(folder, `${name}.json`));
  assert.deepEqual(results, [
    [false, '660', true],
    [false, '644', true],
    [true, '660', true],
    [true, '644', true],
  ]);
  assert.equal(status, 1);
  assertTidy(stderr, oneLine('circle\\.json cannot be written: its links lead in circles'));
});

const isRoot = isUnix && process.getuid() === 0;

test('a file that may not be written, and one where no other may be', {
  skip: !isUnix || isRoot,
}, () => {
  const { status, stdout, stderr } = shell(`cp old.json made.json; chmod 444 made.json
    gv diagram mesh.glb --sites 1 -o made.json; code=$?; cat made.json; chmod 644 made.json; chmod a-w .
    gv diagram mesh.glb --sites 2 -q -o made.json; echo $?; chmod u+w .; cut -c 1-7 made.json
    rm made.json; exit $code`);
  assert.equal(status, 1);
  assert.equal(stdout, 'old0\n{"mesh"\n');
  assertTidy(stderr, oneLine('made\\.json cannot be written: permission is denied'));
});

test('a folder without permission to write', { skip: !isUnix || isRoot }, () => {
  const { status, stderr } = shell(
    'chmod a-w .; gv diagram mesh.glb --sites 1 -o d.json; code=$?; chmod u+w .; exit $code',
  );
  assert.equal(status, 1);
  assertTidy(stderr, oneLine('d\\.json cannot be written: permission is denied'));
});

for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP']) {
  test(`${signal} ends the work, and leaves nothing`, { skip: !isUnix }, async () => {
    const args = ['cvt', 'large.glb', '--sites', '2000', '-o', 'old.json', '--progress'];
    const child = spawn(process.execPath, [main, ...args], { cwd: folder });
    let stderr = '';
    child.stderr.setEncoding('utf8').on('data', (text) => {
      stderr += text;
      child.kill(signal); // it is at work
    });
    const ended = await new Promise((resolve) =>
      child.on('close', (status, by) => resolve(by ?? status)),
    );
    // A shell shows 128 and the signal's number.
    assert.equal(ended, signal);
    assertTidy(stderr, /^( *\d+%\n)*$/);
  });
}

test('a signal while a file is written leaves what was there', { skip: !isUnix }, async () => {
  const args = ['diagram', 'large.glb', '--sites', '2000', '--detail', '3', '-o', 'old.json'];
  const child = spawn(process.execPath, [main, ...args], { cwd: folder });
  const look = setInterval(() => {
    if (readdirSync(folder).some((name) => name.endsWith('.tmp'))) child.kill('SIGTERM');
  }, 1);
  const ended = await new Promise((resolve) =>
    child.on('close', (status, by) => resolve(by ?? status)),
  );
  clearInterval(look);
  const text = readFileSync(join(folder, 'old.json'), 'utf8');
  if (ended === 'SIGTERM') assert.equal(text, 'old');
  else assert.ok(JSON.parse(text).regions); // it was quicker than the signal
  writeFileSync(join(folder, 'old.json'), 'old');
  assert.deepEqual(readdirSync(folder).sort(), contents);
});

test('an output may be the sites that were read, but not the model', { skip: !isUnix }, () => {
  const line = `gv cvt mesh.glb --sites 3 -o s.json -q && gv cvt mesh.glb --sites s.json -o s.json -q
    ln -s mesh.glb link.glb; gv partition link.glb --sites s.json -o ./mesh.glb -q`;
  const before = readFileSync(join(folder, 'mesh.glb'));
  const { status, stderr } = shell(`${line}; code=$?; rm s.json link.glb; exit $code`);
  assert.equal(status, 1, stderr);
  // The path is as it was given.
  assertTidy(
    stderr,
    /^geodesic-voronoi: \.\/mesh\.glb cannot be written: the model is read from it\n$/,
  );
  assert.deepEqual(readFileSync(join(folder, 'mesh.glb')), before);
});

test('nor a file that has the model, or that it refers to', { skip: !isUnix }, () => {
  const { json, buffer } = gltf(octahedron(), { uri: 'data.bin' });
  for (const [model, output, files] of [
    ['parts.zip#two.obj', 'parts.zip', {}],
    ['one', 'one/m.glb', { 'one/m.glb': glb(octahedron()) }],
    ['one#m.glb', 'one/m.glb', { 'one/m.glb': glb(octahedron()), 'one/n.obj': 'v 0 0 0' }],
    ['one/s.gltf', 'one/data.bin', { 'one/s.gltf': JSON.stringify(json), 'one/data.bin': buffer }],
    ['one', 'one/data.bin', { 'one/s.gltf': JSON.stringify(json), 'one/data.bin': buffer }],
  ]) {
    mkdirSync(join(folder, 'one'));
    for (const [name, content] of Object.entries(files)) writeFileSync(join(folder, name), content);
    const before = readFileSync(join(folder, output));
    const line = `gv partition "${model}" --sites 2 --format glb -o ${output} -q`;
    const { status, stderr } = shell(line);
    const after = readFileSync(join(folder, output));
    const other = shell(`gv partition "${model}" --sites 2 --format glb -o one/new.glb -q`);
    rmSync(join(folder, 'one'), { recursive: true });
    assert.equal(status, 1, line);
    assertTidy(stderr, oneLine(`${output} cannot be written: the model is read from it`));
    assert.deepEqual(after, before);
    assert.equal(other.status, 0, other.stderr);
  }
  // Of several models, those that can be read are reported, but not there.
  const { status, stderr } = shell('gv info parts.zip#two.obj old.json -o old.json');
  assert.equal(status, 1);
  assertTidy(stderr, oneLine('old.json cannot be written: the model is read from it'));
});

test('after a #, one of several models', { skip: !isUnix }, () => {
  for (const [name, faces] of [
    ['parts.zip#a/one.obj', 8],
    ['.#parts.zip', undefined],
    ['.#mesh.glb', 8],
  ]) {
    const { status, stdout, stderr } = shell(`gv info "${name}" --json`);
    assert.equal(status, faces ? 0 : 1, stderr);
    if (faces) assert.equal(JSON.parse(stdout).faces, faces);
  }
});
