// SPDX-License-Identifier: MIT
//
// Code that makes the shown diagram elsewhere: a script, a page, a command.

import type { Sampling } from 'geodesic-voronoi';
import type { GeodesicVoronoiElement } from '../viewer/element.js';
import { listen } from './dom.js';
import { downloadName } from './downloads.js';

/** How the present sites were made: by scattering, by a tessellation of those, or by hand. */
type Origin = 'scattered' | 'even' | 'edited';

/**
 * Notes where tessellations begin, and how far they get; returns what tells how the present sites
 * were made. Code repeats a tessellation only if it began with scattered sites, has a uniform
 * density, and has come as far as the code goes.
 */
export function watchOrigin(viewer: GeodesicVoronoiElement): () => Promise<Origin> {
  let beganScattered = Promise.resolve(false);
  let iterations = 0;
  listen(viewer, 'cvt-iteration', ({ iteration }) => {
    iterations = iteration;
    if (iteration === 0) beganScattered = isScattered(viewer);
  });
  return async () => {
    if (viewer.cvtStatus === 'idle') return (await isScattered(viewer)) ? 'scattered' : 'edited';
    const isRepeatable =
      iterations === Number(settingsOf(viewer).iterations) && viewer.density === undefined;
    return isRepeatable && (await beganScattered) ? 'even' : 'edited';
  };
}

async function isScattered(viewer: GeodesicVoronoiElement): Promise<boolean> {
  const shown = String(viewer.sites.bary);
  const { count, seed, sampling, perComponent } = settingsOf(viewer);
  const scattered = await viewer.mesh
    ?.sampleSites(Number(count), {
      seed: Number(seed),
      sampling: sampling as Sampling,
      perComponent: Number(perComponent),
    })
    // Fails if there are fewer sites than that takes.
    .catch(() => undefined);
  return String(scattered?.bary) === shown;
}

/** The model that code opens. */
export interface CodeModel {
  /** The name of its file. */
  name: string;
  /** Where it can be fetched from, if it is one of the page's own. */
  address?: string | undefined;
}

/**
 * The code of a script, a page or a command that makes the shown diagram. It runs as it is, next to
 * the files that its first line names.
 */
export function codeOf(
  viewer: GeodesicVoronoiElement,
  model: CodeModel,
  origin: Origin,
  form: string,
): string {
  const sitesFile = downloadName(model.name, 'sites', 'json');
  const needs = [
    ...(model.address ? [] : [model.name]),
    ...(origin === 'edited' ? [`${sitesFile} (Download, Sites)`] : []),
  ];
  const needed = needs.length > 0 ? `Needs in its folder: ${needs.join(' and ')}` : undefined;
  switch (form) {
    case 'element':
      return joined(needed && `<!-- ${needed} -->`, elementOf(viewer, model, origin, sitesFile));
    case 'command':
      return joined(
        needed && `# ${needed}`,
        model.address && `curl -LO '${model.address}'`,
        commandOf(viewer, model, origin, sitesFile),
      );
    default:
      return joined(needed && `// ${needed}`, scriptOf(viewer, model, origin, sitesFile));
  }
}

function joined(...lines: (string | undefined)[]): string {
  return lines.filter(Boolean).join('\n');
}

/** The settings, from the attributes of the page's viewer. */
function settingsOf(viewer: GeodesicVoronoiElement) {
  const value = (name: string, otherwise: string) => viewer.getAttribute(name) ?? otherwise;
  return {
    count: value('sites', '0'),
    seed: value('seed', '1'),
    sampling: value('sampling', 'random'),
    perComponent: value('per-component', '0'),
    weld: value('weld', '0'),
    orientation: value('orientation', 'unify'),
    minComponent: value('min-component', '0'),
    metric: value('metric', 'exact'),
    detail: value('detail', '0'),
    iterations: value('cvt-iterations', '30'),
  };
}

