// SPDX-License-Identifier: MIT
//
// One run of the benchmark as the tables and plots of the documents. A document marks where a table
// goes by two comments with its name; what is between them is replaced.

import { plot } from './plot.mjs';

const colours = {
  exact: '#2b6a99',
  dgpc: '#c46a10',
  dijkstra: '#7b8794',
  peers: ['#3c8d40', '#8d4fa8', '#b3261e'],
};

/** The document with its tables, and only those it names. */
export function withTables(text, measured, peers) {
  return text.replace(
    /(<!-- bench: ([\w-]+) -->\n)[\s\S]*?(<!-- end -->)/g,
    (_, begin, name, end) => {
      if (!tables[name]) throw new Error(`there is no table '${name}'`);
      return `${begin}\n${tables[name](measured, peers)}\n\n${end}`;
    },
  );
}

/** By file name, the plots. */
export function plots(measured, peers) {
  return {
    'speed-by-sites.svg': `${plotBySites(measured, peers)}`,
    'speed-by-faces.svg': `${plotByFaces(measured)}`,
    'error-by-detail.svg': `${plotByDetail(measured)}`,
  };
}

// --- Tables -----------------------------------------------------------------------------------------

const tables = {
  accuracy({ accuracy }) {
    const rows = accuracy.flatMap(({ mesh, faces, sites, metrics }) =>
      Object.entries(metrics).map(([metric, score]) => [
        mesh,
        count(faces),
        sites,
        metric,
        percent(score.mislabelled),
        power(score.meanError),
        power(score.largestError),
      ]),
    );
    const titles = [
      'mesh',
      'faces',
      'sites',
      'metric',
      'mislabelled',
      'mean error',
      'largest error',
    ];
    return table(titles, rows, 4);
  },

  'accuracy-summary'({ accuracy, cases }, peers) {
    // Cases with known answers are those that the others were measured on.
    const known = cases.length > 0 ? cases : accuracy;
    const own = ['exact', 'dgpc'].map((metric) => {
      const scores = known.map(({ metrics }) => metrics[metric].mislabelled);
      const errors = known.map(({ metrics }) => metrics[metric].meanError);
      return [
        `\`${metric}\``,
        percent(mean(scores)),
        percent(Math.max(...scores)),
        power(mean(errors)),
      ];
    });
    const title = cases.length > 0 ? `${cases.length} cases of scanned meshes` : 'small meshes';
    const others = peers.mislabelled.map(({ name, mean, worst }) => [name, mean, worst, '']);
    return table(
      [title, 'points given to the wrong site', 'in the worst case', 'mean error'],
      [...own, ...others],
      1,
    );
  },

  'speed-by-sites'({ speed }, peers) {
    const sites = [...new Set(speed.map((entry) => entry.sites))];
    const row = (name, of) => [name, ...sites.map((n) => of(n) ?? '')];
    const own = ['exact', 'dgpc'].map((metric) =>
      row(`\`${metric}\``, (n) => times(overDijkstra(speed, metric, n))),
    );
    const move = row('one site moved, `exact`', (n) => fraction(moveShare(speed, n)));
    const others = peers.speed.map(({ name, overDijkstra }) =>
      row(name, (n) => overDijkstra[n]?.join(' to ')),
    );
    return table(['sites', ...sites.map(count)], [...own, ...others, move], 1);
  },

  'speed-by-faces'({ size }) {
    const rows = size.map(({ faces, dijkstra, metrics: { exact, dgpc } }) => [
      count(faces),
      seconds(dijkstra),
      seconds(exact.distances + exact.diagram),
      seconds(dgpc.distances + dgpc.diagram),
      exact.change ? seconds(exact.change) : '',
      Math.round(exact.bytesPerFace),
      Math.round(dgpc.bytesPerFace),
    ]);
    const titles = [
      'faces',
      'Dijkstra',
      '`exact`',
      '`dgpc`',
      'one site moved',
      'bytes per face, `exact`',
      '`dgpc`',
    ];
    return table(titles, rows, 0);
  },

  'speed-by-mesh'({ speed }) {
    const rows = speed.flatMap(({ mesh, faces, sites, dijkstra, metrics }) =>
      Object.entries(metrics).map(([metric, { distances, diagram, wasm }]) => [
        mesh,
        count(faces),
        count(sites),
        metric,
        seconds(distances),
        seconds(diagram),
        times((distances + diagram) / dijkstra),
        wasm ? times(wasm / (distances + diagram)) : '',
      ]),
    );
    const titles = [
      'mesh',
      'faces',
      'sites',
      'metric',
      'distances',
      'diagram',
      'over Dijkstra',
      'WebAssembly over native',
    ];
    return table(titles, rows, 4);
  },

  detail({ byDetail }) {
    const rows = byDetail.flatMap(({ mesh, faces, sites, metrics }) =>
      Object.entries(metrics).map(([metric, { mislabelled }]) => [
        mesh,
        count(faces),
        sites,
        metric,
        ...mislabelled.map((share) => percent(share, 4)),
      ]),
    );
    const levels = [0, 1, 2, 3, 4].map((n) => `detail ${n}`);
    return table(['mesh', 'faces', 'sites', 'metric', ...levels], rows, 4);
  },

  refinement({ byRefinement }) {
    const rows = byRefinement.map(({ faces, metrics: { exact, dgpc } }) => [
      count(faces),
      percent(exact.mislabelled),
      power(exact.meanError),
      percent(dgpc.mislabelled),
      power(dgpc.meanError),
    ]);
    return table(
      ['faces', '`exact`: mislabelled', 'mean error', '`dgpc`: mislabelled', 'mean error'],
      rows,
      0,
    );
  },

  cvt({ tessellations }, peers) {
    const sorted = [...tessellations].sort((a, b) => a.sites - b.sites);
    const rows = sorted.map(({ mesh, sites, methods: { lbfgs, lloyd } }) => {
      const others = peers.cvt.energy[mesh] ?? [];
      const energies = [
        lbfgs.energy[0],
        lbfgs.energy[1],
        lbfgs.energy[2],
        lloyd.energy[2],
        others[1],
        others[2],
      ];
      return [
        mesh.replace(`_${sites}`, ''),
        sites,
        ...energies.map((energy) => energy?.toFixed(3) ?? ''),
      ];
    });
    const { name } = peers.cvt;
    const titles = [
      'mesh',
      'sites',
      'start',
      '10 iterations',
      '50',
      'Lloyd, 50',
      `${name}, 10`,
      `${name}, 50`,
    ];
    return table(titles, rows, 1);
  },

  peers: (_, peers) => peers.speed.map(({ name, mesh }) => `- ${name}: ${mesh}.`).join('\n'),
};

