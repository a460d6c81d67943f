// SPDX-License-Identifier: MIT
//
// Drawings of a mesh as SVG: seen from afar, in parallel projection, what is hidden left out. The same
// input gives the same text.

import { escaped } from './markup.mjs';

/** A tenth of a pixel: enough for the eye, and texts stay short. */
const number = (x) => String(Number(x.toFixed(1)));
const place = ({ x, y }) => `${number(x)},${number(y)}`;

/** Colours by class, in light and in dark: an SVG in a page follows the reader's preference. */
const style = `
  text { font: 13px system-ui, sans-serif; fill: #1f2933 }
  .small { font-size: 11px } .soft { fill: #5b6672 } .end { text-anchor: end } .middle { text-anchor: middle }
  .surface { fill: #e9ecef; stroke: #c3cad1; stroke-width: .6 }
  .region { stroke: #1f293326; stroke-width: .6 }
  .cell { stroke: none }
  .base { fill: #e9ecef; stroke: #d6336c; stroke-width: 1.2; stroke-linejoin: round }
  .line { fill: none; stroke: #1f2933; stroke-width: 1.8; stroke-linejoin: round; stroke-linecap: round }
  .thin { fill: none; stroke: #5b6672; stroke-width: .8 } .grid { fill: none; stroke: #5b667240; stroke-width: .8 }
  .path { fill: none; stroke: #d6336c; stroke-width: 2.4; stroke-linejoin: round; stroke-linecap: round }
  .strip { fill: #d6336c24; stroke: #d6336c; stroke-width: .8 }
  .bar { fill: none; stroke-width: 7; stroke-linecap: round } .site { fill: #1f2933; stroke: #fff; stroke-width: 1.5 } .point { fill: #fff; stroke: #1f2933; stroke-width: 1.5 }
  @media (prefers-color-scheme: dark) {
    text { fill: #e7eaee } .soft { fill: #9aa5b1 }
    .surface { fill: #2a3038; stroke: #46505c } .base { fill: #2a3038; stroke: #ff7aa8 } .thin { stroke: #9aa5b1 } .thin.on { stroke: #5b6672 } .grid { stroke: #9aa5b140 }
    .plot .line { stroke: #e7eaee } .plain .line { stroke: #e7eaee } .path { stroke: #ff7aa8 }
    .strip { fill: #ff7aa824; stroke: #ff7aa8 }
  }`.replace(/\s*\n\s*/g, '\n');

/** A drawing to which things are added in order, later ones on top. */
export class Drawing {
  #parts = [];

  constructor(width, height, { title, kind = '' }) {
    Object.assign(this, { width, height, title, kind });
  }

  add(part) {
    this.#parts.push(part);
  }

  polygon(points, className, fill) {
    const paint = fill === undefined ? '' : ` style="fill:${fill}"`;
    this.add(`<polygon class="${className}"${paint} points="${points.map(place).join(' ')}"/>`);
  }

  polyline(points, className, colour) {
    const paint = colour === undefined ? '' : ` style="stroke:${colour}"`;
    this.add(`<polyline class="${className}"${paint} points="${points.map(place).join(' ')}"/>`);
  }

  /** Many straight pieces in one element. */
  segments(pairs, className, colour) {
    if (pairs.length === 0) return;
    const paint = colour === undefined ? '' : ` style="stroke:${colour}"`;
    const data = pairs.map(([a, b]) => `M${place(a)}L${place(b)}`).join('');
    this.add(`<path class="${className}"${paint} d="${data}"/>`);
  }

  circle({ x, y }, radius, className, colour) {
    const paint = colour === undefined ? '' : ` style="fill:${colour}"`;
    const at = `cx="${number(x)}" cy="${number(y)}" r="${number(radius)}"`;
    this.add(`<circle class="${className}"${paint} ${at}/>`);
  }

  text({ x, y }, text, className = '') {
    this.add(
      `<text class="${className}" x="${number(x)}" y="${number(y)}">${escaped(text)}</text>`,
    );
  }

