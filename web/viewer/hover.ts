// SPDX-License-Identifier: MIT
//
// What is known of the point under the pointer.

import type { SurfacePath } from 'geodesic-voronoi';
import { LatestTask } from './latest_task.js';
import type { SurfaceHit } from './picking.js';
import type { Session } from './session.js';
import type { SitePlace } from './site_history.js';

/** A point of the surface as the diagram sees it; if no site reaches it, `region` is -1. */
export interface HoveredPoint extends SitePlace {
  region: number;
  /** Of the region. */
  area: number;
  /** To the region's site. */
  distance: number;
}

/** Tells what the diagram says of the point under the pointer, and again when the diagram changes. */
export class Hover {
  readonly #session: Session;
  readonly #tell: (point: HoveredPoint | undefined, path?: SurfacePath) => void;
  readonly #asking = new LatestTask<SurfaceHit | undefined>((hit) => this.#ask(hit));
  #hit: SurfaceHit | undefined;

  /** `tell` also gets the shortest path to the region's site. */
  constructor(
    session: Session,
    tell: (point: HoveredPoint | undefined, path?: SurfacePath) => void,
  ) {
    this.#session = session;
    this.#tell = tell;
  }

  /** The pointer is there now; undefined if it is beside the surface. */
  moveTo(hit: SurfaceHit | undefined): void {
    if (!hit && !this.#hit) return;
    this.#hit = hit;
    this.#asking.request(hit, { patient: true });
  }

  /** The diagram is another one now. */
  refresh(): void {
    if (this.#hit) this.#asking.request(this.#hit, { patient: true });
  }

  async #ask(hit: SurfaceHit | undefined): Promise<void> {
    const { shown } = this.#session;
    // A diagram may be replaced while it is asked; the next answer is about its successor.
    const place = hit && { face: [hit.face], bary: hit.bary };
    const located = place && (await shown?.diagram?.locate(place).catch(() => undefined));
    const path = located && (await shown?.diagram?.path(place).catch(() => undefined));
    // The pointer or the diagram has moved on: its own answer follows.
    if (hit !== this.#hit || shown !== this.#session.shown) return;
    if (!hit || !located) {
      this.#tell(undefined);
      return;
    }
    const region = located.label[0];
    const point = {
      face: hit.face,
      bary: hit.bary,
      region,
      area: shown?.summary?.regionArea[region] ?? 0,
      distance: located.distance[0],
    };
    this.#tell(point, path);
  }
}
