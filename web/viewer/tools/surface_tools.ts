// SPDX-License-Identifier: MIT
//
// The tools of the pointer on the surface.

import type { Vector2 } from 'three';
import type { Attributes } from '../attributes/attribute_values.js';
import { brushRing } from './brush_ring.js';
import type { Hover } from './hover.js';
import type { OpenModel } from '../model/open_model.js';
import type { SurfaceHit } from '../model/picking.js';
import type { Session } from '../session/session.js';
import type { SitePlace } from '../session/site_history.js';
import type { Stage } from '../stage/stage.js';

/** How far from a site, in CSS pixels, a pointer that is no finger takes hold of it. */
export const pointerReach = 10;
/** How far a site can be grasped at most, as a share of the distance to the nearest other one. */
const reachShare = 0.25;

/** A site by its identity and its index, and where it is on the page. */
interface DrawnSite {
  id: number;
  index: number;
  x: number;
  y: number;
}

/** The object that the tools work on and report to. */
export interface Workpiece {
  readonly stage: Stage;
  readonly session: Session;
  readonly hover: Hover;
  readonly attributes: Attributes;
  readonly model: OpenModel | undefined;
  readonly selection: { select(id: number | undefined): void };
  addSite(place: SitePlace): void;
  /** Changes the sites; a tessellation that plays goes on with them. */
  edit(change: () => void): void;
  playCvt(): void;
  /** Makes one step of everything painted since the last call. */
  recordDensity(): void;
  /** Shows a sentence on the view for a moment. */
  readonly hint: (sentence: string) => void;
}

/**
 * The tools of the pointer on the surface: add, drag and remove sites, paint density, hover. Places
 * x, y are on the page; sites are given by their identity.
 */
export class SurfaceTools {
  readonly #work: Workpiece;
  /** Where the pointer was last, on the page. */
  #pointer: { x: number; y: number } | undefined;
  /** Whether a tessellation goes on when the drag ends. */
  #playsOn = false;

  constructor(work: Workpiece) {
    this.#work = work;
  }

