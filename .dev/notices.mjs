// SPDX-License-Identifier: MIT
//
// The notices of what is compiled or copied into the package and was written by others, out of their
// own files.

import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { at } from './tasks.mjs';

/** Part of the WebAssembly modules: the first comment of a file of theirs is their notice. */
const compiledIn = [
  { name: 'Eigen', address: 'https://eigen.tuxfamily.org', files: ['Eigen/src/Core/Matrix.h'] },
  { name: 'tinygltf', address: 'https://github.com/syoyo/tinygltf', files: ['tiny_gltf.h'] },
  {
    name: 'JSON for Modern C++',
    address: 'https://github.com/nlohmann/json',
    files: ['nlohmann/json.hpp', 'json.hpp'],
  },
];

/** The runtime of C and C++, as Emscripten brings it. */
const runtime = `
musl (https://musl.libc.org), in core.wasm and gltf.wasm

Copyright © 2005-2020 Rich Felker, et al. MIT licence, as below.

------------------------------------------------------------------------------
Emscripten (https://emscripten.org), in core.wasm and gltf.wasm

Copyright (c) 2010-2014 Emscripten authors. MIT licence, as below.

------------------------------------------------------------------------------
LLVM libc++, libc++abi and compiler-rt (https://llvm.org), in core.wasm and gltf.wasm

Apache License 2.0 with LLVM Exceptions: https://llvm.org/LICENSE.txt
`;

/** The terms that most refer to, in the words of our own licence. */
function mitTerms() {
  const text = readFileSync(at('LICENSE'), 'utf8');
  return text.slice(text.indexOf('Permission is hereby granted'));
}

/**
 * All notices. `folders` are those that the compiler found headers in; `modules`, the npm packages
 * of which there is code in dist/.
 */
export function thirdPartyNotices(folders, modules) {
  const sections = compiledIn.map(({ name, address, files }) => {
    const paths = folders.flatMap((folder) => files.map((file) => join(folder, file)));
    const path = paths.find(existsSync);
    if (!path) throw new Error(`There is no ${files[0]} to take the notice of ${name} from.`);
    return `${name} (${address}), in the WebAssembly modules\n\n${firstComment(path)}`;
  });
  const scripts = modules.map((name) => {
    const { version, license, homepage = '' } = packageOf(name);
    return `${name} ${version} (${homepage}), ${license}\n\n${licenceOf(name)}`;
  });
  const line = `\n${'-'.repeat(78)}\n`;
  const parts = [...sections, runtime.trim(), ...scripts, `The MIT licence\n\n${mitTerms()}`];
  return `The package contains work of others, under these terms.\n${line}${parts.map((part) => part.trim()).join(`\n${line}`)}\n`;
}

/** A header's first comment that tells of a licence, without its slashes. */
function firstComment(path) {
  const lines = readFileSync(path, 'utf8').split('\n');
  const end = lines.findIndex((line) => line.trim() !== '' && !line.startsWith('//'));
  const text = lines.slice(0, end).map((line) => line.replace(/^\/\/ ?/, ''));
  return text.join('\n').replaceAll(/\n{3,}/g, '\n\n');
}

const packageOf = (name) =>
  JSON.parse(readFileSync(at('node_modules', name, 'package.json'), 'utf8'));

function licenceOf(name) {
  const files = ['LICENSE', 'LICENSE.md', 'LICENSE.txt', 'LICENCE'];
  const path = files.map((file) => at('node_modules', name, file)).find(existsSync);
  return path ? readFileSync(path, 'utf8') : 'The terms of its licence are at its address.';
}
