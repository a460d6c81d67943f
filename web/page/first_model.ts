// SPDX-License-Identifier: MIT
//
// Chooses the model that the page opens with.

import samples from './samples.json' with { type: 'json' };

/** The address of the sample that the page opens with: a link may name one. */
export function modelOf(hash: string): string {
  const named = new URLSearchParams(hash.slice(1)).get('model');
  const { file } = samples.find((sample) => sample.file === named) ?? samples[0];
  return `./samples/${file}`;
}
