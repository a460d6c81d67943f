// SPDX-License-Identifier: MIT
//
// Importing this file defines <geodesic-voronoi>. Where there is no DOM it defines nothing and does no harm.

import type {
  CvtMethod,
  Diagram,
  DiagramData,
  Mesh,
  MeshInfo,
  MeshPart,
  Metric,
  Partition,
  PolygonMesh,
  Sampling,
  SurfacePoints,
  Violation,
} from 'geodesic-voronoi';
import { Vector2 } from 'three';
import { brushRing } from './brush_ring.js';
import { CellBuilder } from './cell_builder.js';
import { type Command, commandOf } from './commands.js';
import type { CvtSettings } from './cvt_run.js';
import { type Brush, DensityPaint } from './density_paint.js';
import { Derived } from './derived.js';
import { fillShadow } from './element_template.js';
import { hexagonEnergy, rootDensityIntegral } from './hexagon_energy.js';
import { Hover, type HoveredPoint } from './hover.js';
import { widestSpread } from './exploded_parts.js';
import { type DrawnDiagram, type Layer, layers, ModelDrawing } from './model_drawing.js';
import { fetchModelFiles, type ModelFiles, readModelFiles } from './model_files.js';
import { Picker, type SurfaceHit } from './picking.js';
import { PointerGestures } from './pointer_gestures.js';
import { SceneMesh } from './scene_mesh.js';
import {
  type CvtStatus,
  type Drawable,
  type Scattering,
  Session,
  type ShownDiagram,
  type Status,
} from './session.js';
import { type SitePlace, type Sites, surfacePointsOf } from './site_history.js';
import { Stage } from './stage.js';

export type { Command, CvtStatus, HoveredPoint, Layer, SitePlace, Status };
export { commandOf, layers };

/** What an iteration of a centroidal tessellation has come to. */
export interface CvtIteration {
  /** 0: the sites from before. */
  iteration: number;
  /** Σ ∫ ρ d² over the regions, d the distance to the region's site, ρ the density. It never rises. */
  energy: number;
  /**
   * The energy as a multiple of that of as many regular hexagons of the same area in the plane: the
   * least there is where the surface is not curved. With a density, that of hexagons as large as it
   * asks for.
   */
  relativeEnergy: number;
  /** How far the site that has moved furthest has, in the model's units. */
  largestMove: number;
}

/** The `detail` of this element's events, by their name. */
export interface ViewerEvents {
  /** A model was opened. */
  load: { name: string; info: MeshInfo; parts: readonly MeshPart[] };
  /** Something failed, in a sentence; everything is as it was before. */
  error: { type: 'loadfailure' | 'nowebgl' | 'webglcontextlost'; message: string; cause?: unknown };
  /** A diagram is drawn. */
  diagram: {
    sites: number;
    regions: number;
    segments: number;
    arcs: number;
    voronoiPoints: number;
    metric: Metric;
    detail: number;
    /** From asking for it to having it. */
    milliseconds: number;
  };
  /** The dual is drawn; null: it is not any more. It is a picture of the surface if nothing is wrong. */
  dual: { polygons: number; violations: readonly Violation[] } | null;
  /** The regions are drawn apart; null: they are together again. */
  exploded: { regions: number; triangles: number } | null;
  /** The sites or the choice of one changed; the diagram follows. */
  'sites-change': { count: number; selected: number; canUndo: boolean; canRedo: boolean };
  /** Sites and diagram are those of an iteration now; a `diagram` event follows when it pauses. */
  'cvt-iteration': CvtIteration;
  'cvt-change': { status: CvtStatus };
  /** The density was painted, set or cleared. */
  'density-change': { isUniform: boolean };
  /** The share done, 0 … 1, of what `status` says is under way. */
  progress: { share: number };
  'status-change': { status: Status };
  /** What lies under the pointer, and its region's colour as CSS has it; null if nothing does. */
  hover: (HoveredPoint & { colour: string | undefined }) | null;
}

const defaultLayers: readonly Layer[] = ['regions', 'bisectors', 'sites'];
const defaultLabel = 'A surface with its geodesic Voronoi diagram';

/** Steps of the keys, in radians and as a factor. */
const turnStep = Math.PI / 24;
const dollyStep = 1.15;