// --- Plots ------------------------------------------------------------------------------------------

function plotBySites({ speed }, peers) {
  const sites = [...new Set(speed.map((entry) => entry.sites))];
  const line = (metric) => sites.map((n) => [n, overDijkstra(speed, metric, n)]);
  const series = [
    { name: 'exact, with the diagram', points: line('exact'), colour: colours.exact },
    { name: 'dgpc, with the diagram', points: line('dgpc'), colour: colours.dgpc },
    ...peers.speed.map(({ name, overDijkstra }, i) => ({
      name: name.split(',')[0],
      points: Object.entries(overDijkstra).map(([n, range]) => [Number(n), range]),
      colour: colours.peers[i],
      isMarks: true,
    })),
  ];
  return plot({
    title: 'Time over that of Dijkstra’s algorithm: lower is faster',
    x: { name: 'sites', range: [0.8, Math.max(...sites) * 1.3], ticks: sites, show: count },
    y: { range: [2, 250], ticks: [2, 5, 10, 20, 50, 100, 200], show: (n) => `${n} ×` },
    series,
  });
}

function plotByFaces({ size }) {
  const line = (of) => size.map((entry) => [entry.faces, of(entry)]);
  const both = ({ distances, diagram }) => distances + diagram;
  const series = [
    { name: 'exact', points: line(({ metrics }) => both(metrics.exact)), colour: colours.exact },
    { name: 'dgpc', points: line(({ metrics }) => both(metrics.dgpc)), colour: colours.dgpc },
    {
      name: 'Dijkstra’s algorithm',
      points: line(({ dijkstra }) => dijkstra),
      colour: colours.dijkstra,
    },
    {
      name: 'one site moved (exact)',
      points: line(({ metrics }) => metrics.exact.change),
      colour: colours.peers[1],
    },
  ];
  const faces = size.map((entry) => entry.faces);
  return plot({
    title: 'Time of distances and diagram of 300 sites',
    x: { name: 'faces', range: [faces[0] / 1.2, faces.at(-1) * 1.2], ticks: faces, show: short },
    y: { range: decades(series), ticks: ticksOf(decades(series)), show: seconds },
    series,
  });
}

