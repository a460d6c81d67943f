// SPDX-License-Identifier: MIT
//
// Looks up the point under the pointer in the diagram.

import type { SurfacePath } from 'geodesic-voronoi';
import { LatestTask } from '../session/latest_task.js';
import type { SurfaceHit } from '../model/picking.js';
import type { Session } from '../session/session.js';
import type { SitePlace } from '../session/site_history.js';

/** A point of the surface as the diagram sees it; if no site reaches it, `region` is -1. */
export interface HoveredPoint extends SitePlace {
  region: number;
  /** The area of the region. */
  area: number;
  /** The distance to the region's site. */
  distance: number;
}

/** Reports region, area and distance at the pointer, again whenever the diagram changes. */
export class Hover {
  readonly #session: Session;
  readonly #tell: (point: HoveredPoint | undefined, path?: SurfacePath) => void;
  readonly #asking = new LatestTask<SurfaceHit | undefined>((hit) => this.#ask(hit));
  #hit: SurfaceHit | undefined;
  /** The identity of the site that is dragged. */
  #dragged: number | undefined;

  /** `tell` gets the point and the shortest path to its region's site. */
  constructor(
    session: Session,
    tell: (point: HoveredPoint | undefined, path?: SurfacePath) => void,
  ) {
    this.#session = session;
    this.#tell = tell;
  }

  /** Sets the point under the pointer; undefined if that is beside the surface. */
  moveTo(hit: SurfaceHit | undefined): void {
    if (!hit && !this.#hit) return;
    this.#hit = hit;
    this.#dragged = undefined;
    this.#asking.request(hit, { patient: true });
  }

  /**
   * Sets the point that a site, given by its identity, is dragged to. The diagram need not be
   * asked, for the point is the site itself; just after a change, asking could take as long as the
   * change.
   */
  drag(hit: SurfaceHit, site: number): void {
    this.#hit = hit;
    this.#dragged = site;
    this.#tellDragged();
  }

  endDrag(): void {
    this.#dragged = undefined;
    this.refresh();
  }

  /** To be called when the diagram has changed. */
  refresh(): void {
    if (this.#dragged !== undefined) this.#tellDragged();
    else if (this.#hit) this.#asking.request(this.#hit, { patient: true });
  }

  #tellDragged(): void {
    const { shown } = this.#session;
    const region = shown?.sites.findIndex(({ id }) => id === this.#dragged) ?? -1;
    if (!this.#hit || region < 0) return;
    const { face, bary } = this.#hit;
    const area = shown?.summary?.regionArea[region] ?? 0;
    this.#tell({ face, bary, region, area, distance: 0 });
  }

  async #ask(hit: SurfaceHit | undefined): Promise<void> {
    const { shown } = this.#session;
    // A diagram may be replaced while it is asked; the next answer is about its successor.
    const place = hit && { face: [hit.face], bary: hit.bary };
    const located = place && (await shown?.diagram?.locate(place).catch(() => undefined));
    const path = located && (await shown?.diagram?.path(place).catch(() => undefined));
    // The pointer or the diagram has changed meanwhile: another answer follows.
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
