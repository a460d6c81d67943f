// SPDX-License-Identifier: MIT
//
// Importing this file defines <geodesic-voronoi>; without a DOM it does nothing.

import type {
  Diagram,
  Mesh,
  MeshInfo,
  ModelFiles,
  Sampling,
  SurfacePoints,
} from 'geodesic-voronoi';
import { openingAttributes, samplingAttributes } from './attributes/attribute_defaults.js';
import { formatCameraOrbit } from './stage/camera_orbit.js';
import { type Command, commandOf, instructionsOf, perform } from './tools/commands.js';
import { fileOfPicture } from './buffers/drawing_builder.js';
import { setUpAnnouncements } from './element/announcements.js';
import { ElementShadow } from './element/element_shadow.js';
import type { CvtIteration, ViewerEventMap, ViewerEvents } from './events.js';
import { contextLost, type FailureType, sentence } from './session/failure.js';
import type { HoveredPoint } from './tools/hover.js';
import type { Reader } from './session/mesh_opening.js';
import { type Layer, layers } from './drawing/model_drawing.js';
import { droppedFiles, fetchModelFiles, givenFiles, named } from './session/model_files.js';
import { ReflectingElement } from './element/reflecting_element.js';
import type { CvtStatus, Status } from './session/session_listener.js';
import { type PointList, type SitePlace, surfacePointsOf } from './session/site_history.js';
import type { Session } from './session/session.js';
import { NoWebGlError } from './stage/shared_renderer.js';
import { watchNearness } from './stage/watching.js';
import { Viewer } from './viewer.js';

export type { Command, CvtIteration, CvtStatus, HoveredPoint, Layer, PointList, SitePlace, Status };
export type { FailureType, ViewerEventMap, ViewerEvents };
export { commandOf, layers };

/**
 * A model with its geodesic Voronoi diagram, to look at and to edit: a click adds a site, a drag
 * moves it, Delete removes it.
 *
 * web/docs/element.md has the tables of attributes, properties, events, slots, parts and variables.
 * A model opened from a file is gone when the element leaves its document; that of `src` returns.
 */
export class GeodesicVoronoiElement extends ReflectingElement {
  static readonly observedAttributes = [
    'src',
    'alt',
    'poster',
    'loading',
    'reveal',
    'interactive',
    'touch-action',
    'camera-orbit',
    ...samplingAttributes,
    ...openingAttributes,
    'metric',
    'detail',
    'layers',
    'exploded',
    'up',
    'tool',
  ] as const;

  readonly #changedAttributes = new Set<string>();
  /** There while the element is in a document. */
  #shadow: ElementShadow | undefined;
  /** There while the element is in a document and, if it is lazy, has been near the view. */
  #viewer: Viewer | undefined;
  /** Ends when the element leaves its document. */
  #connected = new AbortController();
  #isDismissed = false;

