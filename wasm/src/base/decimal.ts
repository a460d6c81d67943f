// SPDX-License-Identifier: MIT

/** The number that a word is in decimal notation, else NaN: `Number` reads 0x10, 0b1 and 0o7, too. */
export function decimal(word: string): number {
  return word.charCodeAt(0) === zero && /^0[box]/i.test(word) ? NaN : Number(word);
}

const zero = 0x30;
