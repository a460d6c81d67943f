// SPDX-License-Identifier: MIT
//
// What was measured, as tables for people.

export function report({ sites, runs, detail, speed, accuracy, accuracyNote, cases, ...more }) {
  const sections = [
    [
      `Speed: ${sites} sites, detail ${detail}; CPU time of the fastest of ${runs}`,
      speedColumns,
      speed,
    ],
    ['Accuracy: against CGAL', scoreColumns, accuracy],
    ['Accuracy: against the cases given', scoreColumns, [...cases, ...(more.caseSummaries ?? [])]],
  ];
  const texts = sections
    .filter(([, , meshes]) => meshes.length > 0)
    .map(([title, columns, meshes]) => `${title}\n\n${table(columns, meshes.flatMap(perMetric))}`);
  if (accuracyNote) texts.push(`Accuracy: ${accuracyNote}`);
  return texts.join('\n\n');
}

/** A row per mesh and metric. */
function perMetric({ metrics, ...mesh }) {
  return Object.entries(metrics).map(([metric, values]) => ({ ...mesh, metric, ...values }));
}

/** The mean and the worst of all cases, for each metric that has scores. */
export function summaries(cases) {
  const summary = (name, of) => {
    const metrics = {};
    for (const metric of Object.keys(cases[0].metrics)) {
      const scores = cases.map(({ metrics }) => metrics[metric]);
      if (scores.some(({ note }) => note)) continue;
      metrics[metric] = {
        mislabelled: of(scores.map(({ mislabelled }) => mislabelled)),
        meanError: of(scores.map(({ meanError }) => meanError)),
      };
    }
    return { name, metrics };
  };
  return [
    summary('mean', (values) => values.reduce((sum, value) => sum + value) / values.length),
    summary('worst', (values) => Math.max(...values)),
  ];
}

const milliseconds = (seconds) => `${(1000 * seconds).toFixed(1)} ms`;
const ratio = (a, b) => (a === undefined ? undefined : `${(a / b).toFixed(2)} ×`);
const percent = (share) => `${(100 * share).toFixed(3)} %`;

/** Titles, with what a row has there; undefined where it has nothing. */
const speedColumns = {
  mesh: ({ name }) => name,
  faces: ({ faces }) => faces,
  Dijkstra: ({ dijkstra }) => milliseconds(dijkstra),
  metric: ({ metric }) => metric,
  distances: (row) => measured(row, () => milliseconds(row.distances)),
  '': (row) => measured(row, () => ratio(row.distances, row.dijkstra)),
  diagram: (row) => measured(row, () => milliseconds(row.diagram)),
  ' ': (row) => measured(row, () => ratio(row.diagram, row.dijkstra)),
  both: (row) => measured(row, () => ratio(row.distances + row.diagram, row.dijkstra)),
  'partition/both': (row) =>
    measured(row, () => ratio(row.partition, row.distances + row.diagram)),
  'wasm/native': (row) => measured(row, () => ratio(row.wasm, row.distances + row.diagram)),
  note: ({ note, wasmNote }) => note ?? wasmNote,
};

const scoreColumns = {
  mesh: ({ name }) => name,
  faces: ({ faces }) => faces,
  sites: ({ sites }) => sites,
  points: ({ points }) => points,
  metric: ({ metric }) => metric,
  mislabelled: (row) => measured(row, () => percent(row.mislabelled)),
  'mean error': (row) => measured(row, () => row.meanError.toExponential(2)),
  note: ({ note }) => note,
};

const measured = (row, text) => (row.note ? undefined : text());

/** Numbers to the right, everything else to the left; columns that are empty are left out. */
function table(columns, rows) {
  const cells = Object.entries(columns).map(([title, text]) => [title, ...rows.map(text)]);
  const shown = cells.filter(([, ...values]) => values.some((value) => value !== undefined));
  const padded = shown.map((column) => {
    const texts = column.map((value) => String(value ?? ''));
    const width = Math.max(...texts.map((text) => text.length));
    const isNumber = texts.slice(1).some((text) => /^[\d.e+-]+( (ms|%|×))?$/.test(text));
    return texts.map((text) => (isNumber ? text.padStart(width) : text.padEnd(width)));
  });
  const lines = padded[0].map((_, i) =>
    padded
      .map((column) => column[i])
      .join('  ')
      .trimEnd(),
  );
  return lines.join('\n');
}
