// SPDX-License-Identifier: MIT
//
// The facts of a mesh, as `info` prints them.

import type { MeshInfo } from '../api/results.js';
import { integer, repairSentences } from '../base/sentences.js';

/** The facts of a mesh, a line each, for people; `unit` is that of lengths, if it has a name. */
export function meshReport(
  facts: MeshInfo,
  { unit, isSubdivided }: { unit: string | undefined; isSubdivided: boolean },
): string {
  const input = isSubdivided ? 'subdivided file' : 'file';
  const number = (x: number) => String(Number(x.toPrecision(6)));
  const length = (x: number) => (unit ? `${number(x)} ${unit}` : number(x));
  const { format, file } = facts.origin;
  const rows: [string, string][] = [
    ['format', file ? `${format} (${file})` : format],
    ['triangles', `${integer(facts.faces)} (${integer(facts.inputFaces)} in the ${input})`],
    ['vertices', `${integer(facts.vertices)} (${integer(facts.inputVertices)} in the ${input})`],
    ['edges', integer(facts.edges)],
    ['components', integer(facts.components)],
    ['boundary loops', integer(facts.boundaryLoops)],
    ['genus', integer(facts.genus)],
    ['Euler characteristic', integer(facts.eulerCharacteristic)],
    ['area', unit ? `${number(facts.area)} ${unit}²` : number(facts.area)],
    ['bounding diagonal', length(facts.boundingDiagonal)],
  ];
  const lines = rows.map(([name, value]) => `${name.padEnd(22)}${value}`);
  for (const sentence of repairSentences(facts.repairs, length)) lines.push(`repair: ${sentence}`);
  for (const note of facts.notes) lines.push(`note: ${note}`);
  return `${lines.join('\n')}\n`;
}
