// SPDX-License-Identifier: MIT
//
// Lengths and areas as they are written.

const measures = new Intl.NumberFormat('en', { maximumSignificantDigits: 3 });

/** A length or an area in the model's units, which may be of any size. */
export function measure(value: number): string {
  const plain = value === 0 || (Math.abs(value) >= 1e-3 && Math.abs(value) < 1e9);
  return plain ? measures.format(value) : value.toExponential(2);
}
