// SPDX-License-Identifier: MIT
//
// The facts of a mesh, as `info` prints them.
import type { MeshInfo, MeshRepairs } from '../results.js';

/** The text after the count of each repair; begins with the noun that is counted. */
const repairTexts: Record<Exclude<keyof MeshRepairs, 'mollification'>, string> = {
  weldedVertices: 'vertices welded to earlier ones at their place',
  isolatedVertices: 'vertices without a triangle',
  nonFiniteTriangles: 'triangles with a corner that is not finite, dropped',
  degenerateTriangles: 'triangles with two equal corners, dropped',
  duplicateTriangles: 'triangles given twice, dropped',
  nonManifoldEdges: 'edges of three or more triangles, cut apart',
  orientationCuts: 'edges cut because the surface has one side only',
  flippedTriangles: 'triangles turned over to agree with their neighbours',
  smallComponents: 'components with fewer triangles than asked for, dropped',
  smallComponentTriangles: 'triangles of these, dropped with them',
  splitVertices: 'vertices split that joined separate fans of triangles',
  mollifiedTriangles: 'triangles flat or tiny: for distances, all edges are longer',
};

const singular: Record<string, string> = {
  vertices: 'vertex',
  triangles: 'triangle',
  edges: 'edge',
  components: 'component',
};

/** A count and a text that begins with what is counted, in the plural. */
function counted(count: number, text: string): string {
  return `${count} ${count === 1 ? text.replace(/^\w+/, (plural) => singular[plural] ?? plural) : text}`;
}

/** The facts of a mesh, a line each, for people; `unit` is that of lengths, if it has a name. */
export function meshReport(facts: MeshInfo, unit: string | undefined): string {
  const number = (x: number) => String(Number(x.toPrecision(6)));
  const length = (x: number) => (unit ? `${number(x)} ${unit}` : number(x));
  const { format, file } = facts.origin;
  const rows: [string, string][] = [
    ['format', file ? `${format} (${file})` : format],
    ['triangles', `${facts.faces} (${facts.inputFaces} in the file)`],
    ['vertices', `${facts.vertices} (${facts.inputVertices} in the file)`],
    ['edges', String(facts.edges)],
    ['components', String(facts.components)],
    ['boundary loops', String(facts.boundaryLoops)],
    ['genus', String(facts.genus)],
    ['Euler characteristic', String(facts.eulerCharacteristic)],
    ['area', unit ? `${number(facts.area)} ${unit}²` : number(facts.area)],
    ['bounding diagonal', length(facts.boundingDiagonal)],
  ];
  const lines = rows.map(([name, value]) => `${name.padEnd(22)}${value}`);
  for (const [name, text] of Object.entries(repairTexts)) {
    const count = facts.repairs[name as keyof MeshRepairs];
    if (count > 0) lines.push(`repair: ${counted(count, text)}`);
  }
  const { mollification } = facts.repairs;
  if (mollification > 0) lines[lines.length - 1] += ` by ${length(mollification)}`;
  for (const note of facts.notes) lines.push(`note: ${note}`);
  return `${lines.join('\n')}\n`;
}