/** The settings that differ from the defaults, by their names in each form of code. */
function unusual(viewer: GeodesicVoronoiElement) {
  const { perComponent, weld, orientation, minComponent } = settingsOf(viewer);
  const isGiven = ([, value]: string[]) => value !== '0' && value !== 'unify';
  const build = [
    ['weld', weld],
    ['orientation', orientation],
    ['min-component', minComponent],
  ].filter(isGiven);
  const attributes = [...build, ['per-component', perComponent]].filter(isGiven);
  const shown = (value: string) => (Number.isNaN(Number(value)) ? `'${value}'` : value);
  const camel = (name: string) => name.replace(/-(.)/, (_, letter) => letter.toUpperCase());
  return {
    html: attributes.map(([name, value]) => ` ${name}="${value}"`).join(''),
    flags: (names: readonly string[][]) =>
      names.map(([name, value]) => ` --${name} ${value}`).join(''),
    meshOptions:
      build.length > 0
        ? `, { ${build.map(([name, value]) => `${camel(name)}: ${shown(value)}`).join(', ')} }`
        : '',
    siteOptions: perComponent === '0' ? '' : `, perComponent: ${perComponent}`,
    build,
    attributes,
  };
}

function scriptOf(
  viewer: GeodesicVoronoiElement,
  { name, address }: CodeModel,
  origin: Origin,
  sitesFile: string,
): string {
  const { count, seed, sampling, metric, detail, iterations } = settingsOf(viewer);
  const { meshOptions, siteOptions } = unusual(viewer);
  const scattered = `await mesh.sampleSites(${count}, { seed: ${seed}, sampling: '${sampling}'${siteOptions} })`;
  const sites: Record<Origin, readonly string[]> = {
    scattered: [`const sites = ${scattered};`],
    even: [
      `let sites = ${scattered};`,
      `const settings = { iterations: ${iterations}, metric: '${metric}' };`,
      'for await (const state of mesh.cvt(sites, settings)) sites = state.sites;',
    ],
    edited: [`const sites = await (await fetch('${sitesFile}')).json();`],
  };
  return [
    "import { load } from 'geodesic-voronoi';",
    '',
    'const library = await load();',
    `const bytes = await (await fetch('${address ?? name}')).arrayBuffer();`,
    `const mesh = await library.mesh(new Uint8Array(bytes)${meshOptions});`,
    ...sites[origin],
    `const diagram = await mesh.voronoi(sites, { metric: '${metric}', detail: ${detail} });`,
  ].join('\n');
}

function elementOf(
  viewer: GeodesicVoronoiElement,
  model: CodeModel,
  origin: Origin,
  sitesFile: string,
): string {
  const { count, seed, sampling, metric, detail } = settingsOf(viewer);
  const name = 'geodesic-voronoi';
  const after: Record<Origin, readonly string[]> = {
    scattered: [],
    even: ["  viewer.addEventListener('diagram', () => viewer.playCvt(), { once: true });"],
    edited: [`  viewer.sites = await (await fetch('${sitesFile}')).json();`],
  };
  return [
    `<${name} src="${model.address ?? model.name}" sites="${count}" seed="${seed}"`,
    `  sampling="${sampling}" metric="${metric}" detail="${detail}"${unusual(viewer).html}></${name}>`,
    '<script type="module">',
    "  import 'geodesic-voronoi/element';",
    ...(origin === 'scattered' ? [] : [`  const viewer = document.querySelector('${name}');`]),
    ...(origin === 'edited'
      ? [
          "  await new Promise((resolve) => viewer.addEventListener('load', resolve, { once: true }));",
        ]
      : []),
    ...after[origin],
    '</script>',
  ].join('\n');
}

function commandOf(
  viewer: GeodesicVoronoiElement,
  { name }: CodeModel,
  origin: Origin,
  sitesFile: string,
): string {
  const { count, seed, sampling, metric, detail, iterations } = settingsOf(viewer);
  const { build, attributes, flags } = unusual(viewer);
  const sites =
    origin === 'edited'
      ? `--sites ${quoted(sitesFile)}${flags(build)}`
      : `--sites ${count} --seed ${seed} --sampling ${sampling}${flags(attributes)}`;
  const isEven = origin === 'even';
  return [
    `geodesic-voronoi ${isEven ? 'cvt' : 'diagram'} ${quoted(name)} \\`,
    `  ${sites} \\`,
    isEven
      ? `  --metric ${metric} --iterations ${iterations} -o sites.json`
      : `  --metric ${metric} --detail ${detail} -o diagram.json`,
  ].join('\n');
}

/** A name as one word of a shell. */
function quoted(name: string): string {
  return /^[\w.-]+$/.test(name) ? name : `'${name.replace(/'/g, "'\\''")}'`;
}
