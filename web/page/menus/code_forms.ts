// SPDX-License-Identifier: MIT
//
// Code that makes the shown diagram elsewhere: a script, a page, a command.

import type { Sampling, SurfacePoints } from 'geodesic-voronoi';
import {
  attributeDefaults,
  attributeOf,
  buildAttributes,
} from '../../viewer/attributes/attribute_defaults.js';
import type { GeodesicVoronoiElement } from '../../viewer/element.js';
import { listen } from '../base/dom.js';
import { downloadName } from './download_rows.js';
import { isSame } from '../base/same_sites.js';

/** How the present sites were made: by sampling, by a tessellation of those, or by hand. */
export type Origin = 'sampled' | 'even' | 'edited';

/**
 * Notes with which sites and settings tessellations begin, and how far they get; returns what tells
 * how the present sites were made. Code repeats a tessellation only if it began with sampled sites,
 * has a uniform density and the present settings, and has come as far as the code goes.
 */
export function watchOrigin(
  viewer: GeodesicVoronoiElement,
): (signal?: AbortSignal) => Promise<Origin> {
  let first = viewer.sites;
  let iterations = 0;
  let settings = '';
  const present = () => `${attributeOf(viewer, 'cvt-method')} ${attributeOf(viewer, 'metric')}`;
  listen(viewer, 'cvt-iteration', ({ iteration }) => {
    iterations = iteration;
    if (iteration > 0) return;
    first = viewer.sites;
    settings = present();
  });
  return async (signal) => {
    if (viewer.cvtStatus === 'idle')
      return (await areSampled(viewer, viewer.sites, signal)) ? 'sampled' : 'edited';
    const isRepeatable =
      iterations === Number(attributeOf(viewer, 'cvt-iterations')) &&
      settings === present() &&
      viewer.density === undefined;
    return isRepeatable && (await areSampled(viewer, first, signal)) ? 'even' : 'edited';
  };
}

