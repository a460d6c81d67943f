// SPDX-License-Identifier: MIT
//
// The bar of `--progress`.

import type { Values } from './options.js';

const width = 40;

/** Shows how far the work is, on a terminal or if `--progress` is given. */
export async function withProgress<Result>(
  { quiet, progress }: Pick<Values<'diagram'>, 'quiet' | 'progress'>,
  work: (onProgress: (share: number) => void) => Promise<Result>,
): Promise<Result> {
  const bar = !quiet && (progress || process.stderr.isTTY) ? new ProgressBar() : undefined;
  try {
    return await work((share) => bar?.update(share));
  } finally {
    bar?.clear();
  }
}

/** A bar on standard error: drawn in place on a terminal, else a line per tenth. */
class ProgressBar {
  readonly #isTerminal = process.stderr.isTTY;
  #shown = -1;

  update(share: number): void {
    const steps = this.#isTerminal ? 100 : 10;
    const step = Math.floor(steps * share);
    if (step === this.#shown) return;
    this.#shown = step;
    const percent = `${Math.floor((100 * step) / steps)}%`.padStart(4);
    const filled = Math.round((width * step) / steps);
    process.stderr.write(
      this.#isTerminal
        ? `\r[${'='.repeat(filled)}${' '.repeat(width - filled)}]${percent}`
        : `${percent}\n`,
    );
  }

  /** Leaves no trace on a terminal. */
  clear(): void {
    if (this.#isTerminal && this.#shown >= 0) process.stderr.write('\r\x1b[K');
  }
}
