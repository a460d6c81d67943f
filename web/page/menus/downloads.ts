// SPDX-License-Identifier: MIT
//
// The menu of files to take away.

import type { GeodesicVoronoiElement } from '../../viewer/element.js';
import { isAbandoned, sentence } from '../../viewer/session/failure.js';
import { make } from '../../viewer/stage/make.js';
import { byId, listen } from '../base/dom.js';
import { hideError, showError, showNoteOnSites } from '../base/messages.js';
import { fetched } from '../base/scripts.js';
import { repairDual } from '../controls/valid_dual.js';
import { type Row, rows } from './download_rows.js';

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
      // The code that writes files is fetched after the first diagram, or now.
      const { fileOf } = await fetched(import('./exports.js'));
      const file = await fileOf(viewer, name, format);
      save(file.blob, file.name);
      if (file.violations) {
        const title = 'Add sites to make it valid';
        endNote = showNoteOnSites(viewer, file.violations, {
          title,
          act: () => void repairDual(viewer),
        });
      }
    } catch (error) {
      showError(
        isAbandoned(error)
          ? 'The file was not made: its diagram has been replaced by another one meanwhile.'
          : sentence('The file cannot be made', error).message,
      );
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
  // Some browsers read the file only once the reader has said where to.
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