/** What is there only while the element is in a document. */
interface Connected {
  canvas: HTMLCanvasElement;
  stage: Stage;
  session: Session;
  gestures: PointerGestures;
  hover: Hover;
  resizing: ResizeObserver;
}

/** What is there for every model. */
interface Model {
  drawing: ModelDrawing;
  picker: Picker;
  paint: DensityPaint;
  cells: CellBuilder;
}

/** As it was when it last came to rest. */
interface Density {
  perVertex: Float64Array;
  /** ∫ √ρ. */
  rootIntegral: number;
}

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

  #connected: Connected | undefined;
  #model: Model | undefined;
  #density: Density | undefined;
  #selected: number | undefined;
  readonly #changedAttributes = new Set<string>();
  readonly #dual = new Derived(
    async (diagram) => ({ dual: await diagram.dual(), violations: await diagram.violations() }),
    (result) => this.#showDual(result),
  );
  readonly #parts = new Derived(
    (diagram) => diagram.partition(),
    (parts) => this.#showParts(parts),
  );

  connectedCallback(): void {
    if (this.#connected) return;
    const { canvas, message } = fillShadow(this);
    canvas.ariaLabel = this.alt || defaultLabel;
    try {
      this.#connected = this.#connect(canvas);
      message.hidden = true;
    } catch (cause) {
      message.textContent = 'This view needs WebGL 2, which this browser does not offer.';
      message.hidden = false;
      this.setAttribute('status', 'failed');
      this.#emit('error', { type: 'nowebgl', message: message.textContent, cause });
      return;
    }
    canvas.addEventListener('webglcontextlost', () => {
      // Leaving the document gives the context up too.
      if (this.#connected?.canvas !== canvas) return;
      message.textContent = 'The graphics card has dropped this view; it returns when it can.';
      message.hidden = false;
      this.#emit('error', { type: 'webglcontextlost', message: message.textContent });
    });
    canvas.addEventListener('webglcontextrestored', () => {
      message.hidden = true;
    });
    // All attributes are looked at here; what changes from now on is another matter.
    this.#changedAttributes.clear();
    this.setAttribute('status', 'empty');
    this.#configure();
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
      const { stage, canvas } = this.#required();
      // The canvas keeps its picture until this task ends.
      stage.draw();
      canvas.toBlob(
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
    if (!this.#session?.mesh) return;
    this.#selected = this.#session.addSite(place);
    this.#showSites();
  }

  moveSite(index: number, place: SitePlace): void {
    const site = this.#session?.sites[index];
    if (!site) return;
    this.#session?.moveSite(site.id, place);
    this.#session?.endMove();
  }

  /** The last of the sites takes its place in the list; all others keep theirs. */
  removeSite(index: number): void {
    const site = this.#session?.sites[index];
    if (site) this.#session?.removeSite(site.id);
  }

  undo(): void {
    this.#session?.undo();
  }

  redo(): void {
    this.#session?.redo();
  }

  /** The index of the chosen site, -1 for none. */
  get selected(): number {
    return this.#session?.sites.findIndex((site) => site.id === this.#selected) ?? -1;
  }

  set selected(index: number) {
    this.#selected = this.#session?.sites[index]?.id;
    this.#showSites();
  }

  /** Of every region, by its site; it does not have all of the diagram put together, as `diagram` does. */
  get regionAreas(): Float64Array {
    return this.#session?.shown?.summary?.regionArea.slice() ?? new Float64Array();
  }

  /** Where a site is drawn on the page; undefined if it is behind the surface. */
  sitePosition(index: number): { x: number; y: number } | undefined {
    if (!this.#model || !this.#connected || !this.#session?.sites[index]) return undefined;
    const { camera } = this.#connected.stage;
    const place = this.#model.drawing.sitePlace(index);
    const client = this.#connected.stage.projection()(place);
    return client && !this.#model.picker.hides(place, camera) ? client : undefined;
  }

  /** The point of the surface that is seen at a place on the page. */
  surfaceFromPoint(clientX: number, clientY: number): SitePlace | undefined {
    if (!this.#connected) return undefined;
    const hit = this.#pick(this.#connected.stage.toDevice(clientX, clientY));
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
    const iterations = Math.max(1, Math.round(numberOf(this.getAttribute('cvt-iterations'), 50)));
    this.#session?.playCvt(iterations, this.#cvtSettings);
  }

  /** One iteration. */
  stepCvt(): void {
    this.#session?.stepCvt(this.#cvtSettings);
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
    return this.#density?.perVertex.slice();
  }

  /** Values are kept between a thousandth and a thousand. Setting it is a step that can be undone. */
  set density(density: ArrayLike<number> | undefined) {
    if (!this.#model) return;
    this.#model.paint.density = density;
    this.#recordDensity();
  }

  // --- View -----------------------------------------------------------------------------------

  /** What is shown. */
  get layers(): readonly Layer[] {
    const names = this.getAttribute('layers');
    if (names === null) return defaultLayers;
    const wanted = new Set(names.split(/\s+/));
    return layers.filter((layer) => wanted.has(layer));
  }

  set layers(shown: readonly Layer[]) {
    this.setAttribute('layers', shown.join(' '));
  }

  /** How far the regions are apart, 0 … 1. */
  get exploded(): number {
    return Math.min(1, Math.max(0, numberOf(this.getAttribute('exploded'), 0)));
  }

  set exploded(share: number) {
    this.setAttribute('exploded', String(share));
  }

  /** Moves the camera so that the model fills the view. */
  refit(): void {
    if (this.#model) this.#connected?.stage.frame(this.#model.drawing.mesh.positions);
  }

  /** Gives up the drag, or else the work, that is under way. */
  cancel(): void {
    const { gestures, session } = this.#connected ?? {};
    if (gestures?.dragging) gestures.cancel();
    else session?.cancel();
  }

  perform(command: Command): void {
    const { stage } = this.#connected ?? {};
    switch (command) {
      case 'undo':
        return this.undo();
      case 'redo':
        return this.redo();
      case 'remove':
        return this.removeSite(this.selected);
      case 'refit':
        return this.refit();
      case 'cancel':
        return this.cancel();
      case 'place':
        return this.#placeAt(new Vector2(0, 0));
      case 'play-cvt':
        return this.cvtStatus === 'running' ? this.pauseCvt() : this.playCvt();
      case 'next-site':
        return this.#selectNext(1);
      case 'previous-site':
        return this.#selectNext(-1);
      case 'turn-left':
        return stage?.orbit(-turnStep, 0);
      case 'turn-right':
        return stage?.orbit(turnStep, 0);
      case 'turn-up':
        return stage?.orbit(0, turnStep);
      case 'turn-down':
        return stage?.orbit(0, -turnStep);
      case 'nearer':
        return stage?.dolly(1 / dollyStep);
      case 'farther':
        return stage?.dolly(dollyStep);
    }
  }

  // --- Inside ---------------------------------------------------------------------------------

  get #session(): Session | undefined {
    return this.#connected?.session;
  }

  #required(): Connected {
    if (!this.#connected) throw new Error('The element is not in a document.');
    return this.#connected;
  }

  #emit<Type extends keyof ViewerEvents>(type: Type, detail: ViewerEvents[Type]): void {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }

  #connect(canvas: HTMLCanvasElement): Connected {
    const gestures = new PointerGestures(canvas, {
      siteAt: (x, y, reach) => this.#siteAt(x, y, reach),
      select: (site) => {
        this.#selected = site;
        this.#showSites();
      },
      beginStroke: (x, y) => this.#isPainting && this.#dab(stage.toDevice(x, y)),
      stroke: (x, y) => this.#dab(stage.toDevice(x, y)),
      endStroke: () => this.#recordDensity(),
      move: (site, x, y) => this.#drag(site, x, y),
      endMove: () => this.#session?.endMove(),
      cancelMove: () => this.#session?.cancelMove(),
      remove: (site) => this.#session?.removeSite(site),
      click: (x, y) => this.#placeAt(this.#required().stage.toDevice(x, y)),
      hover: (x, y) => this.#hover(x, y),
      leave: () => {
        this.#connected?.hover.moveTo(undefined);
        this.#showBrush(undefined);
      },
    });
    const stage = new Stage(canvas);
    const cut = async (data: DiagramData) => this.#model?.cells.build(data);
    const session = new Session(cut, {
      modelChanged: (mesh, name) => {
        this.#showModel(mesh);
        this.#emit('load', { name, info: mesh.info, parts: mesh.parts });
      },
      sitesChanged: () => this.#showSites(),
      densityChanged: (tints) => {
        if (this.#model) this.#model.paint.tints = tints;
        this.#adoptDensity();
      },
      diagramChanged: (shown, milliseconds, how) => {
        this.#showDiagram(shown, how);
        this.#tellDiagram(shown, milliseconds);
      },
      cvtRested: (shown, milliseconds) => {
        this.#derive();
        this.#tellDiagram(shown, milliseconds);
      },
      cvtIterated: (shown, { iteration, energy, largestMove }, how) => {
        this.#showDiagram(shown, how);
        const least = shown.summary && hexagonEnergy(shown.summary, this.#density?.rootIntegral);
        const relativeEnergy = energy / (least ?? NaN);
        this.#emit('cvt-iteration', { iteration, energy, relativeEnergy, largestMove });
      },
      cvtStatusChanged: (status) => this.#emit('cvt-change', { status }),
      settingsRestored: ({ metric, detail }) => {
        this.setAttribute('metric', metric);
        this.setAttribute('detail', String(detail));
      },
      statusChanged: (status) => {
        this.setAttribute('status', status);
        this.#emit('status-change', { status });
      },
      progressed: (share) => this.#emit('progress', { share }),
      failed: (cause) => {
        const message = cause instanceof Error ? cause.message : String(cause);
        this.#emit('error', { type: 'loadfailure', message, cause });
      },
    });
    canvas.addEventListener('keydown', (event) => {
      const command = commandOf(event);
      if (command === undefined) return;
      event.preventDefault();
      this.perform(command);
    });
    const resizing = new ResizeObserver(() => stage.resize(this.clientWidth, this.clientHeight));
    resizing.observe(this);
    const hover = new Hover(session, (point) => this.#tellHovered(point));
    return { canvas, stage, session, gestures, hover, resizing };
  }

  #disconnect(): void {
    if (!this.#connected) return;
    const { stage, session, gestures, resizing } = this.#connected;
    this.#connected = undefined;
    gestures.dispose();
    session.dispose();
    resizing.disconnect();
    this.#model?.drawing.dispose();
    this.#model?.cells.dispose();
    this.#model = undefined;
    stage.dispose();
    this.shadowRoot?.replaceChildren();
    this.removeAttribute('status');
  }

  #applyAttributes(): void {
    const changed = new Set(this.#changedAttributes);
    this.#changedAttributes.clear();
    if (!this.#connected) return;
    if (changed.has('alt')) this.#connected.canvas.ariaLabel = this.alt || defaultLabel;
    if (changed.has('layers')) this.#showLayers();
    if (changed.has('exploded')) this.#explode();
    if (changed.has('metric') || changed.has('detail')) this.#configure();
    if (changed.has('src') && this.src) void this.load(this.src);
    else if (['sites', 'seed', 'sampling'].some((name) => changed.has(name))) {
      void this.#session?.scatter(this.#scattering);
    }
  }

  #configure(): void {
    this.#session?.configure({
      // What is no metric is for the library to refuse, which names those there are.
      metric: (this.getAttribute('metric') ?? 'exact') as Metric,
      detail: numberOf(this.getAttribute('detail'), 0),
    });
  }

  get #cvtSettings(): CvtSettings {
    return {
      method: (this.getAttribute('cvt-method') ?? 'lbfgs') as CvtMethod,
      energyTolerance: Math.max(0, numberOf(this.getAttribute('cvt-tolerance'), 0)),
      density: this.#density?.perVertex,
    };
  }

  get #scattering(): Scattering {
    return {
      count: numberOf(this.getAttribute('sites'), 0),
      seed: numberOf(this.getAttribute('seed'), 1),
      sampling: (this.getAttribute('sampling') ?? 'random') as Sampling,
    };
  }

  #open(
    read: (signal: AbortSignal, onProgress: (share: number) => void) => Promise<ModelFiles>,
  ): Promise<boolean> {
    return this.#session?.open(read, this.#scattering) ?? Promise.resolve(false);
  }

  #draw(): void {
    this.#connected?.stage.invalidate();
  }

  #showModel(model: Mesh): void {
    const { stage, gestures, hover } = this.#required();
    gestures.cancel();
    hover.moveTo(undefined);
    if (this.#model) {
      stage.remove(this.#model.drawing.object);
      this.#model.drawing.dispose();
      this.#model.cells.dispose();
    }
    const cells = new CellBuilder(model);
    const mesh = new SceneMesh(model);
    this.#model = {
      drawing: new ModelDrawing(mesh),
      picker: new Picker(mesh),
      paint: new DensityPaint(mesh),
      cells,
    };
    this.#adoptDensity();
    stage.add(this.#model.drawing.object);
    this.#showLayers();
    this.refit();
    // The first drawing compiles shaders, which takes longer than many a diagram. Done now, it is not
    // counted as the diagram's time.
    stage.draw();
  }

  #showLayers(): void {
    this.#model?.drawing.show(new Set(this.layers));
    this.#draw();
    this.#derive();
  }

  /** Asks for what is shown of the diagram besides itself; not for that of every iteration. */
  #derive(): void {
    const shown = this.cvtStatus === 'running' ? undefined : this.#session?.shown;
    void this.#dual.update(this.layers.includes('dual') ? shown : undefined);
    void this.#parts.update(this.exploded > 0 ? shown : undefined);
  }

  #showDual(result: { dual: PolygonMesh; violations: Violation[] } | undefined): void {
    if (!this.#model) return;
    const { drawing, picker } = this.#model;
    drawing.setDual(result?.dual, (place) => picker.nearest(place));
    this.#draw();
    const polygons = (result?.dual.faces.offset.length ?? 0) - 1;
    this.#emit('dual', result ? { polygons, violations: result.violations } : null);
  }

  #showParts(parts: Partition | undefined): void {
    this.#model?.drawing.setParts(parts);
    this.#explode();
    const triangles = parts?.triangles.label.length ?? 0;
    this.#emit('exploded', parts ? { regions: parts.regions.area.length, triangles } : null);
  }

  #explode(): void {
    this.#derive();
    this.#model?.drawing.spread(this.exploded);
    if (this.#connected) this.#connected.stage.reach = 1 + widestSpread * this.exploded;
    this.#draw();
  }

  #showSites(): void {
    const session = this.#session;
    if (!session || !this.#model) return;
    const { selected } = this;
    this.#model.drawing.setSites(session.sites, selected);
    this.#draw();
    this.#emit('sites-change', {
      count: session.sites.length,
      selected,
      canUndo: session.canUndo,
      canRedo: session.canRedo,
    });
  }

  #showDiagram(shown: ShownDiagram, { changes, cells }: Drawable): void {
    const drawn = drawnDiagram(shown);
    const drawing = this.#model?.drawing;
    if (drawn && changes) for (const change of changes) drawing?.changeDiagram(change, drawn);
    else drawing?.setDiagram(drawn, cells);
    this.#draw();
    this.#connected?.hover.refresh();
    this.#derive();
  }

  #tellDiagram({ sites, summary, metric, detail }: ShownDiagram, milliseconds: number): void {
    this.#emit('diagram', {
      sites: sites.length,
      regions: summary?.regionCount ?? 0,
      segments: summary?.segmentCount ?? 0,
      arcs: summary?.arcCount ?? 0,
      voronoiPoints: summary?.voronoiPointCount ?? 0,
      metric,
      detail,
      milliseconds,
    });
  }

  #pick(device: Vector2): SurfaceHit | undefined {
    if (this.exploded > 0) return undefined;
    return this.#model?.picker.pick(device, this.#required().stage.camera);
  }

  get #isPainting(): boolean {
    return this.getAttribute('tool') === 'density';
  }

  get #brush(): Brush {
    return {
      radius: numberOf(this.getAttribute('brush-size'), 20) / 100,
      density: numberOf(this.getAttribute('brush-density'), 100),
    };
  }

  /** Paints density there; returns whether there is any surface. */
  #dab(device: Vector2): boolean {
    const hit = this.#pick(device);
    if (!hit || !this.#model) return false;
    const { paint, drawing } = this.#model;
    paint.dab(hit, this.#brush);
    drawing.setTints(paint.tints);
    this.#showBrush(hit);
    this.#draw();
    return true;
  }

  /** The outline of what the brush reaches there; none beside the surface. */
  #showBrush(hit: SurfaceHit | undefined): void {
    if (!this.#model) return;
    const { drawing, picker } = this.#model;
    const ring =
      hit && this.#isPainting
        ? brushRing(drawing.mesh, hit, this.#brush.radius, (place) => picker.nearest(place))
        : new Float32Array();
    if (drawing.setBrush(ring)) this.#draw();
  }

  /** A tessellation that plays goes on with the density that is painted now. */
  #recordDensity(): void {
    const isPlaying = this.cvtStatus === 'running';
    this.#session?.recordDensity(this.#model?.paint.tints?.slice());
    this.#adoptDensity();
    if (isPlaying) this.playCvt();
  }

  #adoptDensity(): void {
    const mesh = this.#session?.mesh;
    if (!this.#model || !mesh) return;
    const { paint, drawing } = this.#model;
    const perVertex = paint.density;
    this.#density = perVertex && {
      perVertex,
      rootIntegral: rootDensityIntegral(mesh, perVertex),
    };
    drawing.setTints(paint.tints);
    this.#draw();
    this.#emit('density-change', { isUniform: perVertex === undefined });
  }

  #placeAt(device: Vector2): void {
    if (this.#isPainting) {
      if (this.#dab(device)) this.#recordDensity();
      return;
    }
    const hit = this.#pick(device);
    if (hit) this.addSite(hit);
  }

  #siteAt(x: number, y: number, reach: number): number | undefined {
    if (!this.#model || !this.layers.includes('sites') || this.exploded > 0) return undefined;
    const { stage } = this.#required();
    const { drawing, picker } = this.#model;
    const sites: Sites = this.#session?.sites ?? [];
    const toClient = stage.projection();
    let nearest: number | undefined;
    let nearestDistance = reach;
    sites.forEach(({ id }, i) => {
      const place = drawing.sitePlace(i);
      const client = toClient(place);
      if (!client) return;
      const distance = Math.hypot(client.x - x, client.y - y);
      if (distance > nearestDistance || picker.hides(place, stage.camera)) return;
      nearest = id;
      nearestDistance = distance;
    });
    return nearest;
  }

  #drag(site: number, x: number, y: number): void {
    const { stage, canvas } = this.#required();
    canvas.style.cursor = 'grabbing';
    const hit = this.#pick(stage.toDevice(x, y));
    // Beside the model the site waits where it was last.
    if (hit) this.#session?.moveSite(site, hit);
  }

  #selectNext(step: 1 | -1): void {
    const count = this.#session?.sites.length ?? 0;
    if (count === 0) return;
    const { selected } = this;
    if (selected < 0) this.selected = step > 0 ? 0 : count - 1;
    else this.selected = (selected + step + count) % count;
  }

  #hover(x: number, y: number): void {
    const { stage, canvas, hover } = this.#required();
    const hit = this.#pick(stage.toDevice(x, y));
    const overSite = hit && !this.#isPainting && this.#siteAt(x, y, 10) !== undefined;
    canvas.style.cursor = overSite ? 'grab' : hit ? 'crosshair' : '';
    hover.moveTo(hit);
    this.#showBrush(hit);
  }

  #tellHovered(point: HoveredPoint | undefined): void {
    const { drawing } = this.#model ?? {};
    const region = point?.region ?? -1;
    if (drawing?.outline(region)) this.#draw();
    this.#emit('hover', point ? { ...point, colour: drawing?.regionColour(region) } : null);
  }
}

function drawnDiagram(shown: ShownDiagram): DrawnDiagram | undefined {
  const { sites, summary } = shown;
  return (
    summary && {
      summary,
      siteIds: sites.map(({ id }) => id),
      get data() {
        return shown.data as DiagramData;
      },
    }
  );
}

function numberOf(attribute: string | null, otherwise: number): number {
  const number = attribute === null || attribute.trim() === '' ? NaN : Number(attribute);
  return Number.isFinite(number) ? number : otherwise;
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
