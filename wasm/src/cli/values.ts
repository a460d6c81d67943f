// SPDX-License-Identifier: MIT
//
// Parses the values of options on the command line.

import type { Rule } from '../base/rules.js';

/** The command line is wrong, not what it names: exit status 2. */
export class UsageError extends Error {}

/** The value that the text of an option stands for, or a UsageError that names the option. */
export type Parser<Value> = (text: string, option: string) => Value;

export const path: Parser<string> = (text) => text;

/** What a text stands for, if the rule allows that. */
function ruled<Value>(rule: Rule, read: (text: string) => Value): Parser<Value> {
  return (text, option) => {
    const value = read(text);
    if (rule.allows(value)) return value;
    throw new UsageError(`${option} is '${text}', not ${rule.words}`);
  };
}

export function choice<Name extends string>(rule: Rule): Parser<Name> {
  return ruled(rule, (text) => text as Name);
}

export function number(rule: Rule): Parser<number> {
  return ruled(rule, numberIn);
}

/** NaN for a text that is no number at all. */
function numberIn(text: string): number {
  return text.trim() === '' ? NaN : Number(text);
}

/** A text that is no number at all is the path of a file. */
export function numberOrPath(rule: Rule): Parser<number | string> {
  const parse = number(rule);
  return (text, option) => (Number.isNaN(numberIn(text)) ? text : parse(text, option));
}

/** Units per metre. */
const unitScale: Record<string, number> = {
  m: 1,
  cm: 100,
  mm: 1000,
  km: 0.001,
  in: 1 / 0.0254,
  ft: 1 / 0.3048,
};

export const units: readonly string[] = Object.keys(unitScale);

/** What lengths of the model are multiplied by, and the unit that they are in then, if it is known. */
export interface Lengths {
  scale: number;
  unit?: string | undefined;
}

/** A unit by its name, for a model in metres; or a factor, after which the unit is not known. */
export const lengths: Parser<Lengths> = (text, option) => {
  if (Object.hasOwn(unitScale, text)) return { scale: unitScale[text], unit: text };
  const scale = Number(text);
  if (scale > 0 && Number.isFinite(scale)) return { scale };
  throw new UsageError(
    `${option} is '${text}', neither a positive factor nor one of ${units.join(', ')}`,
  );
};

/** Values of some of the names: `name=N,name=N`. */
export function assignments<Name extends string>(
  names: Rule,
  values: Rule,
): Parser<Partial<Record<Name, number>>> {
  const oneName = choice<Name>(names);
  const value = number(values);
  return (text, option) =>
    Object.fromEntries(
      text
        .split(',')
        .filter((part) => part !== '')
        .map((part) => {
          const [name, ...rest] = part.split('=');
          const number = rest.join('=');
          return [oneName(name, `the name in ${option}`), value(number, `${option} ${name}`)];
        }),
    ) as Partial<Record<Name, number>>;
}
