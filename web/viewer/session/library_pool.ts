// SPDX-License-Identifier: MIT
//
// The libraries that all elements of a page share: a few workers, one compiled module.

import {
  compileModules,
  type GeodesicVoronoi,
  type LoadOptions,
  loadWorker,
} from 'geodesic-voronoi';

/** The most workers: one processor core is left to the page. */
const mostWorkers = Math.min(4, Math.max(1, (globalThis.navigator?.hardwareConcurrency ?? 2) - 1));

interface Shared {
  readonly library: Promise<GeodesicVoronoi>;
  users: number;
}

const pool = new Set<Shared>();
let modules: Promise<LoadOptions> | undefined;

/** Provides modules that a page has fetched early; other modules are fetched when needed. */
export function provideModules(compiled: Promise<LoadOptions>): void {
  modules = compiled.catch(() => compileModules());
  // A failure is reported when a library is needed.
  modules.catch(() => {});
}

/** A library, until it is given back; its last user's return ends its worker. */
export class LibraryLease {
  readonly #shared: Shared;
  #isOver = false;

  /** Starts a library while more may run; otherwise takes the one with the fewest users. */
  constructor() {
    const [idlest] = [...pool].sort((a, b) => a.users - b.users);
    this.#shared = pool.size < mostWorkers ? started() : idlest;
    ++this.#shared.users;
  }

  get library(): Promise<GeodesicVoronoi> {
    return this.#shared.library;
  }

  release(): void {
    if (this.#isOver) return;
    this.#isOver = true;
    if (--this.#shared.users > 0) return;
    pool.delete(this.#shared);
    this.#shared.library.then((library) => library.dispose()).catch(() => {});
  }

  /** Reports that the library has stopped, so that nobody else gets it. */
  discard(): void {
    pool.delete(this.#shared);
    this.release();
  }
}

function started(): Shared {
  const shared = { library: load(), users: 0 };
  pool.add(shared);
  return shared;
}

async function load(): Promise<GeodesicVoronoi> {
  modules ??= compileModules();
  try {
    return await loadWorker(await modules);
  } catch (error) {
    modules = undefined;
    throw error;
  }
}
