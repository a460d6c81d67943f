// SPDX-License-Identifier: MIT
//
// The bar of `--progress`.

const width = 40;

/** A bar on standard error: drawn in place on a terminal, else a line per tenth. */
export class ProgressBar {
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
