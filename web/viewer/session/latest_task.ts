// SPDX-License-Identifier: MIT
//
// Runs work that is requested more often than it can be done.

/** Runs one job at a time. Of the jobs that wait, only the latest is kept. */
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
   * Runs the job next, and ends the running one. With `patient`, that may finish first: during a
   * drag, a picture of where the site just was is better than none until it rests.
   */
  request(job: Job, { patient = false } = {}): void {
    this.#waiting = { job };
    if (!this.#running) void this.#runWaiting();
    else if (!patient) this.#running.abort();
  }

  /** Ends the running job if a newer one waits for it patiently. */
  hurry(): void {
    if (this.#waiting) this.#running?.abort();
  }

  /** Ends the running job and drops the waiting one. */
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
