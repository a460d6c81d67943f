// SPDX-License-Identifier: MIT
//
// Before npm publish: the registry's page finds the pictures and documents that README.md names by the
// repository of package.json alone.

import { readFileSync } from 'node:fs';
import { at } from './tasks.mjs';

const { repository } = JSON.parse(readFileSync(at('package.json'), 'utf8'));
if (!repository) {
  console.error(
    "package.json names no repository: on the registry, README.md's links would be dead.",
  );
  process.exitCode = 1;
}
