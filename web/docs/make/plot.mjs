// SPDX-License-Identifier: MIT
//
// Plots with logarithmic axes, as SVG.

import { Drawing } from './drawing.mjs';

const [width, height] = [760, 380];
const area = { left: 70, top: 40, right: 560, bottom: 320 };

/**
 * Series are { name, points: [x, y][], colour, isMarks }: a line with marks, or with `isMarks` vertical
 * bars from y[0] to y[1]. Ticks are numbers, shown as `show` says.
 */
export function plot({ title, x, y, series }) {
  const drawing = new Drawing(width, height, { title, kind: 'plot' });
  const at = (axis, low, high) => {
    const [from, to] = axis.range.map(Math.log10);
    return (value) => low + ((Math.log10(value) - from) / (to - from)) * (high - low);
  };
  const [toX, toY] = [at(x, area.left, area.right), at(y, area.bottom, area.top)];
  drawing.text({ x: area.left, y: 20 }, title);
  for (const tick of y.ticks) {
    const level = toY(tick);
    drawing.segments(
      [
        [
          { x: area.left, y: level },
          { x: area.right, y: level },
        ],
      ],
      'grid',
    );
    drawing.text({ x: area.left - 8, y: level + 4 }, y.show(tick), 'small soft end');
  }
  for (const tick of x.ticks) {
    const along = toX(tick);
    drawing.segments(
      [
        [
          { x: along, y: area.bottom },
          { x: along, y: area.top },
        ],
      ],
      'grid',
    );
    drawing.text({ x: along, y: area.bottom + 18 }, x.show(tick), 'small soft middle');
  }
  drawing.text({ x: (area.left + area.right) / 2, y: area.bottom + 40 }, x.name, 'small middle');
  const labels = [];
  for (const { name, points, colour, isMarks } of series) {
    if (isMarks) drawBars(drawing, points, toX, toY, colour);
    else drawLine(drawing, points, toX, toY, colour);
    const last = points.at(-1)[1];
    labels.push({ name, colour, y: toY(isMarks ? Math.sqrt(last[0] * last[1]) : last) });
  }
  for (const { name, colour, y: level } of spread(labels)) {
    drawing.circle({ x: area.right + 18, y: level }, 4, '', colour);
    drawing.text({ x: area.right + 28, y: level + 4 }, name, 'small');
  }
  return drawing;
}

function drawLine(drawing, points, toX, toY, colour) {
  const places = points.map(([a, b]) => ({ x: toX(a), y: toY(b) }));
  drawing.polyline(places, 'line', colour);
  for (const place of places) drawing.circle(place, 3.5, '', colour);
}

function drawBars(drawing, points, toX, toY, colour) {
  for (const [a, [low, high]] of points) {
    const x = toX(a);
    drawing.segments(
      [
        [
          { x, y: toY(low) + 3 },
          { x, y: toY(high) - 3 },
        ],
      ],
      'bar',
      colour,
    );
  }
}

/** Names beside the plot, moved down where they would lie on one another. */
function spread(labels) {
  const sorted = [...labels].sort((a, b) => a.y - b.y);
  sorted.forEach((label, i) => {
    const least = i > 0 ? sorted[i - 1].y + 18 : area.top;
    label.y = Math.max(label.y, least);
  });
  return sorted;
}
