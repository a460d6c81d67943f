// SPDX-License-Identifier: MIT
//
// Whether two settings are alike.

/** Whether each member of `a` is the very value that `b` has by that name. */
export function shallowEqual<Settings extends object>(a: Settings, b: Settings): boolean {
  const names = Object.keys(a) as (keyof Settings)[];
  return names.every((name) => a[name] === b[name]);
}