function plotByDetail({ byDetail }) {
  const chosen = byDetail.filter(({ metrics }) =>
    metrics.exact.mislabelled.every((share) => share > 0),
  );
  const palette = [colours.exact, colours.dgpc, ...colours.peers, colours.dijkstra];
  const series = chosen.map(({ mesh, metrics }, i) => ({
    name: mesh,
    points: metrics.exact.mislabelled.map((share, n) => [2 ** n, share]),
    colour: palette[i],
  }));
  const range = decades(series);
  return plot({
    title: 'Area given to another site than the nearest one, exact distances',
    x: {
      name: 'parts of a side: 2 to the detail',
      range: [0.9, 18],
      ticks: [1, 2, 4, 8, 16],
      show: String,
    },
    y: {
      range,
      ticks: ticksOf(range),
      show: (share) => `${Number((100 * share).toPrecision(1))} %`,
    },
    series,
  });
}

// --- Figures of a run -------------------------------------------------------------------------------

const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;

/** The geometric mean over the meshes of at least 10,000 faces. */
function overMeshes(speed, sites, of) {
  const values = speed
    .filter((entry) => entry.sites === sites && entry.faces >= 10_000)
    .map(of)
    .filter((value) => value > 0);
  return values.length > 0 ? Math.exp(mean(values.map(Math.log))) : undefined;
}

const overDijkstra = (speed, metric, sites) =>
  overMeshes(
    speed,
    sites,
    ({ dijkstra, metrics: { [metric]: entry } }) => (entry.distances + entry.diagram) / dijkstra,
  );

const moveShare = (speed, sites) =>
  overMeshes(
    speed,
    sites,
    ({ metrics: { exact } }) => exact.change / (exact.distances + exact.diagram),
  );

function decades(series) {
  const values = series.flatMap(({ points }) => points.map(([, y]) => y));
  return [
    10 ** Math.floor(Math.log10(Math.min(...values))),
    10 ** Math.ceil(Math.log10(Math.max(...values))),
  ];
}

function ticksOf([low, high]) {
  const ticks = [];
  for (let tick = low; tick <= high * 1.001; tick *= 10) ticks.push(Number(tick.toPrecision(1)));
  return ticks;
}

// --- Texts ------------------------------------------------------------------------------------------

const count = (n) => String(n).replace(/\B(?=(\d{3})+$)/g, ',');
const short = (n) =>
  n >= 1e6 ? `${(n / 1e6).toFixed(1)}M` : n >= 1000 ? `${Math.round(n / 1000)}k` : String(n);
const percent = (share, digits = 3) => `${(100 * share).toFixed(digits)} %`;
const power = (x) =>
  x.toExponential(1).replace(/e([+-])(\d+)/, (_, sign, n) => `e${sign === '-' ? '-' : ''}${n}`);
const times = (x) => (x === undefined ? undefined : `${x.toFixed(1)} ×`);
const fraction = (x) =>
  x === undefined ? undefined : x > 0.6 ? 'all anew' : `1/${Math.round(1 / x)}`;
const seconds = (s) =>
  s >= 1
    ? `${Number(s.toPrecision(2))} s`
    : s >= 1e-3
      ? `${Number((1e3 * s).toPrecision(2))} ms`
      : `${Number((1e6 * s).toPrecision(2))} µs`;

/** Columns from `firstNumber` on are aligned to the right. */
function table(titles, rows, firstNumber) {
  const line = (cells) => `| ${cells.join(' | ')} |`;
  const rule = titles.map((_, i) => (i >= firstNumber ? '---:' : '---'));
  return [titles, rule, ...rows].map(line).join('\n');
}
