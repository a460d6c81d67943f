// SPDX-License-Identifier: MIT
//
// Choosing a model: a sample, files, a folder, or any of them dropped on the page.

import type { GeodesicVoronoiElement } from '../viewer/element.js';
import { lastSegment } from '../viewer/model_files.js';
import { byId, listen, onClick } from './dom.js';
import { modelOf } from './first_model.js';
import { openSites } from './sites_file.js';
import samples from './samples.json' with { type: 'json' };

/** How a model gets into the page: the menu of samples, the pickers of files and folders, and dropping them on it. */
export function setUpModelChoice(viewer: GeodesicVoronoiElement): void {
  setUpMenu(viewer);
  setUpPicker(viewer);
  setUpDrop(viewer);
}

function setUpMenu(viewer: GeodesicVoronoiElement): void {
  const menu = byId('samples', HTMLSelectElement);
  const credit = byId('credit', HTMLElement);
  const ownFile = new Option('', '');
  ownFile.hidden = true;
  menu.replaceChildren(ownFile, ...samples.map(({ title, file }) => new Option(title, file)));

  menu.disabled = false;
  menu.value = lastSegment(modelOf(location.hash)); // which is on its way

  let current = '';
  const choose = () => {
    menu.value = current;
  };
  menu.addEventListener('change', async () => {
    // A model that cannot be opened leaves the one before, which is then what the menu says.
    if (!(await viewer.load(`./samples/${menu.value}`))) choose();
  });
  listen(viewer, 'load', ({ name }) => {
    const sample = samples.find(({ file }) => file === name);
    ownFile.text = sample ? '' : name;
    current = sample?.file ?? '';
    credit.textContent = sample?.credit ?? '';
    choose();
  });
}

/** Sites for the model there is, or a model. */
function openFiles(viewer: GeodesicVoronoiElement, files: readonly File[]): Promise<unknown> {
  return isSites(files) ? openSites(viewer, files[0]) : viewer.loadFiles(files);
}

function openDropped(viewer: GeodesicVoronoiElement, dropped: DataTransfer): Promise<unknown> {
  const files = [...dropped.files];
  return isSites(files) ? openSites(viewer, files[0]) : viewer.loadDropped(dropped);
}

function isSites(files: readonly File[]): boolean {
  return files.length === 1 && /\.json$/i.test(files[0].name);
}

function setUpPicker(viewer: GeodesicVoronoiElement): void {
  for (const [button, files] of [
    ['open', 'files'],
    ['open-folder', 'folder'],
  ]) {
    const input = byId(files, HTMLInputElement);
    onClick(button, () => input.click()).disabled = false;
    input.addEventListener('change', () => {
      if (input.files?.length) void openFiles(viewer, [...input.files]);
      // The same file may be chosen again.
      input.value = '';
    });
  }
}

function setUpDrop(viewer: GeodesicVoronoiElement): void {
  const overlay = byId('drop', HTMLElement);
  const carriesFiles = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false;
  addEventListener('dragover', (event) => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
    overlay.hidden = false;
  });
  addEventListener('dragleave', (event) => {
    // Leaving one element for another is no leaving of the page.
    if (event.relatedTarget === null) overlay.hidden = true;
  });
  addEventListener('drop', (event) => {
    overlay.hidden = true;
    if (!carriesFiles(event)) return;
    event.preventDefault();
    if (event.dataTransfer) void openDropped(viewer, event.dataTransfer);
  });
}
