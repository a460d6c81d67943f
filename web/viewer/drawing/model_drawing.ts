// SPDX-License-Identifier: MIT
//
// Everything that is drawn of a model.

import type { DiagramChange, DiagramData, SurfacePath } from 'geodesic-voronoi';
import {
  type BufferGeometry,
  type Data3DTexture,
  Group,
  type LineBasicMaterial,
  type LineSegments,
  type Object3D,
} from 'three';
import { css } from '../buffers/colour_vision.js';
import {
  type DiagramGeometry,
  type PreparedDiagram,
  segmentRecords,
} from '../buffers/diagram_geometry.js';
import type { DiagramSummary } from '../buffers/diagram_summary.js';
import type { PartTriangles } from '../buffers/part_triangles.js';
import { type DrawnDistances, DistanceSurface } from './distance_surface.js';
import { ExplodedParts } from './exploded_parts.js';
import { chainEnds, FatLines, wireframe } from './lines.js';
import type { OriginalMaterial } from './original_material.js';
import { RegionColours, toneColour } from '../buffers/region_colours.js';
import { type DiagramSource, RegionSurface } from './region_surface.js';
import { OutlineDrawing } from './outline_drawing.js';
import { occlusionTexture } from './occlusion.js';
import type { SceneMesh } from '../buffers/scene_mesh.js';
import { SiteDrawing } from './site_drawing.js';
import type { Sites } from '../session/site_history.js';
import { lightTheme, type Theme } from './theme.js';
import { VoronoiPointMarkers } from './voronoi_point_markers.js';

/** The layers that can be shown and hidden. */
export const layers = [
  'regions',
  'bisectors',
  'sites',
  'voronoi-points',
  'dual',
  'distances',
  'original',
  'wireframe',
] as const;
export type Layer = (typeof layers)[number];

/** The radius of a Voronoi point's marker, as a share of that of a site's. */
const pointShare = 0.45;

/** The greatest width of bisectors, as a share of the radius of a disc as large as a usual region. */
const bisectorShare = 0.25;

type Lines = Pick<DiagramData, 'points' | 'arcs' | 'segments' | 'voronoiPoints'>;

/** A diagram after a change. */
interface ChangedDiagram {
  diagram: DiagramSource;
  summary: DiagramSummary;
  sites: Sites;
}

/** A part of the drawing; `dispose` frees its memory on the graphics card. */
interface Drawn {
  readonly object: Object3D;
  dispose(): void;
}

/** A model with its diagram and sites, as objects of the scene. */
export class ModelDrawing {
  readonly object = new Group();
  readonly mesh: SceneMesh;
  readonly sites: SiteDrawing;
  readonly outline: OutlineDrawing;
  readonly #surface: RegionSurface;
  readonly #colours: RegionColours;
  /** Each segment has its two labels as keys. */
  readonly #bisectors = new FatLines({ width: 2, hasNormals: true });
  readonly #brush = new FatLines({ width: 2.5 });
  /** From the point under the pointer to its site. */
  readonly #path = new FatLines({ width: 2.5 });
  readonly #dual = new FatLines({ width: 2.5 });
  readonly #voronoiPoints: VoronoiPointMarkers;
  /** The surface as regions and what lies on it, in the order of drawing. */
  readonly #parts: readonly Drawn[];
  /** These, with the other surfaces. */
  readonly #whole = new Group();
  #distances: DistanceSurface | undefined;
  #original: OriginalMaterial | undefined;
  /** Shown instead of the whole model. */
  #exploded: ExplodedParts | undefined;
  #wireframe: LineSegments<BufferGeometry, LineBasicMaterial> | undefined;
  readonly #occlusion: Data3DTexture;
  #theme: Theme = lightTheme;
  #shown: ReadonlySet<Layer> = new Set();
  #tones: Uint16Array = new Uint16Array();

