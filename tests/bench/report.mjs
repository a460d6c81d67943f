// SPDX-License-Identifier: MIT
//
// What was measured, as tables for people.

export function report(measured) {
  const { runs, detail, cases, caseSummaries = [] } = measured;
  const speed = measured.speed.flatMap(perMetric);
  const ladder = (text) => [ladderColumns(speed, text), ladderRows(speed)];
  const sections = [
    [`Speed: detail ${detail}; CPU time of the fastest of ${runs}`, speedColumns, speed],
    ['Speed by number of sites: distances and diagram, over Dijkstra', ...ladder(overDijkstra)],
    ['Changes by number of sites: one site moved to the next face', ...ladder(changeTime)],
    ['Speed by number of faces', speedColumns, measured.size.flatMap(perMetric)],
    ['Accuracy: against CGAL', scoreColumns, measured.accuracy.flatMap(perMetric)],
    [
      'Accuracy: against the cases given',
      scoreColumns,
      [...cases, ...caseSummaries].flatMap(perMetric),
    ],
    [
      'Convergence: area given to another site, by detail',
      detailColumns,
      measured.byDetail.flatMap(perMetric),
    ],
    [
      'Convergence: finer and finer meshes in a sphere, against great circles',
      refinementColumns,
      withOrders(measured.byRefinement.flatMap(perMetric)),
    ],
    [
      'Centroidal tessellations: energy as a multiple of that of hexagons in the plane',
      tessellationColumns,
      measured.tessellations.flatMap(perMethod),
    ],
  ];
  const texts = sections
    .filter(([, columns, rows]) => columns && rows.length > 0)
    .map(([title, columns, rows]) => `${title}\n\n${table(columns, rows)}`);
  if (measured.accuracyNote) texts.push(`Accuracy: ${measured.accuracyNote}`);
  return texts.join('\n\n');
}

/** A row per mesh and metric. */
function perMetric({ metrics, ...mesh }) {
  return Object.entries(metrics).map(([metric, values]) => ({ ...mesh, metric, ...values }));
}

/** A row per mesh and method of tessellation. */
function perMethod({ methods, ...mesh }) {
  return Object.entries(methods).map(([method, values]) => ({ ...mesh, method, ...values }));
}

/** How fast an error falls from one mesh to the next, of which the sides are half as long. */
function withOrders(rows) {
  return rows.map((row) => {
    const coarser = rows.find(
      ({ metric, faces }) => metric === row.metric && 4 * faces === row.faces,
    );
    return { ...row, coarser };
  });
}

/** The mean and the worst of all cases, for each metric that has scores. */
export function summaries(cases) {
  const summary = (title, of) => {
    const metrics = {};
    for (const metric of Object.keys(cases[0].metrics)) {
      const scores = cases.map(({ metrics }) => metrics[metric]);
      if (scores.some(({ note }) => note)) continue;
      metrics[metric] = {
        mislabelled: of(scores.map(({ mislabelled }) => mislabelled)),
        meanError: of(scores.map(({ meanError }) => meanError)),
        largestError: of(scores.map(({ largestError }) => largestError)),
      };
    }
    return { case: title, metrics };
  };
  return [
    summary('mean', (values) => values.reduce((sum, value) => sum + value) / values.length),
    summary('worst', (values) => Math.max(...values)),
  ];
}

const milliseconds = (seconds) => `${(1000 * seconds).toFixed(1)} ms`;
const ratio = (a, b) => (a === undefined ? undefined : `${(a / b).toFixed(2)} ×`);
const fraction = (a, b) => (2 * a < b ? `1/${Math.round(b / a)}` : ratio(a, b));
const percent = (share) => `${(100 * share).toFixed(3)} %`;
const smallPercent = (share) => `${(100 * share).toFixed(5)} %`;

/** Titles, with what a row has there; undefined where it has nothing. */
const speedColumns = {
  mesh: ({ mesh }) => mesh,
  faces: ({ faces }) => faces,
  sites: ({ sites }) => sites,
  Dijkstra: ({ dijkstra }) => milliseconds(dijkstra),
  metric: ({ metric }) => metric,
  distances: (row) => unlessNoted(row, () => milliseconds(row.distances)),
  '': (row) => unlessNoted(row, () => ratio(row.distances, row.dijkstra)),
  diagram: (row) => unlessNoted(row, () => milliseconds(row.diagram)),
  ' ': (row) => unlessNoted(row, () => ratio(row.diagram, row.dijkstra)),
  both: (row) => unlessNoted(row, () => ratio(row.distances + row.diagram, row.dijkstra)),
  'partition/both': (row) =>
    unlessNoted(row, () => ratio(row.partition, row.distances + row.diagram)),
  // Where sites can be changed in place.
  'change/both': (row) =>
    unlessNoted(row, () => row.change && fraction(row.change, row.distances + row.diagram)),
  memory: (row) => unlessNoted(row, () => `${Math.round(row.bytesPerFace)} B/face`),
  'wasm/native': (row) => unlessNoted(row, () => ratio(row.wasm, row.distances + row.diagram)),
  note: ({ note, wasmNote }) => note ?? wasmNote,
};

