// SPDX-License-Identifier: MIT
//
// The values of the element's attributes.

import type {
  CvtMethod,
  GltfLimits,
  MeshInfo,
  Metric,
  Orientation,
  Sampling,
} from 'geodesic-voronoi';
import {
  attributeDefaults,
  attributeOf,
  openingAttributes,
  samplingAttributes,
  upAxisOf,
} from './attribute_defaults.js';
import { type CameraOrbit, parseCameraOrbit } from '../stage/camera_orbit.js';
import type { CvtSettings } from '../session/cvt_run.js';
import { type Layer, layers } from '../drawing/model_drawing.js';
import type { Opening, SiteSampling } from '../session/mesh_opening.js';
import type { DiagramSettings } from '../session/shown_diagram.js';
import type { UpAxis } from '../stage/stage_camera.js';

/** What density is painted with. */
export interface Brush {
  /** In units of the scene, where the model has radius 1. */
  radius: number;
  /** The density that strokes lead to under the brush's centre; 1 where nothing is painted. */
  density: number;
}

/** Attributes are read anew at each access, so values are never stale. */
export class Attributes {
  readonly #element: HTMLElement;
  /** The texts of the attributes by which the shown model and its sites were made. */
  readonly #kept = new Map<string, string | null>();
  /** Their texts when a model or sites were asked for last. */
  readonly #asked = new Map<string, string | null>();

  constructor(element: HTMLElement) {
    this.#element = element;
  }

  /** Notes that what is shown was made by these attributes as they are now. */
  keep(names: readonly string[]): void {
    this.#note(this.#kept, names);
  }

  /** Notes that a model or sites are asked for by the attributes as they are now. */
  ask(): void {
    this.#note(this.#asked, [...openingAttributes, ...samplingAttributes]);
  }

  /** Whether these attributes ask for something else than is shown. */
  differ(names: readonly string[]): boolean {
    return this.#differFrom(this.#kept, names);
  }

  /** Whether these attributes ask for something else than was asked for last. */
  areNew(names: readonly string[]): boolean {
    return this.#differFrom(this.#asked, names);
  }

  /** Sets attributes, of these names and the diagram's, back to what is shown: nothing is asked for by that. */
  restore(diagram: DiagramSettings, names: readonly string[]): void {
    this.#element.setAttribute('metric', diagram.metric);
    this.#element.setAttribute('detail', String(diagram.detail));
    for (const [name, text] of this.#kept) {
      if (!names.includes(name)) continue;
      if (text === null) this.#element.removeAttribute(name);
      else this.#element.setAttribute(name, text);
      this.#asked.set(name, text);
    }
  }

  #note(texts: Map<string, string | null>, names: readonly string[]): void {
    for (const name of names) texts.set(name, this.#element.getAttribute(name));
  }

  #differFrom(texts: ReadonlyMap<string, string | null>, names: readonly string[]): boolean {
    return names.some((name) => this.#element.getAttribute(name) !== texts.get(name));
  }

  get label(): string {
    return this.#given('alt') || 'A surface with its geodesic Voronoi diagram';
  }

  /** What pointer and keys do: change sites and density too, move the camera only, or nothing. */
  get interactive(): 'edit' | 'camera' | 'none' {
    const text = this.#given('interactive');
    return text === 'camera' || text === 'none' ? text : 'edit';
  }

  get touchAction(): string | undefined {
    return this.#given('touch-action');
  }

  /** Undefined where it is none. */
  get cameraOrbit(): CameraOrbit | undefined {
    return parseCameraOrbit(this.#given('camera-orbit') ?? '');
  }

  get layers(): readonly Layer[] {
    const wanted = new Set(this.#text('layers').split(/[\s,]+/));
    return layers.filter((layer) => wanted.has(layer));
  }

  /** 0 … 1. */
  get exploded(): number {
    return Math.min(1, Math.max(0, this.#number('exploded')));
  }

  /** The axis of a model that points up. */
  upOf(info: MeshInfo | undefined): UpAxis {
    return upAxisOf(this.#element, info);
  }

  get diagram(): DiagramSettings {
    return {
      // The library refuses unknown metrics, in a sentence that lists the known ones.
      metric: this.#text('metric') as Metric,
      detail: this.#argument('detail'),
    };
  }

  get opening(): Opening {
    return {
      build: {
        maxEdge: this.#argument('max-edge'),
        weld: this.#argument('weld'),
        orientation: this.#text('orientation') as Orientation,
        minComponent: this.#argument('min-component'),
        limits: this.#limits,
      },
      siteSampling: () => this.siteSampling,
    };
  }

  /** As the command has them: `maxVertices=N,maxTriangles=N`. */
  get #limits(): GltfLimits {
    const given = (this.#given('limits') ?? '').split(',').filter((each) => each.trim() !== '');
    const pairs = given.map((each) => each.split(/=(.*)/));
    return Object.fromEntries(pairs.map(([name, most]) => [name.trim(), argumentOf(String(most))]));
  }

  get siteSampling(): SiteSampling {
    return {
      count: this.#argument('sites'),
      seed: this.#argument('seed'),
      sampling: this.#text('sampling') as Sampling,
      perComponent: this.#argument('per-component'),
    };
  }

  get cvt(): CvtSettings {
    return {
      method: this.#text('cvt-method') as CvtMethod,
      energyTolerance: this.#argument('cvt-tolerance'),
    };
  }

  get cvtIterations(): number {
    return Math.max(1, Math.round(this.#number('cvt-iterations')));
  }

  get isPainting(): boolean {
    return this.#given('tool') === 'density';
  }

  get brush(): Brush {
    return {
      radius: this.#number('brush-size') / 100,
      density: Math.max(0, this.#number('brush-density')),
    };
  }

  /** The text of an attribute without a default. */
  #given(name: string): string | undefined {
    return this.#element.getAttribute(name) ?? undefined;
  }

  #text(name: string): string {
    return attributeOf(this.#element, name);
  }

  #number(name: string): number {
    const number = this.#argument(name);
    return Number.isFinite(number) ? number : Number(attributeDefaults[name]);
  }

  #argument(name: string): number {
    return argumentOf(this.#text(name).trim() || attributeDefaults[name]);
  }
}

/** A number for the library; a text that is no number as it is, for the library to refuse it. */
function argumentOf(text: string): number {
  const number = Number(text);
  return Number.isNaN(number) ? (text as unknown as number) : number;
}
