// SPDX-License-Identifier: MIT
//
// The selected site, and what keys do with it.

import type { OpenModel } from '../model/open_model.js';
import type { Session } from '../session/session.js';
import type { SitePlace, Sites } from '../session/site_history.js';
import type { Stage } from '../stage/stage.js';
import type { SurfaceTools } from './surface_tools.js';

/** The object whose sites are selected. */
interface SelectionOwner {
  readonly stage: Stage;
  readonly session: Session;
  readonly model: OpenModel | undefined;
  readonly tools: SurfaceTools;
  /** Shows a sentence on the view for a moment. */
  readonly hint: (sentence: string) => void;
  /** Where a site is drawn on the page; undefined if it is behind the surface. */
  sitePosition(index: number): { x: number; y: number } | undefined;
  moveSite(index: number, place: SitePlace, isSameStep: boolean): void;
}

/** One of the sites or none; it stays selected when it moves and when others come and go. */
export class SiteSelection {
  readonly #owner: SelectionOwner;
  readonly #changed: () => void;
  /** The site's identity. */
  #id: number | undefined;
  /** The site that `nudge` moved last, and the list of sites after that: any other edit replaces the list. */
  #nudged: { index: number; sites: Sites } | undefined;

  constructor(owner: SelectionOwner, changed: () => void) {
    this.#owner = owner;
    this.#changed = changed;
  }

  /** The index of the selected site, -1 for none. */
  get index(): number {
    return this.#owner.session.sites.findIndex((site) => site.id === this.#id);
  }

  /** Selecting a hidden site turns the camera until it is seen. */
  set index(index: number) {
    const { model, session, stage } = this.#owner;
    const site = session.sites[index];
    this.select(site?.id);
    if (!model || !site || this.#owner.sitePosition(index)) return;
    stage.camera.lookAgainst(model.drawing.sites.seenFrom(index));
  }

  /** Selects a site by its identity. */
  select(id: number | undefined): void {
    this.#id = id;
    this.#changed();
  }

  /** Selects the next site in the list, or the one before. */
  step(step: 1 | -1): void {
    const count = this.#owner.session.sites.length;
    if (count === 0) return;
    const { index } = this;
    if (index < 0) this.index = step > 0 ? 0 : count - 1;
    else this.index = (index + step + count) % count;
  }

  /**
   * Moves the selected site so many CSS pixels over the view; where there is no surface it stays, and a
   * hint says so. Until something else is done, further ones are the same step to undo.
   */
  nudge(right: number, down: number): void {
    const { index } = this;
    const { hint, session, stage, tools } = this.#owner;
    if (!tools.mayEdit()) return;
    const from = this.#owner.sitePosition(index);
    const place = from && tools.pick(stage.toDevice(from.x + right, from.y + down));
    if (!place) {
      const why = from ? 'The model is not seen there' : 'The surface hides the selected site';
      hint(index < 0 ? 'No site is selected' : why);
      return;
    }
    const isSame = this.#nudged?.sites === session.sites && this.#nudged.index === index;
    this.#owner.moveSite(index, place, isSame && !session.canRedo);
    this.#nudged = { index, sites: session.sites };
  }
}
