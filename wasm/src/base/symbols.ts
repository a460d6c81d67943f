// SPDX-License-Identifier: MIT
//
// Names of methods that JavaScript itself and Node call.

/** `Symbol.dispose`, also where the runtime does not know it yet. */
export const disposeSymbol: typeof Symbol.dispose = Symbol.dispose ?? Symbol.for('Symbol.dispose');

/** What `console.log` in Node shows of an object, whose values are not its own fields. */
export const inspectSymbol = Symbol.for('nodejs.util.inspect.custom');

/** An object's tag. Where there is one, Vue makes no proxy, which could not read private fields. */
export const tagSymbol: typeof Symbol.toStringTag = Symbol.toStringTag;
