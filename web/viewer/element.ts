// SPDX-License-Identifier: MIT
//
// Importing this file defines <geodesic-voronoi>. Where there is no DOM it defines nothing and does no harm.

import type { Diagram, Mesh, MeshInfo, Sampling, SurfacePoints } from 'geodesic-voronoi';
import { Attributes } from './attributes.js';
import { type Command, commandOf, perform } from './commands.js';
import { fillShadow } from './element_template.js';
import type { CvtIteration, ViewerEvents } from './events.js';
import type { HoveredPoint } from './hover.js';
import type { Reader } from './mesh_opening.js';
import { type Layer, layers } from './model_drawing.js';
import { fetchModelFiles, readModelFiles } from './model_files.js';
import type { CvtStatus, Status } from './session_listener.js';
import { type SitePlace, surfacePointsOf } from './site_history.js';
import type { Session } from './session.js';
import { Viewer } from './viewer.js';

export type { Command, CvtIteration, CvtStatus, HoveredPoint, Layer, SitePlace, Status, ViewerEvents };
export { commandOf, layers };

const Base = (globalThis.HTMLElement ?? class {}) as typeof HTMLElement;

/**
 * A model with its geodesic Voronoi diagram, to look at and to edit: a click adds a site, a drag moves
 * it, Delete removes it.
 *
 * Attributes: `src` (address of a .glb or .gltf), `alt`, `sites` (how many are scattered on a new
 * model), their `seed` and `sampling` (random, farthest, poisson), `metric` (exact, dgpc), `detail` (0 …), `layers` (what is shown, separated
 * by spaces: regions, bisectors, sites, voronoi-points, dual, wireframe), `exploded` (0 … 1: how far
 * the regions are apart; then there is nothing to edit), `cvt-method` (lbfgs, lloyd),
 * `cvt-iterations`, `cvt-tolerance` (ends when an iteration lowers the energy by no more than this share;
 * default 0), `tool` (sites, density: what a press on the surface does), `brush-size` (in
 * hundredths of the model's radius), `brush-density`. `status` tells what it does.
 * Slot `poster`: shown until there is a model, and if there can be none. A model opened from a file is
 * gone when the element leaves its document; that of `src` is there again when it returns.
 */
export class GeodesicVoronoiElement extends Base {
  static readonly observedAttributes = [
    'src',
    'alt',
    'sites',
    'seed',
    'sampling',
    'metric',
    'detail',
    'layers',
    'exploded',
  ];

  readonly #attributes = new Attributes(this);
  readonly #changedAttributes = new Set<string>();
  /** There while the element is in a document. */
  #viewer: Viewer | undefined;

