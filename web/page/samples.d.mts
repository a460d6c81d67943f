// SPDX-License-Identifier: MIT
export function makeSamples(folder: string): void;
