// SPDX-License-Identifier: MIT
import type { DiagramChange, DiagramData, Partition, PolygonMesh } from 'geodesic-voronoi';
import { Group, type LineSegments, Vector3 } from 'three';
import type { CellTriangles } from './cell_triangles.js';
import { type DiagramSummary, labelsAround } from './diagram_summary.js';
import { ExplodedParts } from './exploded_parts.js';
import { drapedSides, FatLines, outlineEnds, pointPlaces, wireframe } from './lines.js';
import { Markers } from './markers.js';
import { RegionColours, toneColour } from './region_colours.js';
import { LabelColours, RegionSurface, type TonedDiagram } from './region_surface.js';
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

/** A diagram to be drawn; `data` is read only to draw all of it. */
export interface DrawnDiagram {
  readonly data: DiagramData;
  summary: DiagramSummary;
  /** Identities per label. */
  siteIds: readonly number[];
}

type Lines = Pick<DiagramData, 'points' | 'arcs' | 'segments' | 'voronoiPoints'>;

/** A model with its diagram and sites, as objects of the scene. */
export class ModelDrawing {
  readonly object = new Group();
  readonly #mesh: SceneMesh;
  readonly #surface: RegionSurface;
  readonly #colours: RegionColours;
  /** Their keys are the two labels. */
  readonly #bisectors = new FatLines({ colour: ink, width: 2 });
  readonly #outline = new FatLines({ colour: ink, width: 4.5 });
  readonly #brush = new FatLines({ colour: accent, width: 2.5 });
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
  /** Of the diagram when all of it was drawn; regions that have changed since are in `#outlines`. */
  #loops: Pick<DiagramData, 'points' | 'loops'> | undefined;
  readonly #outlines = new Map<number, Float32Array>();
  #tones: Uint16Array = new Uint16Array();
  #outlined = -1;
  #sitePlaces = new Float32Array();
  /** Of the Voronoi points, with the labels around each. */
  #pointPlaces: Float32Array = new Float32Array();
  #pointLabels: readonly Int32Array[] = [];

