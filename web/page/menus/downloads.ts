// SPDX-License-Identifier: MIT
//
// The menu of files to take away.

import type { GeodesicVoronoiElement } from '../../viewer/element.js';
import { sentence } from '../../viewer/session/failure.js';
import { make } from '../../viewer/stage/make.js';
import { byId, listen } from '../base/dom.js';
import { hideError, showError, showNoteOnSites } from '../base/messages.js';
import { modelName } from '../state/page_state.js';
import { repairDual } from '../controls/valid_dual.js';

/** A row of the menu: a result and the formats it comes in. */
interface Row {
  title: string;
  hint: string;
  /** The middle of the files' names, `model-name.format`. */
  name: string;
  formats: readonly string[];
}

const meshFormats = ['glb', 'obj', 'ply', 'stl'] as const;

const rows = [
  {
    title: 'Picture',
    hint: 'The view, as large as it is or larger',
    name: 'picture',
    formats: ['1×', '2×', '3×', '4×'],
  },
  {
    title: 'Outlines',
    hint: 'What is seen of bisectors and the mesh boundary, as lines',
    name: 'outlines',
    formats: ['svg'],
  },
  {
    title: 'Sites',
    hint: 'On triangles, or a table of x, y, z; can be dropped on this page again',
    name: 'sites',
    formats: ['json', 'csv'],
  },
  {
    title: 'Diagram',
    hint: 'Regions, outlines, bisectors, Voronoi points',
    name: 'diagram',
    formats: ['json'],
  },
  { title: 'Bisectors', hint: 'As lines in space', name: 'bisectors', formats: ['glb', 'obj'] },
  {
    title: 'Regions as meshes',
    hint: 'The model, cut along the bisectors; STL as a zip, a file for each',
    name: 'parts',
    formats: meshFormats,
  },
  {
    title: 'Regions as polygons',
    hint: 'One each, with Voronoi points as corners; in GLB and STL cut into triangles',
    name: 'polygons',
    formats: meshFormats,
  },
  {
    title: 'Dual',
    hint: 'A vertex per site, a polygon per Voronoi point; in GLB and STL cut into triangles',
    name: 'dual',
    formats: meshFormats,
  },
] as const satisfies readonly Row[];

/** The formats of each name, which `exports.ts` makes. */
export type Formats = { [Each in (typeof rows)[number] as Each['name']]: Each['formats'][number] };

/** What a downloaded file is called, after the file of its model. */
export function downloadName(model: string, name: string, ending: string): string {
  return `${model.replace(/\.[^.]*$/, '') || 'model'}-${name}.${ending}`;
}

/** One menu of files to take away. */
export function setUpDownloads(viewer: GeodesicVoronoiElement): void {
  const menu = byId('download', HTMLElement);
  let endNote = () => {};

  const download = async ({ name }: Row, format: string, button: HTMLButtonElement) => {
    // This takes seconds for a large model.
    button.ariaBusy = 'true';
    // Notes and errors are about the last file only.
    endNote();
    hideError();
    // Now, not when the file is there: the reader may be elsewhere by then.
    byId('download-button', HTMLElement).focus();
    button.disabled = true;
    try {
      // The code that writes files is fetched with the first download.
      const { fileOf } = await import('./exports.js');
      const file = await fileOf(viewer, name, format);
      save(file.blob, downloadName(modelName(viewer), file.name, file.ending));
      if (file.faults) {
        const title = 'Add sites to make it valid';
        endNote = showNoteOnSites(viewer, file.faults, {
          title,
          act: () => void repairDual(viewer),
        });
      }
    } catch (error) {
      showError(sentence('The file cannot be made', error).message);
    } finally {
      // On a phone, the menu would cover the error.
      menu.hidePopover();
      button.ariaBusy = null;
      update();
    }
  };

  const update = () => {
    for (const button of menu.querySelectorAll('button')) {
      const isMissing = button.dataset.name !== 'picture' && viewer.diagram === undefined;
      button.disabled = isMissing || button.ariaBusy === 'true';
    }
  };
  menu.append(
    ...rows.map((row) => rowOf(row, (format, button) => void download(row, format, button))),
  );
  menu.addEventListener('beforetoggle', update);
  listen(viewer, 'diagram', update);
}

function rowOf(row: Row, choose: (format: string, button: HTMLButtonElement) => void): HTMLElement {
  const title = make('p', {}, row.title, make('small', {}, row.hint));
  const formats = row.formats.map((format) => {
    const button = make('button', {
      type: 'button',
      id: `download-${row.name}-${format.replace('×', 'x')}`,
      textContent: format.toUpperCase(),
      ariaLabel: `${row.title}, ${format.toUpperCase()}`,
    });
    button.dataset.name = row.name;
    button.addEventListener('click', () => choose(format, button));
    return button;
  });
  const properties = { className: 'menu-row', role: 'group', ariaLabel: row.title };
  return make('div', properties, title, make('div', {}, ...formats));
}

function save(blob: Blob, name: string): void {
  const link = make('a', { href: URL.createObjectURL(blob), download: name });
  link.click();
  // Some browsers begin to read the file only in a later task.
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
