// SPDX-License-Identifier: MIT
//
// Work that is asked for more often than it can be done.

/** Runs one job at a time, and of those that wait only the latest. */
export class LatestTask<Job> {
  readonly #run: (job: Job, signal: AbortSignal) => Promise<void>;
  #running: AbortController | undefined;
  #waiting: { job: Job } | undefined;

  /** `run` handles its own failures; its signal says that its result is not wanted any more. */
  constructor(run: (job: Job, signal: AbortSignal) => Promise<void>) {
    this.#run = run;
  }

  /** Whether another job follows the one that runs. */
  get superseded(): boolean {
    return this.#waiting !== undefined;
  }

  /**
   * Runs the job next. With `patient`, the one that runs may finish first: while a site is dragged, a
   * picture of where it was is better than none until it rests.
   */
  request(job: Job, { patient = false } = {}): void {
    this.#waiting = { job };
    if (!this.#running) void this.#runWaiting();
    else if (!patient) this.#running.abort();
  }

  /** Ends what runs if something newer waits: the time for patience is over. */
  hurry(): void {
    if (this.#waiting) this.#running?.abort();
  }

  /** Ends what runs and forgets what waits. */
  cancel(): void {
    this.#waiting = undefined;
    this.#running?.abort();
  }

  async #runWaiting(): Promise<void> {
    while (this.#waiting) {
      const { job } = this.#waiting;
      this.#waiting = undefined;
      this.#running = new AbortController();
      try {
        await this.#run(job, this.#running.signal);
      } finally {
        this.#running = undefined;
      }
    }
  }
}
