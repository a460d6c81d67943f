// SPDX-License-Identifier: MIT
//
// Numbers as the page writes them.

export { counted, integer } from '../../dist/sentences.js';

const measures = new Intl.NumberFormat('en', { maximumSignificantDigits: 3 });

/** A length or an area in the model's units, which may be of any size. */
export function measure(value: number): string {
  const plain = value === 0 || (Math.abs(value) >= 1e-3 && Math.abs(value) < 1e6);
  return plain ? measures.format(value) : value.toExponential(2);
}

export function duration(milliseconds: number): string {
  if (milliseconds < 10) return `${milliseconds.toFixed(1)} ms`;
  if (milliseconds < 1000) return `${Math.round(milliseconds)} ms`;
  return `${(milliseconds / 1000).toFixed(1)} s`;
}
