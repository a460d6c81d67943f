// SPDX-License-Identifier: MIT
import type { GeodesicVoronoiElement } from '../viewer/element.js';
import { byId, listen, onClick } from './dom.js';
import { pageState } from './page_state.js';
import samples from './samples.json' with { type: 'json' };

/** A link that brings this diagram back, and code that makes it. */
export function setUpShare(viewer: GeodesicVoronoiElement): void {
  const menu = byId('share', HTMLElement);
  const note = byId('share-note', HTMLElement);
  const link = byId('share-link', HTMLInputElement);
  const code = byId('code', HTMLElement);
  let model = '';
  listen(viewer, 'load', ({ name }) => {
    model = name;
  });

  const fill = () => {
    const isSample = samples.some(({ file }) => file === model);
    const address = new URL(location.href);
    address.hash = pageState(viewer, isSample ? model : '');
    link.value = address.href;
    note.textContent = isSample
      ? 'Whoever opens the link sees this model, these sites and this view.'
      : `The link does not hold ${model}: whoever opens it has to open that file, too.`;
    code.textContent = codeOf(viewer, model, chosen());
  };
  const chosen = () =>
    menu.querySelector<HTMLInputElement>('input[name="code"]:checked')?.value ?? 'script';
  menu.addEventListener('toggle', (event) => {
    if ((event as ToggleEvent).newState === 'open') fill();
  });
  for (const radio of menu.querySelectorAll('input[name="code"]')) {
    radio.addEventListener('change', fill);
  }
  copyOnClick('copy-link', () => link.value);
  copyOnClick('copy-code', () => code.textContent ?? '');
}

function copyOnClick(id: string, text: () => string): void {
  const button = onClick(id, async () => {
    const title = button.textContent;
    try {
      await navigator.clipboard.writeText(text());
      button.textContent = 'Copied';
    } catch {
      button.textContent = 'Not allowed here';
    }
    setTimeout(() => {
      button.textContent = title;
    }, 1500);
  });
}

/** What the page has been told, for another place. Sites that were moved by hand are a file's matter. */
function codeOf(viewer: GeodesicVoronoiElement, file: string, form: string): string {
  const value = (name: string, otherwise: string) => viewer.getAttribute(name) ?? otherwise;
  const count = value('sites', '60');
  const seed = value('seed', '1');
  const sampling = value('sampling', 'random');
  const metric = value('metric', 'exact');
  const detail = value('detail', '0');
  const isEven = viewer.cvtStatus !== 'idle';
  const iterations = value('cvt-iterations', '50');
  switch (form) {
    case 'element':
      return [
        '<script type="module">',
        "  import 'geodesic-voronoi/element';",
        '</script>',
        `<geodesic-voronoi src="${file}" sites="${count}" seed="${seed}"`,
        `  sampling="${sampling}" metric="${metric}" detail="${detail}"></geodesic-voronoi>`,
      ].join('\n');
    case 'command':
      return [
        `geodesic-voronoi ${isEven ? 'cvt' : 'diagram'} ${file} \\`,
        `  --sites ${count} --seed ${seed} --sampling ${sampling} \\`,
        isEven
          ? `  --metric ${metric} --iterations ${iterations} -o sites.json`
          : `  --metric ${metric} --detail ${detail} -o diagram.json`,
      ].join('\n');
    default:
      return [
        "import { load } from 'geodesic-voronoi';",
        '',
        'const library = await load();',
        `const bytes = await (await fetch('${file}')).arrayBuffer();`,
        'const mesh = await library.mesh(new Uint8Array(bytes));',
        `${isEven ? 'let' : 'const'} sites = await mesh.sampleSites(${count}, { seed: ${seed}, sampling: '${sampling}' });`,
        ...(isEven
          ? [
              `for await (const state of mesh.cvt(sites, { iterations: ${iterations}, metric: '${metric}' })) {`,
              '  sites = state.sites;',
              '}',
            ]
          : []),
        `const diagram = await mesh.voronoi(sites, { metric: '${metric}', detail: ${detail} });`,
      ].join('\n');
  }
}
