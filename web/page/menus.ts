// SPDX-License-Identifier: MIT
//
// The menus of downloads and of sharing. They are useless without a model, so this code is fetched
// after the first one has been opened.

import { lastSegment } from '../viewer/model_files.js';
import type { GeodesicVoronoiElement } from '../viewer/element.js';
import { byId } from './dom.js';
import { setUpDownloads } from './downloads.js';
import { setUpShare } from './share.js';

export function setUpMenus(viewer: GeodesicVoronoiElement): void {
  /** The name of the file that the model came from. */
  const modelName = () => lastSegment(viewer.info?.origin.file ?? '');
  setUpDownloads(viewer, modelName);
  setUpShare(viewer, modelName);
  for (const id of ['share-button', 'download-button'])
    byId(id, HTMLButtonElement).disabled = false;
}
