// SPDX-License-Identifier: MIT
//
// The values of the element's attributes, and their defaults.

import type { CvtMethod, Metric, Orientation, Sampling } from 'geodesic-voronoi';
import { type CameraOrbit, parseCameraOrbit } from './camera_orbit.js';
import type { CvtSettings } from './cvt_run.js';
import type { Brush } from './density_paint.js';
import { type Layer, layers } from './model_drawing.js';
import type { Opening, SiteSampling } from './mesh_opening.js';
import type { DiagramSettings } from './shown_diagram.js';
import type { UpAxis } from './stage.js';

const defaultLayers: readonly Layer[] = ['regions', 'bisectors', 'sites'];

/** How a model is made of its file. */
export const buildAttributes = ['max-edge', 'weld', 'orientation', 'min-component'] as const;
/** How sites are placed. */
export const samplingAttributes = ['sites', 'seed', 'sampling', 'per-component'] as const;

/** Attributes are read anew at each access, so values are never stale. */
export class Attributes {
  readonly #element: HTMLElement;
  /** The texts that what is shown was made by. */
  readonly #kept = new Map<string, string | null>();

  constructor(element: HTMLElement) {
    this.#element = element;
  }

  /** Notes that what is shown was made by these attributes as they are now. */
  keep(names: readonly string[]): void {
    for (const name of names) this.#kept.set(name, this.#element.getAttribute(name));
  }

  /** Whether these attributes ask for something else than is shown. */
  differ(names: readonly string[]): boolean {
    return names.some((name) => this.#element.getAttribute(name) !== this.#kept.get(name));
  }

  /** Sets attributes back to what is shown, after a failure or a cancel. */
  restore(diagram: DiagramSettings): void {
    this.#element.setAttribute('metric', diagram.metric);
    this.#element.setAttribute('detail', String(diagram.detail));
    for (const [name, text] of this.#kept) {
      if (text === null) this.#element.removeAttribute(name);
      else this.#element.setAttribute(name, text);
    }
  }

  get label(): string {
    return this.#text('alt') || 'A surface with its geodesic Voronoi diagram';
  }

  /** Whether nothing is fetched, nor anything drawn, before the element is near the view. */
  get isLazy(): boolean {
    return this.#text('loading') === 'lazy';
  }

  /** Whether the poster stays until the page dismisses it. */
  get isRevealedByHand(): boolean {
    return this.#text('reveal') === 'manual';
  }

  /**
   * Whether there is anything to do with pointer and keys, and whether it changes sites and
   * density.
   */
  get interactive(): { camera: boolean; edit: boolean } {
    const text = this.#text('interactive');
    return { camera: text !== 'none', edit: text !== 'none' && text !== 'camera' };
  }

  get touchAction(): string | undefined {
    return this.#text('touch-action');
  }

  /** Undefined where it is none. */
  get cameraOrbit(): CameraOrbit | undefined {
    return parseCameraOrbit(this.#text('camera-orbit') ?? '');
  }

  get layers(): readonly Layer[] {
    const names = this.#text('layers');
    if (names === undefined) return defaultLayers;
    const wanted = new Set(names.split(/\s+/));
    return layers.filter((layer) => wanted.has(layer));
  }

  /** 0 … 1. */
  get exploded(): number {
    return Math.min(1, Math.max(0, this.#number('exploded', 0)));
  }

  get up(): UpAxis {
    const axis = this.#text('up');
    return axis === 'x' || axis === 'z' ? axis : 'y';
  }

  get diagram(): DiagramSettings {
    return {
      // The library refuses unknown metrics, in a sentence that lists the known ones.
      metric: (this.#text('metric') ?? 'exact') as Metric,
      detail: this.#number('detail', 0),
    };
  }

  get opening(): Opening {
    return {
      // The library refuses values that make no sense.
      build: {
        maxEdge: this.#number('max-edge', 0),
        weld: this.#number('weld', 0),
        orientation: (this.#text('orientation') ?? 'unify') as Orientation,
        minComponent: this.#number('min-component', 0),
      },
      siteSampling: this.siteSampling,
    };
  }

  get siteSampling(): SiteSampling {
    return {
      count: this.#number('sites', 0),
      seed: this.#number('seed', 1),
      sampling: (this.#text('sampling') ?? 'random') as Sampling,
      perComponent: this.#number('per-component', 0),
    };
  }

  get cvt(): CvtSettings {
    return {
      method: (this.#text('cvt-method') ?? 'lbfgs') as CvtMethod,
      energyTolerance: Math.max(0, this.#number('cvt-tolerance', 0)),
    };
  }

  get cvtIterations(): number {
    return Math.max(1, Math.round(this.#number('cvt-iterations', 50)));
  }

  get isPainting(): boolean {
    return this.#text('tool') === 'density';
  }

  get brush(): Brush {
    return {
      radius: this.#number('brush-size', 20) / 100,
      density: this.#number('brush-density', 100),
    };
  }

  #text(name: string): string | undefined {
    return this.#element.getAttribute(name) ?? undefined;
  }

  #number(name: string, otherwise: number): number {
    const text = this.#text(name)?.trim();
    const number = text ? Number(text) : NaN;
    return Number.isFinite(number) ? number : otherwise;
  }
}
