// SPDX-License-Identifier: MIT
//
// The content of an element: it connects the session, the scene and the tools.

import type { SurfacePath } from 'geodesic-voronoi';
import {
  namingAttributes,
  openingAttributes,
  samplingAttributes,
} from './attributes/attribute_defaults.js';
import type { Attributes } from './attributes/attribute_values.js';
import { formatCameraOrbit } from './stage/camera_orbit.js';
import { commandOf, isOfView, perform } from './tools/commands.js';
import { DerivedDrawings } from './layers/derived_drawings.js';
import { Legend } from './layers/legend.js';
import type { Emit } from './events.js';
import { hexagonEnergy } from './session/hexagon_energy.js';
import { Hover, type HoveredPoint } from './tools/hover.js';
import type { OpenedMesh, Opening, Reader, SiteSampling } from './session/mesh_opening.js';
import { OpenModel } from './model/open_model.js';
import { PageScrolling } from './tools/page_scrolling.js';
import type { DrawnPixels } from './stage/picture_file.js';
import { PointerGestures } from './tools/pointer_gestures.js';
import { Session } from './session/session.js';
import type { DrawingUpdate, SessionListener } from './session/session_listener.js';
import { factsOf, type ShownDiagram } from './session/shown_diagram.js';
import type { PointList, Site, SitePlace } from './session/site_history.js';
import { SiteSelection } from './tools/site_selection.js';
import { type ContextListener, SharedRenderer } from './stage/shared_renderer.js';
import { Stage } from './stage/stage.js';
import { SurfaceTools, type Workpiece } from './tools/surface_tools.js';
import { themeOf, watchTheme } from './drawing/theme.js';
import { paddingAround } from './stage/view_padding.js';
import { watchNearness, watchPixelRatio } from './stage/watching.js';

/** In milliseconds, short enough for the eye to follow the markers of sites. */
const longestGlide = 250;

/** The element that a viewer fills, as the viewer sees it. */
interface ViewerHost extends ContextListener {
  readonly attributes: Attributes;
  readonly emit: Emit;
  readonly hint: (sentence: string) => void;
}

