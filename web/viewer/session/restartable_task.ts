// SPDX-License-Identifier: MIT
//
// Work of which only the latest request counts.

/** A task that begins anew with each request, which ends the run before. */
export class RestartableTask {
  #running: AbortController | undefined;

  get isRunning(): boolean {
    return this.#running !== undefined;
  }

  /** Resolves to whether the work is done: another run and a cancel abort its signal. */
  async run(work: (signal: AbortSignal) => Promise<void>): Promise<boolean> {
    this.cancel();
    this.#running = new AbortController();
    const { signal } = this.#running;
    try {
      await work(signal);
      return true;
    } catch (error) {
      if (!signal.aborted) throw error;
      return false;
    } finally {
      if (!signal.aborted) this.#running = undefined;
    }
  }

  cancel(): void {
    this.#running?.abort();
    this.#running = undefined;
  }
}
