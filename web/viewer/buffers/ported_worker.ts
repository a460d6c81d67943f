// SPDX-License-Identifier: MIT
//
// A worker that several share.

/**
 * A worker with several owners, each of which talks to it through a port of its own. It starts with the
 * first and ends with the last of them. Its script gets the other ends of the ports as messages.
 */
export class PortedWorker {
  readonly #start: () => Worker;
  #worker: Worker | undefined;
  /** The ports with what is to be called when the worker has stopped. */
  readonly #owners = new Map<MessagePort, () => void>();

  constructor(start: () => Worker) {
    this.#start = start;
  }

  open(stopped: () => void): MessagePort {
    this.#worker ??= this.#started();
    const { port1, port2 } = new MessageChannel();
    this.#worker.postMessage(port2, [port2]);
    this.#owners.set(port1, stopped);
    return port1;
  }

  close(port: MessagePort): void {
    port.close();
    this.#owners.delete(port);
    if (this.#owners.size > 0) return;
    this.#worker?.terminate();
    this.#worker = undefined;
  }

  #started(): Worker {
    const worker = this.#start();
    worker.onerror = () => {
      if (worker !== this.#worker) return;
      for (const stopped of [...this.#owners.values()]) stopped();
    };
    return worker;
  }
}
