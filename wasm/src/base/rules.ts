// SPDX-License-Identifier: MIT
//
// What the values of options and arguments may be. The library and the command check by the same
// rules.

import { invalidArgument } from '../api/errors.js';
import { show } from './checks.js';

export interface Rule {
  /** What a value has to be, as errors say it. */
  words: string;
  allows(value: unknown): boolean;
}

export function requireAllowed(name: string, value: unknown, { words, allows }: Rule): void {
  if (!allows(value)) throw invalidArgument(`${name} is ${show(value)}, not ${words}`);
}

export function oneOf(names: readonly string[]): Rule {
  return {
    words: `one of ${names.join(', ')}`,
    allows: (value) => names.some((name) => name === value),
  };
}

export function integers(least: number, most: number): Rule {
  return numbers(
    `an integer from ${least} to ${most}`,
    (x) => Number.isInteger(x) && x >= least && x <= most,
  );
}

export const share = numbers('a number from 0 to 1', (x) => x >= 0 && x <= 1);
export const length = numbers('a number of 0 or more', (x) => x >= 0 && x < Infinity);
export const positive = numbers('a positive number', (x) => x > 0 && x < Infinity);

export const string: Rule = { words: 'a string', allows: (value) => typeof value === 'string' };
export const boolean: Rule = {
  words: 'true or false',
  allows: (value) => typeof value === 'boolean',
};

function numbers(words: string, allows: (x: number) => boolean): Rule {
  return { words, allows: (value) => typeof value === 'number' && allows(value) };
}