/** Whether sampling them once more, which may take long, gives the same sites. */
async function areSampled(
  viewer: GeodesicVoronoiElement,
  sites: SurfacePoints,
  signal: AbortSignal | undefined,
): Promise<boolean> {
  const number = (name: string) => Number(attributeOf(viewer, name));
  const sampled = await viewer.mesh
    ?.sampleSites(number('sites'), {
      seed: number('seed'),
      sampling: attributeOf(viewer, 'sampling') as Sampling,
      perComponent: number('per-component'),
      signal,
    })
    // Fails if there are fewer sites than that takes, and if nobody wants to know it any more.
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

/** What code is made of. */
interface Recipe {
  viewer: GeodesicVoronoiElement;
  model: CodeModel;
  origin: Origin;
  /** The name of the file that sites are downloaded to. */
  sitesFile: string;
}

/**
 * The code of a script, a page or a command that makes the shown diagram. It runs as it is, next to
 * the files that it names at its beginning.
 */
export function codeOf(
  viewer: GeodesicVoronoiElement,
  model: CodeModel,
  origin: Origin,
  form: string,
): string {
  const sitesFile = downloadName(model.name, 'sites', 'json');
  const recipe = { viewer, model, origin, sitesFile };
  const needs = [
    ...(model.address ? [] : [model.name]),
    ...(origin === 'edited' ? [`${sitesFile} (Download, Sites)`] : []),
  ];
  const needed = needs.length > 0 ? `Needs in its folder: ${needs.join(' and ')}` : undefined;
  switch (form) {
    case 'element':
      // A name with an arrow would end the comment.
      return joined(needed && `<!-- ${needed.replace(/>/g, '&gt;')} -->`, elementOf(recipe));
    case 'command':
      return joined(
        needed && `# ${needed}`,
        model.address && `curl -LO '${addressOf(model)}'`,
        commandOf(recipe),
      );
    default:
      return joined(
        needed && `// ${needed}`,
        '// For a page. In Node, `readFile` of node:fs/promises takes the place of `fetch`.',
        scriptOf(recipe),
      );
  }
}

function joined(...lines: (string | undefined)[]): string {
  return lines.filter(Boolean).join('\n');
}

/** Those of some attributes that are not at their defaults, with their values. */
function changed(
  viewer: GeodesicVoronoiElement,
  names: readonly string[],
): [name: string, value: string][] {
  return names
    .map((name): [string, string] => [name, attributeOf(viewer, name)])
    .filter(([name, value]) => value !== attributeDefaults[name]);
}

/** Attributes as HTML. A link may have given them any value. */
function html(attributes: readonly [name: string, value: string][]): string {
  const escaped = (value: string) => value.replace(/&/g, '&amp;').replace(/"/g, '&quot;');
  return attributes.map(([name, value]) => ` ${name}="${escaped(value)}"`).join('');
}

/** Attributes as options of the command, which are called so, too, but for a prefix. */
function flags(attributes: readonly [name: string, value: string][]): string {
  return attributes.map(([name, value]) => ` --${name.replace('cvt-', '')} ${value}`).join('');
}

/** Attributes as options of the library, in an object. */
function options(attributes: readonly [name: string, value: string][]): string[] {
  const camel = (name: string) => name.replace(/-(.)/, (_, letter) => letter.toUpperCase());
  const shown = (value: string) => (Number.isNaN(Number(value)) ? `'${value}'` : value);
  return attributes.map(([name, value]) => `${camel(name.replace('cvt-', ''))}: ${shown(value)}`);
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

function scriptOf({ viewer, model, origin, sitesFile }: Recipe): string {
  const value = (name: string) => attributeOf(viewer, name);
  const meshOptions = options(changed(viewer, buildAttributes));
  const siteOptions = [
    ...[`seed: ${value('seed')}`, `sampling: '${value('sampling')}'`],
    ...options(changed(viewer, ['per-component'])),
  ];
  const cvtOptions = [
    ...[`iterations: ${value('cvt-iterations')}`, `metric: '${value('metric')}'`],
    ...options(changed(viewer, ['cvt-method'])),
  ];
  const sampled = `await mesh.sampleSites(${value('sites')}, { ${siteOptions.join(', ')} })`;
  const placing: Record<Origin, readonly string[]> = {
    sampled: [`const sites = ${sampled};`],
    even: [
      `let sites = ${sampled};`,
      `const settings = { ${cvtOptions.join(', ')} };`,
      'for await (const state of mesh.cvt(sites, settings)) sites = state.sites;',
    ],
    edited: [`const sites = await (await fetch('${addressOf({ name: sitesFile })}')).json();`],
  };
  return [
    "import { load } from 'geodesic-voronoi';",
    '',
    'const gvd = await load();',
    `const bytes = await (await fetch('${addressOf(model)}')).arrayBuffer();`,
    `const mesh = await gvd.mesh(bytes${meshOptions.length > 0 ? `, { ${meshOptions.join(', ')} }` : ''});`,
    ...placing[origin],
    `const diagram = await mesh.voronoi(sites, { metric: '${value('metric')}', detail: ${value('detail')} });`,
  ].join('\n');
}

function elementOf({ viewer, model, origin, sitesFile }: Recipe): string {
  const name = 'geodesic-voronoi';
  const given = (...names: string[]) =>
    html(names.map((attribute) => [attribute, attributeOf(viewer, attribute)]));
  const cvtNames = origin === 'even' ? ['cvt-iterations', 'cvt-method'] : [];
  const after: Record<Origin, readonly string[]> = {
    sampled: [],
    even: ["  viewer.addEventListener('diagram', () => viewer.playCvt(), { once: true });"],
    edited: [
      "  await new Promise((resolve) => viewer.addEventListener('load', resolve, { once: true }));",
      `  viewer.sites = await (await fetch('${addressOf({ name: sitesFile })}')).json();`,
    ],
  };
  return [
    `<${name} src="${addressOf(model)}"${given('sites', 'seed')}`,
    ` ${given('sampling', 'metric', 'detail')}${html(changed(viewer, [...buildAttributes, 'per-component', ...cvtNames]))}`,
    ` ${html(viewOf(viewer))}></${name}>`,
    '<script type="module">',
    "  import 'geodesic-voronoi/element';",
    ...(origin === 'sampled' ? [] : [`  const viewer = document.querySelector('${name}');`]),
    ...after[origin],
    '</script>',
  ].join('\n');
}

function commandOf({ viewer, model: { name }, origin, sitesFile }: Recipe): string {
  const given = (...names: string[]) =>
    flags(names.map((attribute) => [attribute, attributeOf(viewer, attribute)]));
  const build = changed(viewer, buildAttributes);
  const sites =
    origin === 'edited'
      ? ` --sites ${quoted(sitesFile)}${flags(build)}`
      : given('sites', 'seed', 'sampling') +
        flags([...build, ...changed(viewer, ['per-component'])]);
  const isEven = origin === 'even';
  return [
    `geodesic-voronoi ${isEven ? 'cvt' : 'diagram'} ${quoted(name)} \\`,
    ` ${sites} \\`,
    isEven
      ? ` ${given('metric', 'cvt-iterations')}${flags(changed(viewer, ['cvt-method']))} -o sites.json`
      : ` ${given('metric', 'detail')} -o diagram.json`,
  ].join('\n');
}

/** A name as one word of a shell. */
function quoted(name: string): string {
  return /^[\w.-]+$/.test(name) ? name : `'${name.replace(/'/g, "'\\''")}'`;
}