  toString() {
    const { width, height, title, kind } = this;
    return [
      `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" class="${kind}" role="img">`,
      `<title>${escaped(title)}</title>`,
      `<style>${style}</style>`,
      ...this.#parts,
      '</svg>\n',
    ].join('\n');
  }
}

/** How a mesh is looked at: where its points are in a rectangle, and what of it is seen. */
export class View {
  #faces = [];

  /** `turn` about the vertical axis, then `tilt` towards the eye, in radians. */
  constructor({ positions, indices }, { turn, tilt, box: { x, y, width, height } }) {
    this.#turning = [Math.sin(turn), Math.cos(turn), Math.sin(tilt), Math.cos(tilt)];
    const corners = [];
    for (let i = 0; i < positions.length; i += 3) corners.push(this.#turned(positions, i));
    const span = (axis) => {
      const values = corners.map((corner) => corner[axis]);
      return [Math.min(...values), Math.max(...values)];
    };
    const [left, right] = span('x');
    const [top, bottom] = span('y');
    this.scale = Math.min(width / (right - left), height / (bottom - top));
    this.#shift = {
      x: x + width / 2 - (this.scale * (left + right)) / 2,
      y: y + height / 2 - (this.scale * (top + bottom)) / 2,
    };
    const placed = corners.map((corner) => this.#placed(corner));
    for (let t = 0; t < indices.length; t += 3) {
      this.#faces.push([0, 1, 2].map((i) => placed[indices[t + i]]));
    }
  }

  #turning;
  #shift;

  #turned(list, i) {
    const [sinTurn, cosTurn, sinTilt, cosTilt] = this.#turning;
    const [px, py, pz] = [list[i], list[i + 1], list[i + 2]];
    const [x, z] = [cosTurn * px + sinTurn * pz, cosTurn * pz - sinTurn * px];
    return { x, y: -(cosTilt * py - sinTilt * z), depth: sinTilt * py + cosTilt * z };
  }

  #placed({ x, y, depth }) {
    const { scale } = this;
    return { x: scale * x + this.#shift.x, y: scale * y + this.#shift.y, depth: scale * depth };
  }

  /** Where the point that starts at entry 3i of a list of coordinates is; its depth grows towards the eye. */
  place(positions, i) {
    return this.#placed(this.#turned(positions, 3 * i));
  }

  /** The faces that look this way, the farthest first: their indices. */
  facesInOrder() {
    const depth = (f) => this.#faces[f].reduce((sum, corner) => sum + corner.depth, 0);
    return [...this.#faces.keys()]
      .filter((f) => doubleArea(...this.#faces[f]) < 0)
      .sort((f, g) => depth(f) - depth(g));
  }

  corners(f) {
    return this.#faces[f];
  }

  /** Whether nothing of the mesh is before a place. */
  sees(point) {
    const margin = 0.02 * this.scale;
    return !this.#faces.some((corners) => {
      const weights = corners.map((_, i) =>
        doubleArea(point, corners[(i + 1) % 3], corners[(i + 2) % 3]),
      );
      const isInside = weights.every((w) => w < 0) || weights.every((w) => w > 0);
      if (!isInside) return false;
      const sum = weights.reduce((a, b) => a + b);
      const depth = weights.reduce((d, w, i) => d + (w / sum) * corners[i].depth, 0);
      return depth > point.depth + margin;
    });
  }

  /** The straight pieces between neighbours in a list of places, those that are seen. */
  seen(pairs) {
    return pairs.filter(([a, b]) =>
      this.sees({ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, depth: (a.depth + b.depth) / 2 }),
    );
  }
}

/** Negative if the corners go round counterclockwise on a page, whose y axis points down. */
const doubleArea = (a, b, c) => (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);

/** The pairs of neighbours in a list. */
export const pairsOf = (list) => list.slice(1).map((item, i) => [list[i], item]);
