// SPDX-License-Identifier: MIT
//
// Makes the diagram that is shown: by a few changes of the one before, or anew.

import type {
  Diagram,
  DiagramChange,
  DiagramData,
  Mesh,
  Metric,
  TaskOptions,
} from 'geodesic-voronoi';
import type { PreparedDiagram } from '../buffers/diagram_geometry.js';
import type { DiagramSummary } from '../buffers/diagram_summary.js';
import { type Sites, surfacePointsOf } from './site_history.js';
import { type SiteStep, stepsBetween } from './site_step.js';

/** Prepares a diagram of these sites for drawing; undefined if there is no model any more. */
export type PrepareDiagram = (
  data: DiagramData,
  sites: Sites,
) => Promise<PreparedDiagram | undefined>;

export interface DiagramSettings {
  metric: Metric;
  detail: number;
}

/** The sites and settings that a diagram is made from. */
export interface DiagramRequest extends DiagramSettings {
  sites: Sites;
}

/** A diagram with what it was made from. Its labels are the indices of the sites. */
export interface ShownDiagram extends DiagramRequest {
  /** Undefined without sites. */
  summary: DiagramSummary | undefined;
  /** Undefined without sites, and after a change that failed. */
  diagram: Diagram | undefined;
}

/** Computes the diagram of a request; undefined without sites. */
export async function computeDiagram(
  mesh: Mesh | undefined,
  { sites, metric, detail }: DiagramRequest,
  task: TaskOptions,
): Promise<Diagram | undefined> {
  if (sites.length === 0) return undefined;
  return mesh?.voronoi(surfacePointsOf(sites), { metric, detail, ...task });
}

/**
 * Turns the shown diagram into the one asked for, if a step or two are enough. That costs as
 * much as a few regions, and the first step on a diagram as much as all of them; it cannot be
 * aborted. Undefined if more steps are needed, or if one fails: `shown` has no diagram then.
 */
export async function changeDiagram(
  shown: ShownDiagram | undefined,
  { sites, metric, detail }: DiagramRequest,
): Promise<DiagramChange[] | undefined> {
  const diagram = shown?.diagram;
  if (!diagram || shown.metric !== metric || shown.detail !== detail) return undefined;
  const steps = sites.length > 0 && stepsBetween(shown.sites, sites);
  if (!steps) return undefined;
  try {
    return await Promise.all(steps.map((step) => takeStep(diagram, step)));
  } catch {
    // With only one of two steps taken, the diagram has neither the sites of `shown` nor those asked
    // for. The caller computes another one, or finds out why it cannot be computed.
    diagram.dispose();
    shown.diagram = undefined;
    return undefined;
  }
}

function takeStep(diagram: Diagram, step: SiteStep): Promise<DiagramChange> {
  if (step.kind === 'remove') return diagram.removeSite(step.index);
  const place = surfacePointsOf([step.site]);
  if (step.kind === 'insert') return diagram.insertSite(place);
  return diagram.moveSite(step.index, place);
}

/** What is told of a diagram that took so long. */
export function factsOf({ sites, summary, metric, detail }: ShownDiagram, milliseconds: number) {
  return {
    sites: sites.length,
    regions: summary?.regionCount ?? 0,
    segments: summary?.segmentCount ?? 0,
    arcs: summary?.arcCount ?? 0,
    voronoiPoints: summary?.voronoiPointCount ?? 0,
    metric,
    detail,
    milliseconds,
  };
}
