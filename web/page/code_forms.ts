// SPDX-License-Identifier: MIT
//
// Code that makes the shown diagram elsewhere: a script, a page, a command.

import type { Sampling } from 'geodesic-voronoi';
import type { GeodesicVoronoiElement } from '../viewer/element.js';
import { listen } from './dom.js';

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

/** The code of a script, a page or a command that makes the shown diagram. */
export function codeOf(
  viewer: GeodesicVoronoiElement,
  file: string,
  origin: Origin,
  form: string,
): string {
  switch (form) {
    case 'element':
      return elementOf(viewer, file, origin);
    case 'command':
      return commandOf(viewer, file, origin);
    default:
      return scriptOf(viewer, file, origin);
  }
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

function scriptOf(viewer: GeodesicVoronoiElement, file: string, origin: Origin): string {
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
    edited: [
      "// From this page's menu of downloads.",
      "const sites = await (await fetch('sites.json')).json();",
    ],
  };
  return [
    "import { load } from 'geodesic-voronoi';",
    '',
    'const library = await load();',
    `const bytes = await (await fetch('${file}')).arrayBuffer();`,
    `const mesh = await library.mesh(new Uint8Array(bytes)${meshOptions});`,
    ...sites[origin],
    `const diagram = await mesh.voronoi(sites, { metric: '${metric}', detail: ${detail} });`,
  ].join('\n');
}

function elementOf(viewer: GeodesicVoronoiElement, file: string, origin: Origin): string {
  const { count, seed, sampling, metric, detail } = settingsOf(viewer);
  const name = 'geodesic-voronoi';
  const after: Record<Origin, readonly string[]> = {
    scattered: [],
    even: ["  viewer.addEventListener('diagram', () => viewer.playCvt(), { once: true });"],
    edited: [
      "  viewer.sites = await (await fetch('sites.json')).json(); // from this page's downloads",
    ],
  };
  return [
    `<${name} src="${file}" sites="${count}" seed="${seed}"`,
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

function commandOf(viewer: GeodesicVoronoiElement, file: string, origin: Origin): string {
  const { count, seed, sampling, metric, detail, iterations } = settingsOf(viewer);
  const { build, attributes, flags } = unusual(viewer);
  const sites =
    origin === 'edited'
      ? `--sites sites.json${flags(build)}`
      : `--sites ${count} --seed ${seed} --sampling ${sampling}${flags(attributes)}`;
  const isEven = origin === 'even';
  return [
    `geodesic-voronoi ${isEven ? 'cvt' : 'diagram'} ${file} \\`,
    `  ${sites} \\`,
    isEven
      ? `  --metric ${metric} --iterations ${iterations} -o sites.json`
      : `  --metric ${metric} --detail ${detail} -o diagram.json`,
  ].join('\n');
}