  constructor() {
    super();
    this.#reflectEvents();
    setUpAnnouncements(this, (sentence) => this.#shadow?.announce(sentence));
  }

  connectedCallback(): void {
    if (this.#shadow) return;
    this.#shadow = new ElementShadow(this);
    this.#shadow.poster = this.poster;
    this.#describe();
    this.#connected = new AbortController();
    watchNearness(this, (isNear) => isNear && this.#start(), this.#connected.signal);
    // All attributes are read here, so only later changes are to be noticed.
    this.#changedAttributes.clear();
    this.setAttribute('status', 'empty');
    if (this.loading === 'eager') this.#start();
  }

  disconnectedCallback(): void {
    // An element that is only moved is connected again by then; WebKit shows it once it is drawn anew.
    queueMicrotask(() =>
      this.isConnected ? this.#viewer?.stage.invalidate() : this.#disconnect(),
    );
  }

  adoptedCallback(): void {
    this.#shadow?.applyStyle();
  }

  attributeChangedCallback(name: string, before: string | null, after: string | null): void {
    if (before === after) return;
    if (this.#changedAttributes.size === 0) queueMicrotask(() => this.#applyAttributes());
    this.#changedAttributes.add(name);
  }

  // --- Models ---------------------------------------------------------------------------------

  /** The library's mesh of the model; disposed with the next `load` event. */
  get mesh(): Mesh | undefined {
    return this.#session?.mesh;
  }

  /** Whether there is a model. */
  get loaded(): boolean {
    return this.mesh !== undefined;
  }

  get info(): MeshInfo | undefined {
    return this.#session?.mesh?.info;
  }

  /** Opens the model at an address. Resolves to whether it succeeded; if not, `error` says why. */
  load(address: string): Promise<boolean> {
    return this.#open((task) => fetchModelFiles(address, task));
  }

  /**
   * Opens a model from a file, a list of files, or files by their paths: the model, the files that it
   * refers to and any others, or a .zip of these. `file` chooses one of several (see `listModels`).
   */
  loadFiles(files: File | Iterable<File> | ModelFiles, file?: string): Promise<boolean> {
    const given = givenFiles(files);
    return this.#open(async () => named(given, file));
  }

  /** Opens a model from dropped files or folders; to be called before the event is over. */
  loadDropped(dropped: DataTransfer): Promise<boolean> {
    const files = droppedFiles(dropped);
    return this.#open(async () => named(await files));
  }

  /** A picture of the view, `scale` times as large. */
  async toBlob(type = 'image/png', quality?: number, scale = 1): Promise<Blob> {
    if (!this.#viewer) throw new Error('The element is in no document, or has not been in view.');
    return fileOfPicture(await this.#viewer.picture(scale), { type, quality });
  }

  // --- Sites ----------------------------------------------------------------------------------

  /** The sites; setting others is a step that can be undone. Their number sets the attribute. */
  get sites(): SurfacePoints {
    return surfacePointsOf(this.#session?.sites ?? []);
  }

  set sites(sites: PointList | number | string | undefined) {
    if (sites && typeof sites === 'object') this.#editable.replaceSites(sites);
    else this.reflect('sites', sites);
  }

  /**
   * The diagram that is shown; it changes with the next `diagram` or `cvt-iteration` event, and is
   * then disposed of. There is none without sites.
   */
  get diagram(): Diagram | undefined {
    return this.#session?.shown?.diagram;
  }

  /** Replaces the sites by new ones in new places; random ones follow the density. */
  async sampleSites(
    count: number,
    seed?: number,
    sampling?: Sampling,
    perComponent?: number,
  ): Promise<void> {
    await this.#editable.sampleSites({ count, seed, sampling, perComponent });
  }

  addSite(place: SitePlace): void {
    this.#editable.addSite(place);
  }

  moveSite(index: number, place: SitePlace): void {
    this.#editable.moveSite(index, place);
  }

  /** Removes a site; the last one takes its index, all others keep theirs. */
  removeSite(index: number): void {
    this.#editable.removeSite(index);
  }

  undo(): void {
    this.#session?.undo();
  }

  redo(): void {
    this.#session?.redo();
  }

  /** The index of the selected site, -1 for none. */
  get selected(): number {
    return this.#viewer?.selection.index ?? -1;
  }

  set selected(index: number) {
    if (this.#viewer) this.#viewer.selection.index = index;
  }

  /** The area of every region, by site. `diagram` has it too, but puts all its arrays together. */
  get regionAreas(): Float64Array<ArrayBuffer> {
    return this.#session?.shown?.summary?.regionArea.slice() ?? new Float64Array();
  }

  /** The colour that a region is drawn in, as CSS has it. */
  regionColour(label: number): string | undefined {
    return this.#viewer?.model?.drawing.regionColour(label);
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
   * Moves the sites to the centroids of their regions, or goes on doing so, until the number of
   * iterations is a multiple of `cvt-iterations`. Until then it is one step to undo. Adding, moving or
   * removing a site meanwhile is a step of its own, and iterations go on from there; undoing ends them.
   * Another `cvt-method`, `cvt-tolerance` or `metric` holds from the next call, which then begins anew.
   */
  playCvt(): void {
    this.#editable.playCvt();
  }

  /** One iteration. */
  stepCvt(): void {
    this.#editable.stepCvt();
  }

  pauseCvt(): void {
    this.#session?.pauseCvt();
  }

  /** Back to the sites from before the tessellation, however often it has paused. */
  resetCvt(): void {
    this.#session?.resetCvt();
  }

  /** The density per input vertex, 1 where none is painted; undefined if it is 1 everywhere. */
  get density(): Float64Array | undefined {
    return this.#viewer?.density?.slice();
  }

  /** Values are kept between 1/1000 and 1000. Setting another density is a step that can be undone. */
  set density(density: ArrayLike<number> | undefined) {
    this.#editable.density = density;
  }

  // --- View -----------------------------------------------------------------------------------

  /** Where the camera is, as in `camera-orbit`. */
  get cameraOrbit(): string {
    return this.#viewer ? formatCameraOrbit(this.#viewer.stage.camera.orbit) : '';
  }

  set cameraOrbit(orbit: string | undefined) {
    this.reflect('camera-orbit', orbit);
  }

  /** Shows the model, if there is one, where `reveal` is 'manual'. */
  dismissPoster(): void {
    this.#isDismissed = true;
    this.#showPoster();
  }

  showPoster(): void {
    this.#isDismissed = false;
    this.#showPoster();
  }

  /**
   * Where points of the surface (x, y, z triples in the model's units) are seen, in CSS pixels from
   * the view's corner; undefined for those that the surface hides, or that are not finite.
   */
  project(positions: ArrayLike<number>): ({ x: number; y: number } | undefined)[] {
    return this.#viewer?.model?.project(positions, this.#viewer.stage) ?? [];
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

  /** The viewer with its model: without one, an edit would be lost without a word. */
  get #editable(): Viewer {
    if (this.#viewer?.model) return this.#viewer;
    throw new Error('There is no model to edit: wait for the event "load".');
  }

  async #open(read: Reader): Promise<boolean> {
    this.attributeValues.ask();
    return (await this.#started()?.open(read)) ?? false;
  }

  /** The viewer, made now if there is none; undefined outside of documents, and if it cannot be made. */
  #started(): Viewer | undefined {
    const shadow = this.#shadow;
    if (this.#viewer || !shadow || shadow.failure) return this.#viewer;
    const emit = <Type extends keyof ViewerEvents>(type: Type, detail: ViewerEvents[Type]) =>
      void this.dispatchEvent(new CustomEvent(type, { detail }));
    const host = {
      attributes: this.attributeValues,
      emit,
      hint: (text: string) => shadow.hint(text),
      contextLost: () => emit('error', { type: 'webglcontextlost', message: contextLost }),
      contextRestored: () => (shadow.isContextLost = false),
    };
    const watching = new AbortController();
    try {
      this.#viewer = new Viewer(shadow.canvas, host, watching);
    } catch (error) {
      watching.abort(); // gives back the shared renderer
      this.setAttribute('status', 'failed');
      const isMissing = error instanceof NoWebGlError;
      const { message, cause } = isMissing ? error : sentence('The view cannot be made', error);
      emit('error', { type: isMissing ? 'nowebgl' : 'loadfailure', message, cause });
    }
    return this.#viewer;
  }

  #start(): void {
    if (!this.#viewer && this.#started() && this.src) void this.load(this.src);
  }

  #disconnect(): void {
    this.#connected.abort();
    this.#viewer?.dispose();
    this.#viewer = undefined;
    this.#shadow?.dispose();
    this.#shadow = undefined;
    this.#isDismissed = false;
    this.removeAttribute('status');
  }

  /** Shows what the events tell on the element, too. */
  #reflectEvents(): void {
    this.addEventListener('status-change', ({ detail: { status } }) => {
      this.setAttribute('status', status);
      const isBusy = status === 'loading' || status === 'computing';
      if (this.#shadow) this.#shadow.progress = isBusy ? 0 : undefined;
    });
    this.addEventListener('progress', ({ detail: { totalProgress } }) => {
      if (this.#shadow) this.#shadow.progress = totalProgress;
    });
    this.addEventListener('sites-change', () => this.#describe());
    for (const type of ['load', 'diagram'])
      this.addEventListener(type, () => {
        if (this.#shadow) this.#shadow.failure = undefined;
        this.#showPoster();
      });
    // A model or a diagram that is there stays in view, and the page reports the failure.
    this.addEventListener('error', ({ detail: { type, message } }) => {
      const isThere = type === 'loadfailure' ? this.loaded : this.diagram;
      if (!this.#shadow) return;
      if (type === 'webglcontextlost') this.#shadow.isContextLost = true;
      else if (!isThere) this.#shadow.failure = message;
    });
  }

  #showPoster(): void {
    if (!this.#shadow) return;
    const { showsPoster } = this.#shadow;
    const isRevealed = this.reveal === 'auto' || this.#isDismissed;
    this.#shadow.showsPoster = !(this.loaded && isRevealed);
    if (showsPoster && !this.#shadow.showsPoster)
      this.dispatchEvent(new CustomEvent('poster-dismissed', { detail: null }));
  }

  #describe(): void {
    if (!this.#shadow) return;
    const { attributeValues, selected } = this;
    const selection =
      selected < 0 ? '' : `; site ${selected} is selected, of ${this.#session?.sites.length}`;
    this.#shadow.describe(attributeValues.label + selection, instructionsOf(attributeValues));
  }

  #applyAttributes(): void {
    const changed = new Set(this.#changedAttributes);
    this.#changedAttributes.clear();
    this.#describe();
    // Not with each change of a site: browsers ask for a picture that they do not have whenever it is set.
    if (changed.has('poster') && this.#shadow) this.#shadow.poster = this.poster;
    this.#showPoster();
    if (changed.has('loading') && this.loading === 'eager') this.#start();
    const viewer = this.#viewer;
    if (!viewer) return;
    if (changed.has('touch-action')) viewer.scrolling.update();
    if (changed.has('tool')) viewer.tools.follow();
    if (changed.has('layers')) viewer.showLayers();
    if (changed.has('exploded')) viewer.explode();
    if (changed.has('up')) viewer.adoptUpAxis();
    if (changed.has('camera-orbit')) viewer.orbit(); // by the axis that points up now
    if (changed.has('metric') || changed.has('detail')) viewer.configure();
    const { attributeValues } = this;
    if (changed.has('src') && this.src) void this.load(this.src);
    else if (attributeValues.areNew(openingAttributes)) void viewer.rebuild();
    else if (attributeValues.areNew(samplingAttributes))
      void viewer.sampleSites(attributeValues.siteSampling);
    attributeValues.ask();
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'geodesic-voronoi': GeodesicVoronoiElement;
  }
}

const registry = globalThis.customElements as CustomElementRegistry | undefined;
if (!registry?.get('geodesic-voronoi'))
  registry?.define('geodesic-voronoi', GeodesicVoronoiElement);
