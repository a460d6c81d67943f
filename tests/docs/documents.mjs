// SPDX-License-Identifier: MIT
//
// The Markdown files of the repository, and what is in them.

import { readFileSync } from 'node:fs';
import { relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { documents } from '../../web/docs/make/pages.mjs';

export const root = fileURLToPath(new URL('../..', import.meta.url));

/** All Markdown files, by their paths in the repository. */
export const markdownFiles = documents.map(({ source }) => relative(root, source));

export const textOf = (path) => readFileSync(`${root}/${path}`, 'utf8');

/** The fenced blocks of a language. */
export function blocks(path, language) {
  const fences = textOf(path).matchAll(/^```(\w*)\n([\s\S]*?)^```$/gm);
  return [...fences].filter(([, name]) => name === language).map(([, , code]) => code);
}
