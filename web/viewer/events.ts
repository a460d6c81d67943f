// SPDX-License-Identifier: MIT
//
// The events of the element.

import type { MeshInfo, MeshPart, Metric, Violation } from 'geodesic-voronoi';
import type { HoveredPoint } from './tools/hover.js';
import type { FailureType } from './session/failure.js';
import type { CvtStatus, Status } from './session/session_listener.js';

/** The result of an iteration of a centroidal tessellation. */
export interface CvtIteration {
  /** 0 for the sites at the start. */
  iteration: number;
  /**
   * Σ ∫ ρ d² over the regions, d the distance to the region's site, ρ the density. It never rises.
   */
  energy: number;
  /**
   * The energy divided by that of as many regular hexagons with the same total area in the plane,
   * the least possible on a surface without curvature. With a density, hexagons are sized by it.
   */
  relativeEnergy: number;
  /** The farthest that a site moved in this iteration, in the model's units. */
  largestMove: number;
}

/** The `detail` of this element's events, by their name. */
export interface ViewerEvents {
  /** A model was opened, or opened once more: built otherwise, or since the library had stopped. */
  load: { name: string; info: MeshInfo; parts: readonly MeshPart[] };
  /** Something failed, in a sentence; everything is as it was before. */
  error: { type: FailureType; message: string; cause?: unknown };
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
  /** The dual is drawn (null: no longer). Without violations it has the topology of the surface. */
  dual: { polygons: number; violations: readonly Violation[] } | null;
  /** Distances are drawn (null: no longer); `longest` is the greatest of them. */
  distances: { longest: number } | null;
  /** The file's own material is drawn, if any (null: no longer); `problem`: why it cannot be read. */
  original: { isFound: boolean; textures: number; problem?: string } | null;
  /** The exploded view is drawn (null: no longer). */
  exploded: { regions: number; triangles: number } | null;
  /** The sites or the selection changed; the diagram follows. */
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

/** The events that listeners to the element get. */
export type ViewerEventMap = { [Type in keyof ViewerEvents]: CustomEvent<ViewerEvents[Type]> };

/** Dispatches an event. */
export type Emit = <Type extends keyof ViewerEvents>(
  type: Type,
  detail: ViewerEvents[Type],
) => void;
