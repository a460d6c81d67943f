// SPDX-License-Identifier: MIT
//
// The panel's report on the mesh, and the fields that say how it is made of its file.

import type { MeshInfo, MeshRepairs } from 'geodesic-voronoi';
import type { GeodesicVoronoiElement } from '../viewer/element.js';
import { byId, listen, showAttributes } from './dom.js';
import { counted, integer, measure } from './numbers.js';

/** Sets up the report on the mesh and the options by which it is built from its file. */
export function setUpMeshReport(viewer: GeodesicVoronoiElement): void {
  setUpBuild(viewer);
  const report = byId('report', HTMLElement);
  const repairs = byId('repairs', HTMLElement);
  listen(viewer, 'load', ({ info }) => {
    report.replaceChildren(
      ...factsOf(info).flatMap(([term, value]) => [cell('dt', term), cell('dd', value)]),
    );
    repairs.replaceChildren(
      ...[...sentencesOf(info.repairs), ...info.notes].map((sentence) => cell('span', sentence)),
    );
  });
}

/** A change opens the model anew. */
function setUpBuild(viewer: GeodesicVoronoiElement): void {
  const fields = {
    weld: byId('weld', HTMLSelectElement),
    orientation: byId('orientation', HTMLSelectElement),
    'min-component': byId('min-component', HTMLInputElement),
  };
  for (const [name, field] of Object.entries(fields)) {
    field.addEventListener('change', () => {
      if (field.reportValidity()) viewer.setAttribute(name, field.value);
    });
  }
  showAttributes(viewer, fields);
}

function factsOf(info: MeshInfo): [string, string][] {
  return [
    ['Triangles', integer(info.faces)],
    ['Vertices', integer(info.vertices)],
    ['Components', integer(info.components)],
    ['Boundary loops', integer(info.boundaryLoops)],
    ['Genus', integer(info.genus)],
    ['Area', measure(info.area)],
  ];
}

function sentencesOf(repairs: MeshRepairs): string[] {
  const texts: Record<Exclude<keyof MeshRepairs, 'mollification'>, (n: number) => string> = {
    weldedVertices: (n) => `${counted(n, 'vertex', 'vertices')} welded.`,
    isolatedVertices: (n) => `${counted(n, 'vertex', 'vertices')} unused.`,
    nonFiniteTriangles: (n) => `${counted(n, 'triangle')} with impossible coordinates dropped.`,
    degenerateTriangles: (n) => `${counted(n, 'degenerate triangle')} dropped.`,
    duplicateTriangles: (n) => `${counted(n, 'duplicate triangle')} dropped.`,
    nonManifoldEdges: (n) => `${counted(n, 'non-manifold edge')} cut.`,
    orientationCuts: (n) => `${counted(n, 'edge')} cut, since no orientation fits both sides.`,
    flippedTriangles: (n) => `${counted(n, 'triangle')} turned over.`,
    smallComponents: (n) => `${counted(n, 'small component')} dropped.`,
    smallComponentTriangles: (n) => `${counted(n, 'triangle')} of these dropped.`,
    splitVertices: (n) => `${counted(n, 'vertex', 'vertices')} split.`,
    mollifiedTriangles: (n) =>
      `${counted(n, 'flat or tiny triangle')}: for distances, all edges are longer by ${measure(repairs.mollification)}.`,
  };
  const made = (Object.keys(texts) as (keyof typeof texts)[]).filter((key) => repairs[key] > 0);
  return made.length > 0 ? made.map((key) => texts[key](repairs[key])) : ['No repairs needed.'];
}

function cell(tag: string, text: string): HTMLElement {
  const element = document.createElement(tag);
  element.textContent = text;
  return element;
}
