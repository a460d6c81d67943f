// SPDX-License-Identifier: MIT
//
// The events of the element.

import type { MeshInfo, MeshPart, Metric, Violation } from 'geodesic-voronoi';
import type { HoveredPoint } from './hover.js';
import type { CvtStatus, Status } from './session_listener.js';

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
  /** The file's own material is drawn if it has any; `problem` says why it cannot be read. Null: no more. */
  original: { isFound: boolean; textures: number; problem?: string } | null;
  /** The regions are drawn apart; null: they are together again. */
  exploded: { regions: number; triangles: number } | null;
  /** The sites or the choice of one changed; the diagram follows. */
  'sites-change': { count: number; selected: number; canUndo: boolean; canRedo: boolean };
  /** Sites and diagram are those of an iteration now; a `diagram` event follows when it pauses. */
  'cvt-iteration': CvtIteration;
  'cvt-change': { status: CvtStatus };
  /** The density was painted, set or cleared. */
  'density-change': { isUniform: boolean };
  /** The share done, 0 … 1, of what is under way. */
  progress: { totalProgress: number; reason: 'loading' | 'computing' };
  /** The camera has moved; the orbit as `cameraOrbit` has it. */
  'camera-change': { orbit: string };
  /** The poster is shown no more. */
  'poster-dismissed': null;
  'status-change': { status: Status };
  /** What lies under the pointer, and its region's colour as CSS has it; null if nothing does. */
  hover: (HoveredPoint & { colour: string | undefined }) | null;
}

/** What listeners to the element get. */
export type ViewerEventMap = { [Type in keyof ViewerEvents]: CustomEvent<ViewerEvents[Type]> };

/** Dispatches an event. */
export type Emit = <Type extends keyof ViewerEvents>(
  type: Type,
  detail: ViewerEvents[Type],
) => void;
