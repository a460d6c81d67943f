// SPDX-License-Identifier: MIT
//
// Code that makes the shown diagram elsewhere: a script, a page, a command.

import type { Sampling, SurfacePoints } from 'geodesic-voronoi';
import type { GeodesicVoronoiElement } from '../viewer/element.js';
import { listen } from './dom.js';
import { downloadName } from './downloads.js';
import { isSame } from './same_sites.js';

/** How the present sites were made: by sampling, by a tessellation of those, or by hand. */
type Origin = 'sampled' | 'even' | 'edited';

/**
 * Notes with which sites and settings tessellations begin, and how far they get; returns what tells
 * how the present sites were made. Code repeats a tessellation only if it began with sampled sites,
 * has a uniform density and the present settings, and has come as far as the code goes.
 */
export function watchOrigin(viewer: GeodesicVoronoiElement): () => Promise<Origin> {
  let first = viewer.sites;
  let iterations = 0;
  let settings = '';
  const present = () => {
    const { method, metric } = settingsOf(viewer);
    return `${method} ${metric}`;
  };
  listen(viewer, 'cvt-iteration', ({ iteration }) => {
    iterations = iteration;
    if (iteration > 0) return;
    first = viewer.sites;
    settings = present();
  });
  return async () => {
    if (viewer.cvtStatus === 'idle')
      return (await areSampled(viewer, viewer.sites)) ? 'sampled' : 'edited';
    const isRepeatable =
      iterations === Number(settingsOf(viewer).iterations) &&
      settings === present() &&
      viewer.density === undefined;
    return isRepeatable && (await areSampled(viewer, first)) ? 'even' : 'edited';
  };
}

async function areSampled(viewer: GeodesicVoronoiElement, sites: SurfacePoints): Promise<boolean> {
  const { count, seed, sampling, perComponent } = settingsOf(viewer);
  const sampled = await viewer.mesh
    ?.sampleSites(Number(count), {
      seed: Number(seed),
      sampling: sampling as Sampling,
      perComponent: Number(perComponent),
    })
    // Fails if there are fewer sites than that takes.
    .catch(() => undefined);
  return sampled !== undefined && isSame(sampled, sites);
}

/** The model that code opens. */
interface CodeModel {
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
      // A name with an arrow would end the comment.
      return joined(
        needed && `<!-- ${needed.replace(/>/g, '&gt;')} -->`,
        elementOf(viewer, model, origin, sitesFile),
      );
    case 'command':
      return joined(
        needed && `# ${needed}`,
        model.address && `curl -LO '${addressOf(model)}'`,
        commandOf(viewer, model, origin, sitesFile),
      );
    default:
      return joined(needed && `// ${needed}`, scriptOf(viewer, model, origin, sitesFile));
  }
}

function joined(...lines: (string | undefined)[]): string {
  return lines.filter(Boolean).join('\n');
}

/** The values of the library, or of the element, where code does not give them. */
const defaultMethod = 'lbfgs';
const defaultIterations = '50';

/** The settings, from the attributes of the page's viewer. */
function settingsOf(viewer: GeodesicVoronoiElement) {
  const value = (name: string, otherwise: string) => viewer.getAttribute(name) ?? otherwise;
  return {
    count: value('sites', '0'),
    seed: value('seed', '1'),
    sampling: value('sampling', 'random'),
    perComponent: value('per-component', '0'),
    maxEdge: value('max-edge', '0'),
    weld: value('weld', '0'),
    orientation: value('orientation', 'unify'),
    minComponent: value('min-component', '0'),
    metric: value('metric', 'exact'),
    detail: value('detail', '0'),
    method: value('cvt-method', defaultMethod),
    iterations: value('cvt-iterations', defaultIterations),
  };
}