  constructor(mesh: SceneMesh, colours = new RegionColours()) {
    this.mesh = mesh;
    this.#colours = colours;
    this.#occlusion = occlusionTexture(mesh.surfaceDensity);
    this.#surface = new RegionSurface(mesh, this.#occlusion);
    this.sites = new SiteDrawing(mesh);
    this.outline = new OutlineDrawing(mesh);
    this.#voronoiPoints = new VoronoiPointMarkers(mesh);
    this.theme = this.#theme;
    this.object.add(this.#whole);
    const lines = [this.#bisectors, this.outline, this.#dual, this.#brush, this.#path];
    this.#parts = [this.#surface, ...lines, this.#voronoiPoints.markers, this.sites];
    this.#whole.add(...this.#parts.map(({ object }) => object));
  }

  /** See `Markers`. */
  set front(side: number) {
    this.sites.front = side;
    this.#voronoiPoints.markers.front = side;
    this.#bisectors.front = side;
  }

  get theme(): Theme {
    return this.#theme;
  }

  set theme(theme: Theme) {
    this.#theme = theme;
    this.#surface.shade = theme.surfaceShade;
    this.#bisectors.colour = this.outline.colour = theme.ink;
    this.#rimBisectors();
    this.#dual.colour = this.#brush.colour = this.#path.colour = theme.accent;
    this.sites.theme = theme;
    this.#voronoiPoints.markers.theme = theme;
    this.#wireframe?.material.color.set(theme.ink);
    if (this.#exploded) this.#exploded.shade = theme.surfaceShade;
  }

  show(shown: ReadonlySet<Layer>): void {
    this.#shown = shown;
    this.#surface.filled = shown.has('regions');
    this.sites.object.visible = shown.has('sites');
    this.#voronoiPoints.visible = shown.has('voronoi-points');
    if (this.#wireframe) this.#wireframe.visible = shown.has('wireframe');
    this.#showBisectors();
  }

  /** Chooses a tone per label for a diagram that is to be drawn; see `RegionColours`. */
  assignTones(summary: DiagramSummary, sites: Sites, yielding?: ReadonlySet<number>): Uint16Array {
    const ids = sites.map(({ id }) => id);
    return this.#colours.assign(summary, ids, yielding);
  }

  /** Draws a whole diagram, or none; takes over the arrays in `prepared`. */
  setDiagram(diagram: DiagramSource | undefined, prepared: PreparedDiagram | undefined): void {
    this.#tones = prepared?.tones ?? new Uint16Array();
    const { cells } = prepared?.geometry ?? {};
    this.#surface.setDiagram(diagram, this.#tones, cells);
    this.#adoptAreas(prepared?.summary);
    this.#setLines(diagram?.data, prepared?.geometry);
    this.outline.setLoops(diagram?.data);
  }

  /** Draws what a change made different, and nothing else. */
  changeDiagram(change: DiagramChange, { diagram, summary, sites }: ChangedDiagram): void {
    const { labels, part } = change;
    this.#tones = this.assignTones(summary, sites, new Set(labels));
    this.#surface.changeDiagram(change, diagram, this.#tones);
    this.#adoptAreas(summary);
    // There may be one more label than tones: that of a removed site.
    const isChanged = new Uint8Array(1 + Math.max(this.#tones.length, labels[labels.length - 1]));
    for (const label of labels) isChanged[label] = 1;
    this.#replaceLines(isChanged, part);
    this.outline.changeLoops(labels, part);
  }

  /** The surface coloured by distance, instead of the regions; undefined for none. */
  setDistances(distances: DrawnDistances | undefined): void {
    const before = this.#distances;
    this.#distances = distances && new DistanceSurface(this.mesh, distances, this.#occlusion);
    this.#replace(before, this.#distances);
    this.#showSurface();
  }

  /** The surface as its file colours it, instead of the regions; undefined for none. */
  setOriginal(original: OriginalMaterial | undefined): void {
    if (this.#original === original) return;
    this.#replace(this.#original, original);
    this.#original = original;
    this.#rimBisectors();
    this.#showSurface();
  }

  /** Parts to be uploaded before they are shown; whoever never shows them disposes of them. */
  prepareParts(triangles: PartTriangles): ExplodedParts {
    const parts = new ExplodedParts(triangles, this.#occlusion);
    this.object.add(parts.object);
    return parts;
  }

  /** The regions as prepared parts that move, instead of the whole model; undefined for none. */
  setExploded(parts: ExplodedParts | undefined): void {
    this.#exploded?.dispose();
    this.#exploded = parts;
    this.#whole.visible = !parts;
    parts?.show(this.#theme.surfaceShade);
  }

  /** How far these parts have moved, 0 … 1. */
  spread(share: number): void {
    this.#exploded?.spread(share);
  }

  #replace(before: Drawn | undefined, after: Drawn | undefined): void {
    if (before) this.#whole.remove(before.object);
    before?.dispose();
    if (after) this.#whole.add(after.object);
  }

  /** Regions are coloured so that bisectors stand out; a file's own colours may be any. */
  #rimBisectors(): void {
    this.#bisectors.rim = this.#original ? this.#theme.paper : undefined;
  }

  /** Two vertices for every edge: the wireframe's. */
  setEdges(edges: Uint32Array): void {
    this.#wireframe = wireframe(this.mesh, edges);
    this.#wireframe.material.color.set(this.#theme.ink);
    this.#wireframe.visible = this.#shown.has('wireframe');
    this.#whole.add(this.#wireframe);
  }

  /** Shows one surface only, or several would be drawn in the same place. */
  #showSurface(): void {
    if (this.#original) this.#original.object.visible = !this.#distances;
    this.#surface.object.visible = !this.#distances && !this.#original;
  }

  /** Draws the dual: both ends of every piece of its sides; empty for no dual. */
  setDual(ends: Float32Array): void {
    this.#dual.set(ends);
  }

  /** The tone of each label. */
  get tones(): Uint16Array {
    return this.#tones;
  }

  /** The colour of a region, as CSS has it. */
  regionColour(label: number): string | undefined {
    const tone: number | undefined = this.#tones[label];
    return tone === undefined ? undefined : css(toneColour(tone));
  }

  /**
   * Both ends of the sides of the brush's outline; none if there is no brush. Returns whether it
   * changed.
   */
  setBrush(ends: Float32Array): boolean {
    if (ends.length === 0 && this.#brush.count === 0) return false;
    this.#brush.set(ends);
    return true;
  }

  /** A tint per input vertex, -1 … 1, over the regions' colours; undefined for none. */
  setTints(tints: Float32Array | undefined): void {
    this.#surface.tints = tints;
  }

  #adoptAreas(summary: DiagramSummary | undefined): void {
    this.sites.regionAreas = summary?.regionArea ?? new Float64Array();
    // Without regions, nothing is crowded.
    this.#bisectors.widest = bisectorShare * (this.sites.usualRadius || 1);
  }

  /** A path on the surface; undefined for none. */
  setPath(path: SurfacePath | undefined): void {
    const points = path?.points ?? { position: [] };
    this.#path.set(chainEnds(this.mesh, { points, offset: [0, points.position.length / 3] }));
  }

  dispose(): void {
    for (const part of this.#parts) part.dispose();
    this.#exploded?.dispose();
    this.#distances?.dispose();
    this.setOriginal(undefined);
    this.#occlusion.dispose();
    if (this.#wireframe) {
      this.#wireframe.geometry.dispose();
      this.#wireframe.material.dispose();
    }
  }

  #showBisectors(): void {
    this.#bisectors.object.visible = this.#bisectors.count > 0 && this.#shown.has('bisectors');
  }

  /** The bisectors and Voronoi points of a diagram. */
  #setLines(lines: Lines | undefined, geometry: DiagramGeometry | undefined): void {
    const records =
      geometry?.segments ?? (lines ? segmentRecords(this.mesh, lines) : new Float32Array());
    this.#bisectors.adopt(records, lines?.segments.labels ?? new Int32Array());
    this.#voronoiPoints.set(lines, pointShare * this.sites.usualSize);
    this.#showBisectors();
  }

  /** Replaces the bisectors and Voronoi points of the marked labels. */
  #replaceLines(isChanged: Uint8Array, lines: Lines): void {
    const gone = { first: isChanged, second: isChanged };
    this.#bisectors.replace(gone, segmentRecords(this.mesh, lines), lines.segments.labels);
    this.#voronoiPoints.replace(isChanged, lines, pointShare * this.sites.usualSize);
    this.#showBisectors();
  }
}
