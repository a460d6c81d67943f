// SPDX-License-Identifier: MIT
//
// The samples by their files, and the one that the page opens with.

import samples from './samples.json' with { type: 'json' };

/** Whether a file is a sample. */
export function isSample(file: string | null): file is string {
  return samples.some((sample) => sample.file === file);
}

/** Where the page has a sample. */
export function sampleAddress(file: string): string {
  return `./samples/${file}`;
}

/** The model that a link names, if it names one: a sample, or a reader's own file. */
export function namedModel(hash: string): string | null {
  return new URLSearchParams(hash.slice(1)).get('model');
}

/** The address of the sample that the page opens with: a link may name one. */
export function modelOf(hash: string): string {
  const named = namedModel(hash);
  return sampleAddress(isSample(named) ? named : samples[0].file);
}
