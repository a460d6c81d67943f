// SPDX-License-Identifier: MIT
//
// The panel's report on the mesh, notes on it, and the fields that say how it is made of its file.

import { type MeshInfo, repairSentences } from 'geodesic-voronoi';
import { buildAttributes } from '../../viewer/attributes/attribute_defaults.js';
import type { GeodesicVoronoiElement } from '../../viewer/element.js';
import { make } from '../../viewer/stage/make.js';
import { bindAttributes, byId, listen } from '../base/dom.js';
import { showNote } from '../base/messages.js';
import { counted, integer, measure } from '../base/numbers.js';

/**
 * The memory of a mesh with the diagram of a few hundred sites, measured in Node at 280,000
 * triangles: 690 bytes each with exact distances, 580 with DGPC.
 */
const bytesPerFace = 700;
/** The memory of a browser's tab to rely on; 32-bit WebAssembly has at most 4 GB. */
const bytesThatFit = 1.2e9;

/** The attribute `weld` that joins seams and T-junctions as wide as they are looked for. */
const joiningWeld = '1e-6';

/** Sets up the report on the mesh and the options by which it is built from its file. */
export function setUpMeshReport(viewer: GeodesicVoronoiElement): void {
  // A change opens the model anew.
  bindAttributes(viewer, ...buildAttributes);
  const report = byId('report', HTMLElement);
  const repairs = byId('repairs', HTMLElement);
  listen(viewer, 'load', ({ info }) => {
    report.replaceChildren(
      ...factsOf(info).flatMap(([term, value]) => [make('dt', {}, term), make('dd', {}, value)]),
    );
    repairs.replaceChildren(...sentencesOf(info).map((sentence) => make('span', {}, sentence)));
    const isWelded = Number(viewer.getAttribute('weld')) >= Number(joiningWeld);
    noteOn(info, isWelded ? undefined : () => viewer.setAttribute('weld', joiningWeld));
  });
}

/**
 * Notes the most important one of what a reader should know of a mesh, if there is any. `weld` joins
 * what touches, unless that was done.
 */
function noteOn(info: MeshInfo, weld: (() => void) | undefined): void {
  const { faces, repairs, hasOpenSeams, hasTJunctions } = info;
  const bytes = faces * bytesPerFace;
  const cuts = repairs.orientationCuts + repairs.nonManifoldEdges;
  if (bytes > bytesThatFit) {
    showNote(
      `This model has ${integer(faces)} triangles, which take about ` +
        `${(bytes / 1e9).toFixed(1)} GB of memory: a coarser model is safer.`,
    );
  } else if (weld && (hasOpenSeams || hasTJunctions)) {
    showNote('Some triangles of this model touch without being joined: no path leads across.', {
      title: 'Join them',
      act: weld,
    });
  } else if (cuts > 0) {
    showNote(
      `This model is cut apart at ${counted(cuts, 'edge')} where triangles do not fit: no path leads across.`,
    );
  }
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

/** What the mesh builder and the reader of the file did. */
function sentencesOf({ repairs, notes }: MeshInfo): string[] {
  const made = repairSentences(repairs, measure);
  const texts = [...(made.length > 0 ? made : ['No repairs needed']), ...notes];
  return texts.map((text) => `${text[0].toUpperCase()}${text.slice(1)}.`);
}
