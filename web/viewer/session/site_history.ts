// SPDX-License-Identifier: MIT
//
// Sites and density, with the steps that can be undone.

import type { SurfacePoints } from 'geodesic-voronoi';
import { shallowEqual } from './shallow_equal.js';

/** A site as the viewer edits it. The identity stays when it moves and when others come and go. */
export interface Site {
  readonly id: number;
  readonly face: number;
  readonly bary: readonly [number, number, number];
}

export type SitePlace = Pick<Site, 'face' | 'bary'>;
export type Sites = readonly Site[];
/** Points of the surface, in arrays of any kind. */
export type PointList = { face: ArrayLike<number>; bary: ArrayLike<number> };

export function surfacePointsOf(sites: Sites): SurfacePoints {
  return {
    face: Int32Array.from(sites, (site) => site.face),
    bary: Float64Array.from(sites.flatMap((site) => site.bary)),
  };
}

export function placeOf({ face, bary }: PointList, i: number): SitePlace {
  return { face: face[i], bary: [bary[3 * i], bary[3 * i + 1], bary[3 * i + 2]] };
}

/** Whether sites are where others are, in the same order. */
export function areSamePlaces(some: Sites, others: Sites): boolean {
  return (
    some.length === others.length &&
    some.every(({ face, bary }, i) => face === others[i].face && shallowEqual(bary, others[i].bary))
  );
}

/** What a caller gives as a place; the library refuses one that is not on the surface. */
function checked(place: SitePlace): SitePlace {
  const { face, bary } = place ?? {};
  if (Number.isInteger(face) && bary?.length === 3) return { face, bary };
  throw new TypeError(
    'A place is { face, bary }, with the index of a triangle and three coordinates.',
  );
}

/** A density as it is painted: see `DensityPaint.tints`. */
export type Tints = Float32Array | undefined;

export function isSameDensity(a: Tints, b: Tints): boolean {
  return a === b || (a?.length === b?.length && a?.every((tint, v) => tint === b?.[v]) === true);
}

/** The state that is edited. */
interface State {
  sites: Sites;
  tints: Tints;
}

/** How many steps can be undone: each may hold a number per vertex, or a list of all sites. */
const mostSteps = 100;

/**
 * The sites and the density, with the states to undo and redo. Each step changes one of the two.
 * Lists are never changed, only replaced.
 */
export class SiteHistory {
  #past: State[] = [];
  #present: State = { sites: [], tints: undefined };
  #future: State[] = [];
  /** What could be redone before the last step. */
  #futureBefore: State[] = [];
  #lastId = 0;
  /** The site that is being moved, and whether that is a step already. */
  #move: { id: number; isRecorded: boolean } | undefined;

  /** The sites. */
  get present(): Sites {
    return this.#present.sites;
  }

  get tints(): Tints {
    return this.#present.tints;
  }

  get canUndo(): boolean {
    return this.#past.length > 0;
  }

  get canRedo(): boolean {
    return this.#future.length > 0;
  }

  /** Whether a site is being moved: until `endMove` or `cancelMove`. */
  get isMoving(): boolean {
    return this.#move !== undefined;
  }

  /** A site with a new identity. */
  create(place: SitePlace): Site {
    return { id: ++this.#lastId, ...checked(place) };
  }

  /** A diagram's labels of removed sites, whose face is -1, are left out. */
  createAll(points: PointList): Sites {
    if (!points?.face || points.bary?.length !== 3 * points.face.length)
      throw new TypeError(
        'Sites are { face, bary }, three coordinates each; mesh.readPoints makes them of other forms.',
      );
    return Array.from(points.face, (_, i) => placeOf(points, i))
      .filter(({ face }) => face !== -1)
      .map((place) => this.create(place));
  }

  /** Begins anew: nothing to undo. */
  reset(sites: Sites, tints?: Tints): void {
    this.#past = [];
    this.#present = { sites, tints };
    this.#future = [];
    this.#move = undefined;
  }

  /** A step that can be undone. It ends a move: what follows of that is another step. */
  record(sites: Sites): void {
    this.endMove();
    this.#step({ ...this.#present, sites });
  }

  recordTints(tints: Tints): void {
    this.endMove();
    this.#step({ ...this.#present, tints });
  }

  /** Changes the last step, as a drag does after its first move. */
  revise(sites: Sites): void {
    this.#present = { ...this.#present, sites };
  }

  /**
   * Moves a site; all moves until `endMove` are one step, or with `isSameStep` still the last one.
   * Returns whether the site is there.
   */
  move(id: number, place: SitePlace, isSameStep: boolean): boolean {
    const { face, bary } = checked(place);
    if (!this.present.some((site) => site.id === id)) return false;
    if (this.#move?.id !== id) this.#move = { id, isRecorded: isSameStep };
    const moved = this.present.map((site) => (site.id === id ? { id, face, bary } : site));
    if (this.#move.isRecorded) this.revise(moved);
    else this.#step({ ...this.#present, sites: moved });
    this.#move.isRecorded = true;
    return true;
  }

  endMove(): void {
    this.#move = undefined;
  }

  /**
   * Takes the step of a site that is being moved back, as if it had never been: what was undone
   * before can be redone. Returns whether there was one.
   */
  cancelMove(): boolean {
    const before = this.#move && this.#past.pop();
    this.#move = undefined;
    if (!before) return false;
    this.#present = before;
    this.#future = this.#futureBefore;
    return true;
  }

  undo(): void {
    const before = this.#past.pop();
    if (!before) return;
    this.#future.push(this.#present);
    this.#present = before;
  }

  redo(): void {
    const after = this.#future.pop();
    if (!after) return;
    this.#past.push(this.#present);
    this.#present = after;
  }

  /** Undoes or redoes until this list is there again; if no step has it, the last one gets it. */
  returnTo(sites: Sites): void {
    const isIn = (states: readonly State[]) => states.some((state) => state.sites === sites);
    this.#move = undefined;
    if (this.present === sites) return;
    if (isIn(this.#past)) while (this.present !== sites) this.undo();
    else if (isIn(this.#future)) while (this.present !== sites) this.redo();
    else this.revise(sites);
  }

  #step(state: State): void {
    this.#past.push(this.#present);
    if (this.#past.length > mostSteps) this.#past.shift();
    this.#present = state;
    this.#futureBefore = this.#future;
    this.#future = [];
  }
}