  constructor(mesh: SceneMesh, colours = new RegionColours()) {
    this.#mesh = mesh;
    this.#colours = colours;
    this.#surface = new RegionSurface(mesh);
    this.object.add(this.#together);
    this.#together.add(
      this.#surface.object,
      this.#bisectors.object,
      this.#outline.object,
      this.#dual.object,
      this.#brush.object,
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

  /** `cells` are the diagram's if they have been cut already. */
  setDiagram(diagram: DrawnDiagram | undefined, cells?: CellTriangles): void {
    const data = diagram?.data;
    this.#tones = diagram
      ? this.#colours.assign(diagram.summary, diagram.siteIds)
      : new Uint16Array();
    this.#surface.setDiagram(diagram && toned(diagram, this.#tones), cells);
    this.#replaceLines(undefined, data);
    this.#loops = data;
    this.#outlines.clear();
    this.outline(-1);
  }

  /** What the diagram drawn has become by a change: draws this, and nothing else anew. */
  changeDiagram(change: DiagramChange, diagram: DrawnDiagram): void {
    const { labels, part } = change;
    this.#tones = this.#colours.assign(diagram.summary, diagram.siteIds, new Set(labels));
    this.#surface.changeDiagram(change, toned(diagram, this.#tones));
    // Of labels there may be one more than tones: that of a site that has gone.
    const isChanged = new Uint8Array(1 + Math.max(this.#tones.length, labels[labels.length - 1]));
    for (const label of labels) isChanged[label] = 1;
    this.#replaceLines(isChanged, part);
    for (const label of labels) this.#outlines.set(label, outlineEnds(this.#mesh, part, label));
    this.outline(-1);
  }

  /** The sides of the dual, laid onto the surface by `nearest`; undefined for none. */
  setDual(dual: PolygonMesh | undefined, nearest: (place: Vector3) => Vector3): void {
    this.#dual.set(dual ? drapedSides(this.#mesh, dual, nearest) : new Float32Array());
  }

  /** The regions apart, instead of the surface and what lies on it; undefined for none. */
  setParts(partition: Partition | undefined): void {
    if (this.#parts) this.object.remove(this.#parts.object);
    this.#parts?.dispose();
    this.#parts =
      partition && new ExplodedParts(this.#mesh, partition, new LabelColours(this.#tones));
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

  /** Both ends of the sides of the brush's outline; none if there is no brush. Returns whether it changed. */
  setBrush(ends: Float32Array): boolean {
    if (ends.length === 0 && this.#brush.count === 0) return false;
    this.#brush.set(ends);
    return true;
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
    const isKnown = label >= 0 && label < this.#tones.length;
    const ends = isKnown ? this.#outlineEnds(label) : new Float32Array();
    this.#outline.set(ends);
    return true;
  }

  dispose(): void {
    this.#surface.dispose();
    this.#bisectors.dispose();
    this.#outline.dispose();
    this.#dual.dispose();
    this.#brush.dispose();
    this.#parts?.dispose();
    this.#voronoiPoints.dispose();
    this.#siteMarkers.dispose();
    if (this.#wireframe) {
      this.#wireframe.geometry.dispose();
      (this.#wireframe.material as { dispose(): void }).dispose();
    }
  }

  #showBisectors(): void {
    this.#bisectors.object.visible = this.#bisectors.count > 0 && this.#shown.has('bisectors');
  }

  #outlineEnds(label: number): Float32Array {
    const changed = this.#outlines.get(label);
    if (changed || !this.#loops) return changed ?? new Float32Array();
    return outlineEnds(this.#mesh, this.#loops, label);
  }

  /** Other bisectors and Voronoi points instead of those of the marked labels; of all if none are given. */
  #replaceLines(isChanged: Uint8Array | undefined, part: Lines | undefined): void {
    const places = (points: Int32Array | undefined) =>
      part && points ? pointPlaces(this.#mesh, part, points) : new Float32Array();
    const segments = places(part?.segments.points);
    const between = part?.segments.labels ?? new Int32Array();
    const points = places(part?.voronoiPoints.point);
    const around = part ? labelsAround(part) : [];
    if (isChanged) {
      this.#bisectors.replace({ first: isChanged, second: isChanged }, segments, between);
      this.#keepPoints(isChanged, points, around);
    } else {
      this.#bisectors.set(segments, between);
      this.#pointPlaces = points;
      this.#pointLabels = around;
    }
    this.#voronoiPoints.set(inOrder(this.#pointPlaces));
    this.#showBisectors();
  }

  /** Of the Voronoi points those beside the marked labels; these ones are added. They are few. */
  #keepPoints(isChanged: Uint8Array, places: Float32Array, labels: readonly Int32Array[]): void {
    const kept: number[] = [];
    this.#pointLabels.forEach((around, i) => {
      if (!around.some((label) => isChanged[label] > 0)) kept.push(i);
    });
    const all = new Float32Array(3 * kept.length + places.length);
    kept.forEach((from, to) => {
      all.set(this.#pointPlaces.subarray(3 * from, 3 * from + 3), 3 * to);
    });
    all.set(places, 3 * kept.length);
    this.#pointPlaces = all;
    this.#pointLabels = [...kept.map((i) => this.#pointLabels[i]), ...labels];
  }
}

/** Places by their coordinates: where points overlap, changes elsewhere leave the same one on top. */
function inOrder(places: Float32Array): Float32Array {
  const order = Array.from({ length: places.length / 3 }, (_, i) => i);
  const difference = (i: number, j: number, axis: number) =>
    places[3 * i + axis] - places[3 * j + axis];
  order.sort((i, j) => difference(i, j, 0) || difference(i, j, 1) || difference(i, j, 2));
  const result = new Float32Array(places.length);
  order.forEach((from, to) => {
    result.set(places.subarray(3 * from, 3 * from + 3), 3 * to);
  });
  return result;
}

function toned(diagram: DrawnDiagram, tones: Uint16Array): TonedDiagram {
  return {
    tones,
    get data() {
      return diagram.data;
    },
  };
}
