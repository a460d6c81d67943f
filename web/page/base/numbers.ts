// SPDX-License-Identifier: MIT
//
// Numbers as the page writes them.

export { counted, integer } from '../../../dist/base/sentences.js';
export { measure } from '../../viewer/layers/measure.js';

export function duration(milliseconds: number): string {
  if (milliseconds < 10) return `${milliseconds.toFixed(1)} ms`;
  if (milliseconds < 1000) return `${Math.round(milliseconds)} ms`;
  return `${(milliseconds / 1000).toFixed(1)} s`;
}