  /** Whether the view is exploded, or soon will be: there are no regions without a diagram. */
  get #isExploded(): boolean {
    const { attributes, session } = this.#work;
    return attributes.exploded > 0 && session.shown?.diagram !== undefined;
  }

  /** The surface at device coordinates; undefined in the exploded view. */
  pick(device: Vector2): SurfaceHit | undefined {
    const { model, stage } = this.#work;
    return this.#isExploded ? undefined : model?.picker.pick(device, stage.camera.object);
  }

  /** Adds a site there, or a dab of density. */
  useAt(device: Vector2): void {
    if (this.#work.attributes.isPainting) {
      const hit = this.#dab(device);
      this.#showBrush(hit);
      if (hit) this.#work.recordDensity();
      return;
    }
    const hit = this.pick(device);
    if (hit) this.#work.addSite(hit);
  }

  /** Whether sites can be edited by hand: not in the exploded view, as a hint says then. */
  mayEdit(): boolean {
    if (this.#isExploded) this.#work.hint('No site can be edited in the exploded view');
    return !this.#isExploded;
  }

  /** Does what a click at the centre of the view does: selects the site drawn there, or uses the tool. */
  useAtCentre(): void {
    if (!this.mayEdit()) return;
    const { attributes, stage } = this.#work;
    const { left, top, width, height } = stage.canvas.getBoundingClientRect();
    const [x, y] = [left + width / 2, top + height / 2];
    const device = stage.toDevice(x, y);
    const site = attributes.isPainting ? undefined : this.siteAt(x, y, pointerReach);
    if (site !== undefined) this.select(site);
    else if (this.pick(device)) this.useAt(device);
    else this.#work.hint('The model is not at the centre of the view');
  }

  /**
   * The site drawn nearest there; none if it is out of reach, which is a share of its distance to
   * the nearest other one: between crowded sites there is room to add some, and to turn the model.
   */
  siteAt(x: number, y: number, reach: number): number | undefined {
    const { attributes, model, session, stage } = this.#work;
    const { layers, interactive } = attributes;
    if (!model || !layers.includes('sites') || this.#isExploded || interactive !== 'edit')
      return undefined;
    const { drawing } = model;
    const toPage = stage.projection(stage.toPage);
    const nearby: DrawnSite[] = [];
    session.sites.forEach(({ id }, i) => {
      const place = toPage(drawing.sites.place(i));
      if (place && Math.hypot(place.x - x, place.y - y) <= reach * (1 + 1 / reachShare))
        nearby.push({ id, index: i, ...place });
    });
    // Rays are cast for few of them: most are out of reach, or hidden by none.
    const nearestSeen = (at: { x: number; y: number }, most: number, but?: DrawnSite) =>
      nearby
        .map((site) => ({ site, distance: Math.hypot(site.x - at.x, site.y - at.y) }))
        .filter(({ site, distance }) => site !== but && distance <= most)
        .sort((a, b) => a.distance - b.distance)
        .find(({ site }) => !model.hidesSite(site.index, stage.camera.object));
    const nearest = nearestSeen({ x, y }, reach);
    if (!nearest) return undefined;
    const isCrowded = nearestSeen(nearest.site, nearest.distance / reachShare, nearest.site);
    return isCrowded ? undefined : nearest.site.id;
  }

  select(site: number): void {
    this.#work.selection.select(site);
  }

  /** Whether a stroke of a brush begins there, rather than anything else. */
  beginStroke(x: number, y: number): boolean {
    const { attributes, stage } = this.#work;
    const isBrush = attributes.interactive === 'edit' && attributes.isPainting;
    return isBrush && this.#dab(stage.toDevice(x, y)) !== undefined;
  }

  stroke(x: number, y: number): void {
    this.#dab(this.#work.stage.toDevice(x, y));
    this.hover(x, y);
  }

  endStroke(): void {
    this.#work.recordDensity();
  }

  /** Back to the density before the stroke. */
  cancelStroke(): void {
    const { model, session } = this.#work;
    if (!model) return;
    model.paint.tints = session.tints;
    this.#showTints(model);
  }

  move(site: number, x: number, y: number): void {
    const { session, stage } = this.#work;
    stage.canvas.style.cursor = 'grabbing';
    const hit = this.pick(stage.toDevice(x, y));
    this.#pointer = { x, y };
    // While the pointer is beside the model, the site stays where it was last.
    if (!hit) return;
    this.#playsOn ||= session.cvtStatus === 'running';
    session.moveSite(site, hit);
    this.#work.hover.drag(hit, site);
  }

  endMove(): void {
    this.#work.session.endMove();
    this.#work.hover.endDrag();
    this.#playOn();
  }

  cancelMove(): void {
    this.#work.session.cancelMove();
    this.#work.hover.endDrag();
    this.#playOn();
  }

  #playOn(): void {
    if (this.#playsOn) this.#work.playCvt();
    this.#playsOn = false;
  }

  remove(site: number): void {
    this.#work.edit(() => this.#work.session.removeSite(site));
  }

  /** A click beside all sites. */
  click(x: number, y: number): void {
    const { attributes, stage } = this.#work;
    if (attributes.interactive === 'edit') this.useAt(stage.toDevice(x, y));
  }

  /** Zooming begins, towards this place. */
  approach(x: number, y: number): void {
    this.approachAt(this.#work.stage.toDevice(x, y));
  }

  /** Has the camera zoom towards the surface there, if there is any. */
  approachAt(device: Vector2): void {
    const hit = this.pick(device);
    if (hit) this.#work.stage.camera.approach(hit.place);
  }

  /**
   * To be called when the camera has moved, which brings another point under the pointer, and when
   * the tool is another one.
   */
  follow(): void {
    const { attributes, model } = this.#work;
    if (attributes.isPainting) void model?.paint.prepare(model.builder);
    if (this.#pointer) this.hover(this.#pointer.x, this.#pointer.y);
  }

  hover(x: number, y: number): void {
    this.#pointer = { x, y };
    const { attributes, hover, stage } = this.#work;
    const hit = this.pick(stage.toDevice(x, y));
    const isOverSite =
      hit && !attributes.isPainting && this.siteAt(x, y, pointerReach) !== undefined;
    const overSurface = attributes.interactive === 'edit' ? 'crosshair' : '';
    stage.canvas.style.cursor = isOverSite ? 'grab' : hit ? overSurface : '';
    hover.moveTo(hit);
    this.#showBrush(hit);
  }

  leave(): void {
    this.#pointer = undefined;
    this.#work.hover.moveTo(undefined);
    this.#showBrush(undefined);
  }

  /** Paints density there; returns the place, if there is any surface. */
  #dab(device: Vector2): SurfaceHit | undefined {
    const { attributes, model } = this.#work;
    const hit = this.pick(device);
    if (!hit || !model) return undefined;
    if (model.paint.dab(hit, attributes.brush)) this.#showTints(model);
    else this.#work.hint('The brush reaches no corner of a triangle here');
    return hit;
  }

  #showTints({ drawing, paint }: OpenModel): void {
    drawing.setTints(paint.tints);
    this.#work.stage.invalidate();
  }

  /** Shows the outline of the brush's reach; nothing beside the surface. */
  #showBrush(hit: SurfaceHit | undefined): void {
    const { attributes, model, stage } = this.#work;
    if (!model) return;
    const { drawing, picker } = model;
    const ring =
      hit && attributes.isPainting
        ? brushRing(drawing.mesh, hit, attributes.brush.radius, (place) => picker.nearest(place))
        : new Float32Array();
    if (drawing.setBrush(ring)) stage.invalidate();
  }
}
