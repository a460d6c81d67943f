// SPDX-License-Identifier: MIT
//
// Links in the documents lead somewhere: to files that are there, and to headings in them.

import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { documents, outlineOf } from '../../web/docs/make/pages.mjs';
import { markdownFiles, root, textOf } from './documents.mjs';

/** Made by other tools; whether they are there is up to those. */
const isReference = (path) => path.startsWith('web/docs/api/');

for (const source of markdownFiles) {
  test(`links of ${source}`, () => {
    for (const href of outlineOf(textOf(source)).links) {
      if (/^[a-z]+:/.test(href)) continue;
      const [path, anchor] = href.split('#');
      const target = path ? join(dirname(source), path) : source;
      if (isReference(target)) continue;
      assert.ok(existsSync(join(root, target)), `${href}: there is no ${target}`);
      if (anchor)
        assert.ok(outlineOf(textOf(target)).anchors.includes(anchor), `${href}: no such heading`);
    }
  });
}

test('links of the pages', () => {
  const folder = join(root, 'build/page/docs');
  const pageOf = (name) =>
    readFileSync(join(folder, name), 'utf8').replace(/<pre[^>]*>[^]*?<\/pre>/g, '');
  for (const { target: name } of documents) {
    for (const [, href] of pageOf(name).matchAll(/(?:href|src)="([^"]+)"/g)) {
      if (/^[a-z]+:/.test(href)) continue;
      const [path, anchor] = href.split('#');
      const target = path || name;
      assert.ok(existsSync(join(folder, target)), `${name}: ${href}`);
      if (anchor && !target.startsWith('api/'))
        assert.ok(pageOf(target).includes(`id="${anchor}"`), `${name}: ${href}: no such heading`);
    }
  }
  const sections = /<nav class="sections"[^>]*>([^]*?)<\/nav>/.exec(pageOf('guide.html'))[1];
  assert.match(sections, /^<a href="#a-mesh">A mesh<\/a>\n/);
});

test('names of files and folders in the documents exist', () => {
  const paths = /`((?:core|wasm|web|tests|\.dev|\.github)\/[\w./-]*)`/g;
  for (const source of markdownFiles) {
    for (const [, path] of textOf(source).matchAll(paths)) {
      assert.ok(existsSync(join(root, path)), `${source} names ${path}`);
    }
  }
});
