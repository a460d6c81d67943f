// SPDX-License-Identifier: MIT
//
// The corpus of glTF files, read by the library: the verdicts are those of the native reader.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { load } from 'geodesic-voronoi';
import { temporaryFolder } from './temporary_folder.mjs';

const executable = fileURLToPath(
  new URL('../../build/native/tests/gvd_gltf_corpus', import.meta.url),
);

const folder = temporaryFolder();
const corpus = JSON.parse(execFileSync(executable, [folder], { maxBuffer: 2 ** 26 }));
const gvd = await load();

async function verdictOn(files) {
  try {
    const mesh = await gvd.mesh(files);
    const { faces, notes } = mesh.info;
    mesh.dispose();
    return { faces, sentence: notes.join('; ') };
  } catch (error) {
    assert.equal(error.name, 'GeodesicVoronoiError', error.stack);
    return { faces: 0, sentence: error.message };
  }
}

test('every glTF of the corpus is read or refused as it should be', async () => {
  assert.ok(corpus.length >= 150, `${corpus.length} files`);
  const bytesOf = ({ file }) => new Uint8Array(readFileSync(join(folder, file)));
  const wrong = [];
  for (const file of corpus) {
    const { name, faces, sentence, librarySentence, resources } = file;
    const verdict = await verdictOn({
      'model.gltf': bytesOf(file),
      ...Object.fromEntries(resources.map((resource) => [resource.path, bytesOf(resource)])),
    });
    const isRight = librarySentence
      ? verdict.sentence.startsWith(librarySentence)
      : verdict.sentence === sentence;
    if (!isRight || verdict.faces !== faces) wrong.push({ name, faces, sentence, verdict });
  }
  assert.deepEqual(wrong, []);
});
