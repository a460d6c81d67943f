// SPDX-License-Identifier: MIT
import type { DiagramData, Partition, PolygonMesh } from 'geodesic-voronoi';
import { Group, type LineSegments, Vector3 } from 'three';
import { ExplodedParts } from './exploded_parts.js';
import { drapedSides, FatLines, outlineEnds, pointPlaces, wireframe } from './lines.js';
import { Markers } from './markers.js';
import { RegionColours, toneColour } from './region_colours.js';
import { LabelColours, RegionSurface } from './region_surface.js';
import type { SceneMesh } from './scene_mesh.js';
import type { Sites } from './site_history.js';

/** What can be shown and hidden. */
export const layers = [
  'regions',
  'bisectors',
  'sites',
  'voronoi-points',
  'dual',
  'wireframe',
] as const;
export type Layer = (typeof layers)[number];

const ink = 0x1f2933;
const paper = 0xffffff;
const accent = 0xd6336c;

/** A model with its diagram and sites, as objects of the scene. */
export class ModelDrawing {
  readonly object = new Group();
  readonly #mesh: SceneMesh;
  readonly #surface: RegionSurface;
  readonly #colours = new RegionColours();
  readonly #bisectors = new FatLines({ colour: ink, width: 2 });
  readonly #outline = new FatLines({ colour: ink, width: 4.5 });
  readonly #dual = new FatLines({ colour: accent, width: 2.5 });
  readonly #voronoiPoints = new Markers({
    diameter: 7,
    ring: 1.25,
    fill: ink,
    edge: paper,
    emphasis: ink,
  });
  readonly #siteMarkers = new Markers({
    diameter: 11,
    ring: 2,
    fill: ink,
    edge: paper,
    emphasis: accent,
  });
  /** All that lies on the surface, and it. */
  readonly #together = new Group();
  #parts: ExplodedParts | undefined;
  #wireframe: LineSegments | undefined;
  #shown: ReadonlySet<Layer> = new Set();
  #data: DiagramData | undefined;
  #tones: Uint16Array = new Uint16Array();
  #outlined = -1;
  #sitePlaces = new Float32Array();

  constructor(mesh: SceneMesh) {
    this.#mesh = mesh;
    this.#surface = new RegionSurface(mesh);
    this.object.add(this.#together);
    this.#together.add(
      this.#surface.object,
      this.#bisectors.object,
      this.#outline.object,
      this.#dual.object,
      this.#voronoiPoints.object,
      this.#siteMarkers.object,
    );
  }

  get mesh(): SceneMesh {
    return this.#mesh;
  }

  show(shown: ReadonlySet<Layer>): void {
    this.#shown = shown;
    this.#surface.filled = shown.has('regions');
    this.#siteMarkers.object.visible = shown.has('sites');
    this.#voronoiPoints.object.visible = shown.has('voronoi-points');
    if (shown.has('wireframe') && !this.#wireframe) {
      this.#wireframe = wireframe(this.#mesh, ink);
      this.#together.add(this.#wireframe);
    }
    if (this.#wireframe) this.#wireframe.visible = shown.has('wireframe');
    this.#showBisectors();
  }

  /** The diagram of sites with these identities; undefined for none. */
  setDiagram(data: DiagramData | undefined, siteIds: readonly number[] = []): void {
    this.#data = data;
    this.#tones = data ? this.#colours.assign(data, siteIds) : new Uint16Array();
    this.#surface.setDiagram(data && { data, tones: this.#tones });
    const places = (points: Int32Array | undefined) =>
      data && points ? pointPlaces(this.#mesh, data, points) : new Float32Array();
    this.#bisectors.set(places(data?.segments.points));
    this.#voronoiPoints.set(places(data?.voronoiPoints.point));
    this.outline(-1);
    this.#showBisectors();
  }

  /** The sides of the dual, laid onto the surface by `nearest`; undefined for none. */
  setDual(dual: PolygonMesh | undefined, nearest: (place: Vector3) => Vector3): void {
    this.#dual.set(dual ? drapedSides(this.#mesh, dual, nearest) : new Float32Array());
  }

  /** The regions apart, instead of the surface and what lies on it; undefined for none. */
  setParts(partition: Partition | undefined): void {
    if (this.#parts) this.object.remove(this.#parts.object);
    this.#parts?.dispose();
    this.#parts = partition && new ExplodedParts(this.#mesh, partition, new LabelColours(this.#tones));
    if (this.#parts) this.object.add(this.#parts.object);
    this.#together.visible = !this.#parts;
  }

  /** How far apart the parts are, 0 … 1. */
  spread(share: number): void {
    this.#parts?.spread(share);
  }

  /** The colour of a region, as CSS has it. */
  regionColour(label: number): string | undefined {
    if (label < 0 || label >= this.#tones.length) return undefined;
    return `#${toneColour(this.#tones[label]).toString(16).padStart(6, '0')}`;
  }

  /** A tint per input vertex, -1 … 1, over the regions' colours; undefined for none. */
  setTints(tints: Float32Array | undefined): void {
    this.#surface.tints = tints;
  }

  setSites(sites: Sites, selected: number): void {
    this.#sitePlaces = new Float32Array(3 * sites.length);
    sites.forEach(({ face, bary }, i) => {
      this.#mesh.writePoint(face, bary, this.#sitePlaces, 3 * i);
    });
    this.#siteMarkers.set(this.#sitePlaces, selected);
  }

  sitePlace(index: number): Vector3 {
    return new Vector3().fromArray(this.#sitePlaces, 3 * index);
  }

  /** Draws one region's outline bold; -1 for none. Returns whether that changed anything. */
  outline(label: number): boolean {
    if (label === this.#outlined) return false;
    this.#outlined = label;
    const known = this.#data !== undefined && label >= 0 && label < this.#data.siteCount;
    this.#outline.set(known ? outlineEnds(this.#mesh, this.#data!, label) : new Float32Array());
    return true;
  }

  dispose(): void {
    this.#surface.dispose();
    this.#bisectors.dispose();
    this.#outline.dispose();
    this.#dual.dispose();
    this.#parts?.dispose();
    this.#voronoiPoints.dispose();
    this.#siteMarkers.dispose();
    if (this.#wireframe) {
      this.#wireframe.geometry.dispose();
      (this.#wireframe.material as { dispose(): void }).dispose();
    }
  }

  #showBisectors(): void {
    const any = (this.#data?.segments.face.length ?? 0) > 0;
    this.#bisectors.object.visible = any && this.#shown.has('bisectors');
  }
}