const overDijkstra = (row) =>
  unlessNoted(row, () => ratio(row.distances + row.diagram, row.dijkstra));
const changeTime = (row) => unlessNoted(row, () => row.change && milliseconds(row.change));

/** A row per mesh and metric, with the rows of all its numbers of sites. */
function ladderRows(speed) {
  const rows = new Map();
  for (const row of speed) {
    const { mesh, faces, metric } = row;
    const key = JSON.stringify([mesh, metric]);
    if (!rows.has(key)) rows.set(key, { mesh, faces, metric, bySites: {} });
    rows.get(key).bySites[row.sites] = row;
  }
  return [...rows.values()];
}

/** A column per number of sites; none if nothing has a text there. */
function ladderColumns(speed, text) {
  const sites = [...new Set(speed.filter((row) => text(row)).map((row) => row.sites))];
  if (sites.length === 0) return undefined;
  return {
    mesh: ({ mesh }) => mesh,
    faces: ({ faces }) => faces,
    metric: ({ metric }) => metric,
    ...Object.fromEntries(
      sites.map((count) => [
        `${count} ${count === 1 ? 'site' : 'sites'}`,
        ({ bySites }) => bySites[count] && text(bySites[count]),
      ]),
    ),
  };
}

const scoreColumns = {
  case: (row) => row.case,
  mesh: ({ mesh }) => mesh,
  faces: ({ faces }) => faces,
  sites: ({ sites }) => sites,
  points: ({ points }) => points,
  metric: ({ metric }) => metric,
  mislabelled: (row) => unlessNoted(row, () => percent(row.mislabelled)),
  'mean error': (row) => unlessNoted(row, () => row.meanError.toExponential(2)),
  'largest error': (row) => unlessNoted(row, () => row.largestError.toExponential(2)),
  note: ({ note }) => note,
};

/** The exponent p of an error ~ hᵖ that falls from one value to another as h is halved `times`. */
const order = (from, to, times = 1) =>
  from > 0 && to > 0 ? (Math.log2(from / to) / times).toFixed(1) : undefined;

const detailColumns = {
  mesh: ({ mesh }) => mesh,
  faces: ({ faces }) => faces,
  sites: ({ sites }) => sites,
  metric: ({ metric }) => metric,
  ...Object.fromEntries(
    [0, 1, 2, 3, 4].map((n) => [
      `detail ${n}`,
      (row) => unlessNoted(row, () => smallPercent(row.mislabelled[n])),
    ]),
  ),
  order: (row) => unlessNoted(row, () => order(row.mislabelled[0], row.mislabelled[4], 4)),
  note: ({ note }) => note,
};

const refinementColumns = {
  faces: ({ faces }) => faces,
  sites: ({ sites }) => sites,
  metric: ({ metric }) => metric,
  mislabelled: (row) => unlessNoted(row, () => percent(row.mislabelled)),
  order: (row) =>
    unlessNoted(row, () => row.coarser && order(row.coarser.mislabelled, row.mislabelled)),
  'mean error': (row) => unlessNoted(row, () => row.meanError.toExponential(2)),
  'its order': (row) =>
    unlessNoted(row, () => row.coarser && order(row.coarser.meanError, row.meanError)),
  note: ({ note }) => note,
};

const tessellationColumns = {
  mesh: ({ mesh }) => mesh,
  faces: ({ faces }) => faces,
  sites: ({ sites }) => sites,
  method: ({ method }) => method,
  start: ({ energy }) => energy[0].toFixed(3),
  '10 iterations': ({ energy }) => energy[1].toFixed(3),
  '50 iterations': ({ energy }) => energy[2].toFixed(3),
  'one iteration': ({ diagrams }) => `${diagrams.toFixed(2)} diagrams`,
};

/** A text about a row; none if a note says why nothing was measured. */
const unlessNoted = (row, text) => (row.note ? undefined : text());

/** In Markdown, legible as it is: numbers to the right, columns that are empty left out. */
function table(columns, rows) {
  const cells = Object.entries(columns).map(([title, text]) => [title, ...rows.map(text)]);
  const shown = cells.filter(([, ...values]) => values.some((value) => value !== undefined));
  const padded = shown.map((column) => {
    const texts = column.map((value) => String(value ?? ''));
    const width = Math.max(...texts.map((text) => text.length));
    const isNumber = texts
      .slice(1)
      .some((text) => /^[\d.e+-]+( (ms|%|×|B\/face|diagrams))?$/.test(text));
    const rule = isNumber ? `${'-'.repeat(width - 1)}:` : '-'.repeat(width);
    const [title, ...values] = texts.map((text) =>
      isNumber ? text.padStart(width) : text.padEnd(width),
    );
    return [title, rule, ...values];
  });
  return padded[0].map((_, i) => `| ${padded.map((column) => column[i]).join(' | ')} |`).join('\n');
}
