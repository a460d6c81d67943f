// SPDX-License-Identifier: MIT
//
// What a session tells, and its words.

import type { CvtState, DiagramChange, Sampling } from 'geodesic-voronoi';
import type { PreparedDiagram } from './diagram_geometry.js';
import type { OpenedMesh } from './mesh_opening.js';
import type { DiagramSettings, ShownDiagram } from './shown_diagram.js';
import type { Sites, Tints } from './site_history.js';

/** 'failed': the first model could not be opened; there is none. */
export type Status = 'empty' | 'loading' | 'computing' | 'iterating' | 'ready' | 'failed';

/**
 * Where a centroidal tessellation of the present sites stands: 'idle' if none has begun, 'done' if
 * no iteration lowers the energy any more.
 */
export type CvtStatus = 'idle' | 'running' | 'paused' | 'done';

/** How sites are scattered. */
export interface Scattering {
  count: number;
  seed: number;
  sampling?: Sampling;
  /** As far as there are sites enough. */
  perComponent?: number;
}

/** What helps to draw a diagram. */
export interface Drawable {
  /** The diagram drawn before has become this one by these. */
  changes?: readonly DiagramChange[];
  /** All of it; undefined without sites. */
  prepared?: PreparedDiagram;
}

/** Told what changed, after it did. */
export interface SessionListener {
  modelChanged(opened: OpenedMesh): void;
  sitesChanged(sites: Sites): void;
  /** By undoing or redoing; after a failure too. */
  densityChanged(tints: Tints): void;
  diagramChanged(shown: ShownDiagram, milliseconds: number, how: Drawable): void;
  /** Sites and diagram are those of an iteration. */
  cvtIterated(shown: ShownDiagram, state: CvtState, how: Drawable): void;
  /** Iterations have been paused: the one that is shown is the diagram of the sites as any other. */
  cvtRested(shown: ShownDiagram, milliseconds: number): void;
  cvtStatusChanged(status: CvtStatus): void;
  /** After a failure or a cancel: the settings are again those of the diagram that is shown. */
  settingsRestored(settings: DiagramSettings): void;
  statusChanged(status: Status): void;
  progressed(share: number): void;
  /** Whatever failed, the model, the sites and the diagram are those from before. */
  failed(error: unknown): void;
}
