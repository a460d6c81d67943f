// SPDX-License-Identifier: MIT
//
// The libraries that all elements of a page share: a few workers, one compiled module.

import {
  compileModules,
  type GeodesicVoronoi,
  type LoadOptions,
  loadWorker,
} from 'geodesic-voronoi';

/** Leaves a core to the page. */
const mostWorkers = Math.min(4, Math.max(1, (globalThis.navigator?.hardwareConcurrency ?? 2) - 1));

interface Shared {
  readonly library: Promise<GeodesicVoronoi>;
  users: number;
}

const pool = new Set<Shared>();
let modules: Promise<LoadOptions> | undefined;

/** Modules for all libraries, if a page has asked for them before; those that are missing come when needed. */
export function provideModules(compiled: Promise<LoadOptions>): void {
  modules = compiled.catch(() => compileModules());
  // It is told of when somebody needs a library.
  modules.catch(() => {});
}

/** A library, until it is given back; its last user's return ends its worker. */
export class LibraryLease {
  readonly #shared: Shared;
  #isOver = false;

  /** Takes the one with the fewest users; another worker starts if all have some and there may be more. */
  constructor() {
    const [idlest] = [...pool].sort((a, b) => a.users - b.users);
    this.#shared = idlest && (idlest.users === 0 || pool.size >= mostWorkers) ? idlest : started();
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

  /** It has stopped: nobody else is to get it. */
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