/** The session's model, sites and diagram on the stage, with the tools to edit them. */
export class Viewer implements Workpiece {
  readonly attributes: Attributes;
  readonly stage: Stage;
  readonly session: Session;
  readonly hover: Hover;
  readonly tools: SurfaceTools;
  readonly scrolling: PageScrolling;
  readonly hint: (sentence: string) => void;
  readonly legend: Legend;
  readonly selection = new SiteSelection(this, () => this.#showSites());
  readonly #emit: Emit;
  readonly #gestures: PointerGestures;
  #model: OpenModel | undefined;
  /** What is being opened; after that, what is shown, or could not be opened if nothing is. */
  #read: Reader | undefined;
  /** Whether the model that was asked for last is there. */
  #opening: Promise<boolean> | undefined;
  /** The time at which an iteration last moved the sites. */
  #lastIteration = 0;
  #gliding = 0;
  readonly #derived: DerivedDrawings;
  /** Ends with the viewer, which tells nothing afterwards. */
  readonly #watching: AbortController;

  /** Throws a `NoWebGlError` if there is no WebGL 2. If it throws, its caller ends `watching`. */
  constructor(canvas: HTMLCanvasElement, host: ViewerHost, watching: AbortController) {
    this.#watching = watching;
    const { signal } = watching;
    // Taken before anything listens on the canvas, because there may be no WebGL 2.
    const renderer = SharedRenderer.take(
      {
        contextLost: () => host.contextLost(),
        contextRestored: () => {
          host.contextRestored();
          this.stage.invalidate();
        },
      },
      signal,
    );
    this.attributes = host.attributes;
    this.#emit = (type, detail) => {
      if (!signal.aborted) host.emit(type, detail);
    };
    this.hint = host.hint;
    this.tools = new SurfaceTools(this);
    this.#gestures = new PointerGestures(canvas, this.tools, signal);
    const touchAction = () => this.attributes.touchAction;
    this.scrolling = new PageScrolling(canvas, touchAction, this.hint, signal);
    this.stage = new Stage(canvas, renderer, () => {
      this.tools.follow();
      this.#emit('camera-change', { orbit: formatCameraOrbit(this.stage.camera.orbit) });
    });
    const root = canvas.getRootNode() as ShadowRoot;
    this.legend = new Legend(root);
    this.#derived = new DerivedDrawings(this, this.#emit);
    this.session = new Session(
      this.attributes.diagram,
      async (data, sites) => this.#model?.prepare(data, sites),
      this.#sessionListener(),
    );
    this.hover = new Hover(this.session, (point, path) => this.#tellHovered(point, path));
    const resizing = new ResizeObserver(() => {
      this.stage.resize(canvas.clientWidth, canvas.clientHeight, paddingAround(canvas));
      this.scrolling.update();
    });
    resizing.observe(canvas);
    resizing.observe(root.host); // whose padding may change alone
    signal.addEventListener('abort', () => resizing.disconnect());
    watchPixelRatio(() => this.stage.invalidate(), signal);
    watchNearness(canvas, (isNear) => (this.stage.inView = isNear), signal);
    canvas.addEventListener('keydown', (event) => {
      const command = commandOf(event);
      const mayEdit = this.attributes.interactive === 'edit';
      if (command === undefined || !(mayEdit || isOfView(command))) return;
      event.preventDefault();
      // A key that is held repeats its command; a tessellation would begin and pause by turns.
      if (event.repeat && command === 'play-cvt') return;
      perform(command, this);
    });
    watchTheme(() => this.#adoptTheme(), signal);
  }

  get model(): OpenModel | undefined {
    return this.#model;
  }

  /** The density per input vertex when painting last came to rest; undefined if 1 everywhere. */
  get density(): Float64Array | undefined {
    return this.#model?.density?.perVertex;
  }

  set density(density: ArrayLike<number> | undefined) {
    if (!this.#model) return;
    this.#model.paint.density = density;
    this.recordDensity();
  }

  /** Opens a model; resolves to whether it is there now. */
  open(read: Reader): Promise<boolean> {
    return this.#open(read, this.attributes.opening);
  }

  /** Opens the model anew, made otherwise of its files. The sites and density that it has stay. */
  async rebuild(): Promise<void> {
    const { attributes, session } = this;
    const isShown = this.#read === session.reader;
    // A mesh whose library has stopped cannot tell where its sites and density are.
    if (isShown && session.hasStopped && !(await session.reopen())) return;
    if (!this.#read) return;
    const mesh = isShown ? session.mesh : undefined;
    const sites = () => {
      if (attributes.differ(samplingAttributes)) return undefined;
      session.pauseCvt(); // or they would not come to rest
      return session.sites;
    };
    const kept = mesh && { mesh, sites, tints: () => session.tints };
    await this.#open(this.#read, { ...attributes.opening, kept });
  }

  async #open(read: Reader, how: Opening): Promise<boolean> {
    this.#read = read; // now, so that attributes that change meanwhile rebuild this model
    this.#opening = this.session.open(read, how);
    let opening: Promise<boolean>;
    let isOpen: boolean;
    // A rebuild meanwhile opens the same model in its place.
    do {
      opening = this.#opening;
      isOpen = await opening;
    } while (opening !== this.#opening && read === this.#read);
    if (!isOpen && read === this.#read) this.#read = this.session.reader ?? read;
    return isOpen;
  }

  /** Applies the metric and the detail of the attributes. */
  configure(): void {
    this.session.configure(this.attributes.diagram);
  }

  addSite(place: SitePlace): void {
    this.edit(() => this.selection.select(this.session.addSite(place)));
  }

  moveSite(index: number, place: SitePlace, isSameStep = false): void {
    const { id } = this.#siteAt(index);
    this.edit(() => {
      this.session.moveSite(id, place, isSameStep);
      this.session.endMove();
    });
  }

  removeSite(index: number): void {
    const { id } = this.#siteAt(index);
    this.edit(() => this.session.removeSite(id));
  }

  #siteAt(index: number): Site {
    const { sites } = this.session;
    if (sites[index]) return sites[index];
    throw new RangeError(`There is no site ${index}: the number of sites is ${sites.length}.`);
  }

  replaceSites(sites: PointList): void {
    this.edit(() => this.session.replaceSites(sites));
  }

  async sampleSites(siteSampling: SiteSampling): Promise<void> {
    const isPlaying = this.session.cvtStatus === 'running';
    const isDone = await this.session.sampleSites({ ...siteSampling, density: this.density });
    if (isPlaying && isDone) this.playCvt();
  }

  /** Changes sites or density; a tessellation that plays goes on with them as they are then. */
  edit(change: () => void): void {
    const isPlaying = this.session.cvtStatus === 'running';
    change();
    if (isPlaying) this.playCvt();
  }

  sitePosition(index: number): { x: number; y: number } | undefined {
    if (!this.#model || !this.session.sites[index]) return undefined;
    const place = this.#model.drawing.sites.place(index);
    const client = this.stage.projection(this.stage.toPage)(place);
    return client && !this.#model.hidesSite(index, this.stage.camera.object) ? client : undefined;
  }

  /** The pixels of the view, `scale` times as large, without the mark of the selected site. */
  picture(scale: number): Promise<DrawnPixels> {
    const sites = this.#model?.drawing.sites;
    if (sites) sites.selected = -1;
    try {
      return this.stage.read(scale); // which draws at once, and then waits for the pixels
    } finally {
      if (sites) sites.selected = this.selection.index;
    }
  }

  recordDensity(): void {
    if (!this.#model) return;
    this.edit(() => {
      this.session.recordDensity(this.#model?.paint.tints?.slice());
      this.#adoptDensity();
    });
  }

  playCvt(): void {
    const { cvt, cvtIterations } = this.attributes;
    this.session.playCvt(cvtIterations, { ...cvt, density: this.density });
  }

  stepCvt(): void {
    this.session.stepCvt({ ...this.attributes.cvt, density: this.density });
  }

  refit(): void {
    if (this.#model) this.stage.camera.frame(this.#model.drawing.mesh.positions);
  }

  /** Turns the model so that its upward axis points up. */
  adoptUpAxis(): void {
    this.stage.camera.up = this.attributes.upOf(this.session.mesh?.info);
  }

  /** Moves the camera to where the attribute says, if it is set. */
  orbit(): void {
    const { cameraOrbit } = this.attributes;
    if (cameraOrbit) this.stage.camera.orbit = cameraOrbit;
  }

  cancel(): void {
    if (this.#gestures.dragging) this.#gestures.cancel();
    else this.session.cancel();
  }

  showLayers(): void {
    this.#model?.drawing.show(new Set(this.attributes.layers));
    this.stage.invalidate();
    this.#derived.update();
  }

  explode(): void {
    this.#derived.update();
    this.#derived.spread();
  }

  dispose(): void {
    cancelAnimationFrame(this.#gliding);
    this.#gestures.cancel();
    this.session.dispose();
    this.#derived.dispose();
    this.#model?.dispose();
    this.#model = undefined;
    this.stage.dispose();
    this.#watching.abort();
  }

  #sessionListener(): SessionListener {
    return {
      modelChanged: (opened) => {
        const { mesh, name } = opened;
        this.attributes.keep(openingAttributes);
        this.#showModel(opened);
        this.#emit('progress', { totalProgress: 1, reason: 'loading' });
        this.#emit('load', { name, info: mesh.info, parts: mesh.parts });
      },
      sitesChanged: () => this.#showSites(),
      densityChanged: (tints) => {
        if (this.#model) this.#model.paint.tints = tints;
        this.#adoptDensity();
      },
      diagramChanged: (shown, milliseconds, update) => {
        this.#showDiagram(shown, update);
        this.#emit('diagram', factsOf(shown, milliseconds));
      },
      cvtRested: (shown, milliseconds) => this.#emit('diagram', factsOf(shown, milliseconds)),
      cvtIterated: (shown, { iteration, energy, largestMove }, update) => {
        this.#showDiagram(shown, update);
        const least =
          shown.summary && hexagonEnergy(shown.summary, this.#model?.density?.rootIntegral);
        const relativeEnergy = energy / (least ?? NaN);
        this.#emit('cvt-iteration', { iteration, energy, relativeEnergy, largestMove });
      },
      cvtStatusChanged: (status) => this.#emit('cvt-change', { status }),
      settingsRestored: (settings) => {
        const { opening, sampling } = this.session;
        // What is still under way has not failed.
        this.attributes.restore(settings, [
          ...(opening.isRunning ? [] : openingAttributes),
          ...(sampling.isRunning ? [] : samplingAttributes),
        ]);
      },
      statusChanged: (status) => {
        this.#emit('status-change', { status });
        this.#derived.update();
      },
      progressed: (totalProgress) => {
        const reason = this.session.status === 'loading' ? 'loading' : 'computing';
        this.#emit('progress', { totalProgress, reason });
      },
      failed: (type, cause) => {
        const message = cause instanceof Error ? cause.message : String(cause);
        this.#emit('error', { type, message: namingAttributes(message), cause });
      },
    };
  }

  #showModel(opened: OpenedMesh): void {
    const before = this.#model;
    this.#model = undefined; // a stroke on it that ends here paints nothing
    this.#gestures.cancel();
    this.#derived.clear();
    this.hover.moveTo(undefined);
    if (before) {
      this.stage.remove(before.drawing.object);
      before.dispose();
    }
    this.#model = new OpenModel(opened, themeOf(this.stage.canvas));
    this.#model.paint.tints = opened.tints;
    this.#adoptDensity();
    this.stage.add(this.#model.drawing.object);
    this.showLayers();
    this.adoptUpAxis();
    this.refit();
    this.orbit();
  }

  #adoptTheme(): void {
    const theme = themeOf(this.stage.canvas);
    if (!this.#model || this.#model.drawing.theme === theme) return;
    this.#model.drawing.theme = theme;
    this.stage.invalidate();
  }

  #showSites(): void {
    if (!this.#model) return;
    const { session } = this;
    const selected = this.selection.index;
    this.#model.drawing.sites.set(session.sites, selected, this.#glideTime());
    this.#glideSites();
    this.#emit('sites-change', {
      count: session.sites.length,
      selected,
      canUndo: session.canUndo,
      canRedo: session.canRedo,
    });
  }

  /** Milliseconds between iterations of a tessellation; 0 for other changes of sites. */
  #glideTime(): number {
    const isPlaying = this.session.cvtStatus === 'running';
    if (!isPlaying || matchMedia('(prefers-reduced-motion: reduce)').matches) return 0;
    const last = this.#lastIteration;
    this.#lastIteration = performance.now();
    return Math.min(longestGlide, this.#lastIteration - last);
  }

  #glideSites(): void {
    this.stage.invalidate();
    if (this.#model?.drawing.sites.glide()) {
      cancelAnimationFrame(this.#gliding);
      this.#gliding = requestAnimationFrame(() => this.#glideSites());
    }
  }

  #showDiagram(shown: ShownDiagram, { changes, prepared }: DrawingUpdate): void {
    if (!this.session.sampling.isRunning) this.attributes.keep(samplingAttributes);
    const { diagram, summary, sites } = shown;
    const drawing = this.#model?.drawing;
    if (changes && diagram && summary)
      for (const change of changes) drawing?.changeDiagram(change, { diagram, summary, sites });
    else drawing?.setDiagram(diagram, prepared);
    this.stage.invalidate();
    this.hover.refresh();
  }

  #adoptDensity(): void {
    if (!this.#model) return;
    this.#model.adoptPaint();
    const isUniform = this.density === undefined;
    this.legend.showDensity(!isUniform);
    this.stage.invalidate();
    this.#emit('density-change', { isUniform });
  }

  #tellHovered(point: HoveredPoint | undefined, path: SurfacePath | undefined): void {
    const { drawing } = this.#model ?? {};
    const region = point?.region ?? -1;
    drawing?.outline.show(region);
    drawing?.setPath(path);
    this.stage.invalidate();
    this.#emit('hover', point ? { ...point, colour: drawing?.regionColour(region) } : null);
  }
}
