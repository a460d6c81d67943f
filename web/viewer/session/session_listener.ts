// SPDX-License-Identifier: MIT
//
// The messages of a session, and their vocabulary.

import type { CvtState, DiagramChange } from 'geodesic-voronoi';
import type { PreparedDiagram } from '../buffers/diagram_geometry.js';
import type { FailureType } from './failure.js';
import type { OpenedMesh } from './mesh_opening.js';
import type { DiagramSettings, ShownDiagram } from './shown_diagram.js';
import type { Tints } from './site_history.js';

/** 'failed': the first model could not be opened; there is none. */
export type Status = 'empty' | 'loading' | 'computing' | 'iterating' | 'ready' | 'failed';

/**
 * Where a centroidal tessellation of the present sites stands: 'idle' if none has begun, 'done' if
 * no iteration lowers the energy any more.
 */
export type CvtStatus = 'idle' | 'running' | 'paused' | 'done';

/** How the drawing comes to a diagram: from the one before by changes, or from all of its geometry. */
export interface DrawingUpdate {
  /** The changes that led from the diagram drawn before to this one. */
  changes?: readonly DiagramChange[];
  /** The geometry of the whole diagram; undefined without sites. */
  prepared?: PreparedDiagram;
}

/** Gets told about changes after they were made. */
export interface SessionListener {
  modelChanged(opened: OpenedMesh): void;
  sitesChanged(): void;
  /** The density changed by undoing or redoing, or after a failure. */
  densityChanged(tints: Tints): void;
  diagramChanged(shown: ShownDiagram, milliseconds: number, update: DrawingUpdate): void;
  /** Sites and diagram are now those of an iteration. */
  cvtIterated(shown: ShownDiagram, state: CvtState, update: DrawingUpdate): void;
  /** Iterations have paused: the last one shown is now the diagram, like any other. */
  cvtRested(shown: ShownDiagram, milliseconds: number): void;
  cvtStatusChanged(status: CvtStatus): void;
  /** After a failure or a cancel: what is asked for is again the diagram that is shown. */
  settingsRestored(settings: DiagramSettings): void;
  statusChanged(status: Status): void;
  progressed(share: number): void;
  /** Something failed; model, sites and diagram are those from before. */
  failed(type: FailureType, error: unknown): void;
}