/** The settings that differ from the defaults, by their names in each form of code. */
function changed(viewer: GeodesicVoronoiElement) {
  const { perComponent, maxEdge, weld, orientation, minComponent } = settingsOf(viewer);
  const isGiven = ([, value]: string[]) => value !== '0' && value !== 'unify';
  const build = [
    ['max-edge', maxEdge],
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

/** How the model is looked at, by the attributes of the element. */
function viewOf(viewer: GeodesicVoronoiElement): [name: string, value: string][] {
  const given = ['up', 'layers', 'exploded'].map((name) => [name, viewer.getAttribute(name)]);
  return [...given, ['camera-orbit', viewer.cameraOrbit]].filter(
    (attribute): attribute is [string, string] => attribute[1] !== null,
  );
}

/** An address that code of every form may hold between quotes, whatever the name of the file is. */
function addressOf({ name, address = encodeURIComponent(name) }: CodeModel): string {
  return address.replace(/['&]/g, (c) => `%${c.charCodeAt(0).toString(16)}`);
}

function scriptOf(
  viewer: GeodesicVoronoiElement,
  model: CodeModel,
  origin: Origin,
  sitesFile: string,
): string {
  const { count, seed, sampling, metric, detail, method, iterations } = settingsOf(viewer);
  const { meshOptions, siteOptions } = changed(viewer);
  const ofMethod = method === defaultMethod ? '' : `, method: '${method}'`;
  const sampled = `await mesh.sampleSites(${count}, { seed: ${seed}, sampling: '${sampling}'${siteOptions} })`;
  const sites: Record<Origin, readonly string[]> = {
    sampled: [`const sites = ${sampled};`],
    even: [
      `let sites = ${sampled};`,
      `const settings = { iterations: ${iterations}, metric: '${metric}'${ofMethod} };`,
      'for await (const state of mesh.cvt(sites, settings)) sites = state.sites;',
    ],
    edited: [`const sites = await (await fetch('${addressOf({ name: sitesFile })}')).json();`],
  };
  return [
    "import { load } from 'geodesic-voronoi';",
    '',
    'const library = await load();',
    `const bytes = await (await fetch('${addressOf(model)}')).arrayBuffer();`,
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
  const { count, seed, sampling, metric, detail, method, iterations } = settingsOf(viewer);
  const name = 'geodesic-voronoi';
  const ofCvt =
    (iterations === defaultIterations ? '' : ` cvt-iterations="${iterations}"`) +
    (method === defaultMethod ? '' : ` cvt-method="${method}"`);
  const { html } = changed(viewer);
  const view = viewOf(viewer).map(([name, value]) => ` ${name}="${value}"`);
  const after: Record<Origin, readonly string[]> = {
    sampled: [],
    even: ["  viewer.addEventListener('diagram', () => viewer.playCvt(), { once: true });"],
    edited: [`  viewer.sites = await (await fetch('${addressOf({ name: sitesFile })}')).json();`],
  };
  return [
    `<${name} src="${addressOf(model)}" sites="${count}" seed="${seed}"`,
    `  sampling="${sampling}" metric="${metric}" detail="${detail}"${html}${origin === 'even' ? ofCvt : ''}`,
    ` ${view.join('')}></${name}>`,
    '<script type="module">',
    "  import 'geodesic-voronoi/element';",
    ...(origin === 'sampled' ? [] : [`  const viewer = document.querySelector('${name}');`]),
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
  const { count, seed, sampling, metric, detail, method, iterations } = settingsOf(viewer);
  const ofMethod = method === defaultMethod ? '' : ` --method ${method}`;
  const { build, attributes, flags } = changed(viewer);
  const sites =
    origin === 'edited'
      ? `--sites ${quoted(sitesFile)}${flags(build)}`
      : `--sites ${count} --seed ${seed} --sampling ${sampling}${flags(attributes)}`;
  const isEven = origin === 'even';
  return [
    `geodesic-voronoi ${isEven ? 'cvt' : 'diagram'} ${quoted(name)} \\`,
    `  ${sites} \\`,
    isEven
      ? `  --metric ${metric} --iterations ${iterations}${ofMethod} -o sites.json`
      : `  --metric ${metric} --detail ${detail} -o diagram.json`,
  ].join('\n');
}

/** A name as one word of a shell. */
function quoted(name: string): string {
  return /^[\w.-]+$/.test(name) ? name : `'${name.replace(/'/g, "'\\''")}'`;
}
