// SPDX-License-Identifier: MIT
//
// Parses the values of options on the command line.

/** The command line is wrong, not what it names: exit status 2. */
export class UsageError extends Error {}

/** The value that the text of an option stands for, or a UsageError that names the option. */
export type Parser<Value> = (text: string, option: string) => Value;

export function listed(names: readonly string[]): string {
  return names.join(', ');
}

export const path: Parser<string> = (text) => text;

export function oneOf<Name extends string>(names: readonly Name[]): Parser<Name> {
  return (text, option) => {
    const name = names.find((known) => known === text);
    if (name !== undefined) return name;
    throw new UsageError(`${option} is '${text}', not one of ${listed(names)}`);
  };
}

function isNumber(text: string): boolean {
  return text.trim() !== '' && !Number.isNaN(Number(text));
}

export function integer(least: number, most = Number.MAX_SAFE_INTEGER): Parser<number> {
  return (text, option) => {
    const value = Number(text);
    if (isNumber(text) && Number.isInteger(value) && value >= least && value <= most) return value;
    throw new UsageError(`${option} is '${text}', not an integer from ${least} to ${most}`);
  };
}

export function number(range: { name: string; has(value: number): boolean }): Parser<number> {
  return (text, option) => {
    const value = Number(text);
    if (isNumber(text) && range.has(value)) return value;
    throw new UsageError(`${option} is '${text}', not ${range.name}`);
  };
}

/** A text that is no number at all is the path of a file. */
export function numberOrPath(least: number, most: number): Parser<number | string> {
  const number = integer(least, most);
  return (text, option) => (isNumber(text) ? number(text, option) : text);
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
    `${option} is '${text}', neither a positive factor nor one of ${listed(units)}`,
  );
};

/** Values of some of the names: `name=N,name=N`. */
export function assignments<Name extends string>(
  names: readonly Name[],
  most: number,
): Parser<Partial<Record<Name, number>>> {
  const oneName = oneOf(names);
  const value = integer(0, most);
  return (text, option) =>
    Object.fromEntries(
      text
        .split(',')
        .filter((part) => part !== '')
        .map((part) => {
          const [name, number = ''] = part.split('=', 2);
          return [oneName(name, `the name in ${option}`), value(number, `${option} ${name}`)];
        }),
    ) as Partial<Record<Name, number>>;
}
