// SPDX-License-Identifier: MIT
import type { Sampling } from 'geodesic-voronoi';
import type { GeodesicVoronoiElement } from '../viewer/element.js';

/** How the sites there are came about: by scattering, by a tessellation of those, or by hand. */
type Origin = 'scattered' | 'even' | 'edited';

export async function originOf(viewer: GeodesicVoronoiElement): Promise<Origin> {
  if (viewer.cvtStatus !== 'idle') return 'even';
  const { count, seed, sampling } = settingsOf(viewer);
  const scattered = await viewer.mesh?.sampleSites(Number(count), {
    seed: Number(seed),
    sampling: sampling as Sampling,
  });
  const isSame = String(scattered?.bary) === String(viewer.sites.bary);
  return isSame ? 'scattered' : 'edited';
}

/** What makes the diagram that is shown in another place: a script, a page or the command. */
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

/** As the page's attributes have them. */
function settingsOf(viewer: GeodesicVoronoiElement) {
  const value = (name: string, otherwise: string) => viewer.getAttribute(name) ?? otherwise;
  return {
    count: value('sites', '0'),
    seed: value('seed', '1'),
    sampling: value('sampling', 'random'),
    metric: value('metric', 'exact'),
    detail: value('detail', '0'),
    iterations: value('cvt-iterations', '30'),
  };
}

function scriptOf(viewer: GeodesicVoronoiElement, file: string, origin: Origin): string {
  const { count, seed, sampling, metric, detail, iterations } = settingsOf(viewer);
  const scattered = `await mesh.sampleSites(${count}, { seed: ${seed}, sampling: '${sampling}' })`;
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
    'const mesh = await library.mesh(new Uint8Array(bytes));',
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
    `  sampling="${sampling}" metric="${metric}" detail="${detail}"></${name}>`,
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
  const sites =
    origin === 'edited'
      ? '--sites sites.json'
      : `--sites ${count} --seed ${seed} --sampling ${sampling}`;
  const isEven = origin === 'even';
  return [
    `geodesic-voronoi ${isEven ? 'cvt' : 'diagram'} ${file} \\`,
    `  ${sites} \\`,
    isEven
      ? `  --metric ${metric} --iterations ${iterations} -o sites.json`
      : `  --metric ${metric} --detail ${detail} -o diagram.json`,
  ].join('\n');
}
