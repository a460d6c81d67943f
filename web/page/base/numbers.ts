// SPDX-License-Identifier: MIT
//
// Numbers as the page writes them.

export { counted, integer } from '../../../dist/base/sentences.js';
export { measure } from '../../viewer/layers/measure.js';

/** The figure and its unit stay on one line. */
export function duration(milliseconds: number): string {
  if (milliseconds < 10) return `${milliseconds.toFixed(1)}\u00a0ms`;
  if (milliseconds < 1000) return `${Math.round(milliseconds)}\u00a0ms`;
  return `${(milliseconds / 1000).toFixed(1)}\u00a0s`;
}