  connectedCallback(): void {
    if (this.#viewer) return;
    const { canvas, message } = fillShadow(this);
    canvas.ariaLabel = this.#attributes.label;
    try {
      this.#viewer = new Viewer(canvas, this.#attributes, (type, detail) => this.#emit(type, detail), {
        contextLost: () => {
          message.textContent = 'The graphics card has dropped this view; it returns when it can.';
          message.hidden = false;
          this.#emit('error', { type: 'webglcontextlost', message: message.textContent });
        },
        contextRestored: () => {
          message.hidden = true;
        },
      });
      message.hidden = true;
    } catch (cause) {
      message.textContent = 'This view needs WebGL 2, which this browser does not offer.';
      message.hidden = false;
      this.setAttribute('status', 'failed');
      this.#emit('error', { type: 'nowebgl', message: message.textContent, cause });
      return;
    }
    // All attributes are looked at here; what changes from now on is another matter.
    this.#changedAttributes.clear();
    this.setAttribute('status', 'empty');
    if (this.src) void this.load(this.src);
  }

  disconnectedCallback(): void {
    // An element that is only moved is connected again before this runs.
    queueMicrotask(() => {
      if (!this.isConnected) this.#disconnect();
    });
  }

  attributeChangedCallback(name: string, before: string | null, after: string | null): void {
    if (before === after) return;
    if (this.#changedAttributes.size === 0) queueMicrotask(() => this.#applyAttributes());
    this.#changedAttributes.add(name);
  }

  // --- Models ---------------------------------------------------------------------------------

  get src(): string {
    return this.getAttribute('src') ?? '';
  }

  set src(address: string) {
    this.setAttribute('src', address);
  }

  get alt(): string {
    return this.getAttribute('alt') ?? '';
  }

  set alt(text: string) {
    this.setAttribute('alt', text);
  }

  get status(): Status | 'failed' {
    return (this.getAttribute('status') ?? 'empty') as Status | 'failed';
  }

  /** The model as the library has it; gone with the next `load` event. */
  get mesh(): Mesh | undefined {
    return this.#session?.mesh;
  }

  get info(): MeshInfo | undefined {
    return this.#session?.mesh?.info;
  }

  /** Opens the model at an address. Resolves to whether it is there now; if not, `error` says why. */
  load(address: string): Promise<boolean> {
    return this.#open((signal, onProgress) => fetchModelFiles(address, { signal, onProgress }));
  }

  /** Opens a model from files: one .glb, or one .gltf with the files that it names. */
  loadFiles(files: Iterable<File>): Promise<boolean> {
    const list = [...files];
    return this.#open(() => readModelFiles(list));
  }

  /** A picture of the view. */
  toBlob(type = 'image/png', quality?: number): Promise<Blob> {
    return new Promise((resolve, reject) => {
      if (!this.#viewer) throw new Error('The element is not in a document.');
      const { stage } = this.#viewer;
      // The canvas keeps its picture until this task ends.
      stage.draw();
      stage.canvas.toBlob(
        (blob) => (blob ? resolve(blob) : reject(new Error('The picture cannot be made.'))),
        type,
        quality,
      );
    });
  }

  // --- Sites ----------------------------------------------------------------------------------

  /** The sites; setting them is a step that can be undone. */
  get sites(): SurfacePoints {
    return surfacePointsOf(this.#session?.sites ?? []);
  }

  set sites(sites: { face: ArrayLike<number>; bary: ArrayLike<number> }) {
    this.#session?.replaceSites(sites);
  }

  /**
   * The diagram that is shown; it changes with the next `diagram` or `cvt-iteration` event, and is then
   * disposed of. There is none without sites.
   */
  get diagram(): Diagram | undefined {
    return this.#session?.shown?.diagram;
  }

  /** Sites in new places instead of those there are. */
  async scatter(count: number, seed = 1, sampling: Sampling = 'random'): Promise<void> {
    await this.#session?.scatter({ count, seed, sampling });
  }

  addSite(place: SitePlace): void {
    this.#viewer?.addSite(place);
  }

  moveSite(index: number, place: SitePlace): void {
    this.#viewer?.moveSite(index, place);
  }

  /** The last of the sites takes its place in the list; all others keep theirs. */
  removeSite(index: number): void {
    this.#viewer?.removeSite(index);
  }

  undo(): void {
    this.#session?.undo();
  }

  redo(): void {
    this.#session?.redo();
  }

  /** The index of the chosen site, -1 for none. */
  get selected(): number {
    return this.#viewer?.selected ?? -1;
  }

  set selected(index: number) {
    if (this.#viewer) this.#viewer.selected = index;
  }

  /** Of every region, by its site; it does not have all of the diagram put together, as `diagram` does. */
  get regionAreas(): Float64Array {
    return this.#session?.shown?.summary?.regionArea.slice() ?? new Float64Array();
  }

  /** Where a site is drawn on the page; undefined if it is behind the surface. */
  sitePosition(index: number): { x: number; y: number } | undefined {
    return this.#viewer?.sitePosition(index);
  }

  /** The point of the surface that is seen at a place on the page. */
  surfaceFromPoint(clientX: number, clientY: number): SitePlace | undefined {
    if (!this.#viewer) return undefined;
    const hit = this.#viewer.tools.pick(this.#viewer.stage.toDevice(clientX, clientY));
    return hit && { face: hit.face, bary: hit.bary };
  }

  // --- Centroidal tessellation ----------------------------------------------------------------

  get cvtStatus(): CvtStatus {
    return this.#session?.cvtStatus ?? 'idle';
  }

  /**
   * Moves the sites to the centroids of their regions until the number of iterations is a multiple of
   * `cvt-iterations`, and goes on where it was paused. All of it is one step to undo; any other change of
   * the sites, and another `cvt-method`, `cvt-tolerance` or `metric`, ends it: the next one begins with the
   * sites as they are then.
   */
  playCvt(): void {
    this.#viewer?.playCvt();
  }

  /** One iteration. */
  stepCvt(): void {
    this.#viewer?.stepCvt();
  }

  pauseCvt(): void {
    this.#session?.pauseCvt();
  }

  /** Back to the sites from before. */
  resetCvt(): void {
    this.#session?.resetCvt();
  }

  /** Per input vertex, 1 where nothing is painted; undefined if that is everywhere. */
  get density(): Float64Array | undefined {
    return this.#viewer?.density?.slice();
  }

  /** Values are kept between a thousandth and a thousand. Setting it is a step that can be undone. */
  set density(density: ArrayLike<number> | undefined) {
    if (this.#viewer) this.#viewer.density = density;
  }

  // --- View -----------------------------------------------------------------------------------

  /** What is shown. */
  get layers(): readonly Layer[] {
    return this.#attributes.layers;
  }

  set layers(shown: readonly Layer[]) {
    this.setAttribute('layers', shown.join(' '));
  }

  /** How far the regions are apart, 0 … 1. */
  get exploded(): number {
    return this.#attributes.exploded;
  }

  set exploded(share: number) {
    this.setAttribute('exploded', String(share));
  }

  /** Moves the camera so that the model fills the view. */
  refit(): void {
    this.#viewer?.refit();
  }

  /** Gives up the drag, or else the work, that is under way. */
  cancel(): void {
    this.#viewer?.cancel();
  }

  perform(command: Command): void {
    if (this.#viewer) perform(command, this.#viewer);
  }

  // --- Inside ---------------------------------------------------------------------------------

  get #session(): Session | undefined {
    return this.#viewer?.session;
  }

  #open(read: Reader): Promise<boolean> {
    return this.#viewer?.open(read) ?? Promise.resolve(false);
  }

  #emit<Type extends keyof ViewerEvents>(type: Type, detail: ViewerEvents[Type]): void {
    if (type === 'status-change') {
      this.setAttribute('status', (detail as ViewerEvents['status-change']).status);
    }
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }

  #disconnect(): void {
    if (!this.#viewer) return;
    const viewer = this.#viewer;
    this.#viewer = undefined;
    viewer.dispose();
    this.shadowRoot?.replaceChildren();
    this.removeAttribute('status');
  }

  #applyAttributes(): void {
    const changed = new Set(this.#changedAttributes);
    this.#changedAttributes.clear();
    const viewer = this.#viewer;
    if (!viewer) return;
    if (changed.has('alt')) viewer.stage.canvas.ariaLabel = this.#attributes.label;
    if (changed.has('layers')) viewer.showLayers();
    if (changed.has('exploded')) viewer.explode();
    if (changed.has('metric') || changed.has('detail')) viewer.configure();
    if (changed.has('src') && this.src) void this.load(this.src);
    else if (['sites', 'seed', 'sampling'].some((name) => changed.has(name))) {
      void viewer.session.scatter(this.#attributes.scattering);
    }
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'geodesic-voronoi': GeodesicVoronoiElement;
  }
}

const registry = globalThis.customElements as CustomElementRegistry | undefined;
if (registry && !registry.get('geodesic-voronoi')) {
  registry.define('geodesic-voronoi', GeodesicVoronoiElement);
}
