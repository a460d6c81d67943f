// SPDX-License-Identifier: MIT
//
// The panel's report on the mesh, and the fields that say how it is made of its file.

import { type MeshInfo, repairSentences } from 'geodesic-voronoi';
import { buildAttributes } from '../../viewer/attributes/attribute_defaults.js';
import type { GeodesicVoronoiElement } from '../../viewer/element.js';
import { make } from '../../viewer/stage/make.js';
import { bindAttributes, byId, listen } from '../base/dom.js';
import { showNote } from '../base/messages.js';
import { counted, integer, measure } from '../base/numbers.js';

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
    const { orientationCuts, nonManifoldEdges } = info.repairs;
    const cuts = orientationCuts + nonManifoldEdges;
    if (info.hasOpenSeams) {
      showNote(
        'Some triangles of this model have tiny gaps between them: distances lead around these.',
        { title: 'Weld them', act: () => viewer.setAttribute('weld', '1e-6') },
      );
    } else if (cuts > 0) {
      showNote(
        `This model is cut apart at ${counted(cuts, 'edge')} where its triangles do not fit together: ` +
          'no path leads across. “Model”, in the controls, tells more.',
      );
    }
  });
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
