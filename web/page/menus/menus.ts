// SPDX-License-Identifier: MIT
//
// The menus of downloads and of sharing. They are useless without a model, so this code is fetched
// after the first one has been opened.

import type { GeodesicVoronoiElement } from '../../viewer/element.js';
import { byId } from '../base/dom.js';
import { setUpDownloads } from './downloads.js';
import { setUpShare } from './share.js';

export function setUpMenus(viewer: GeodesicVoronoiElement): void {
  setUpDownloads(viewer);
  setUpShare(viewer);
  for (const id of ['share-button', 'download-button'])
    byId(id, HTMLButtonElement).disabled = false;
  // A press on the model closes the menu that is open, and does nothing else.
  const onlyCloseMenu = (event: Event) => {
    if (document.querySelector(':popover-open')) event.stopPropagation();
  };
  viewer.addEventListener('pointerdown', onlyCloseMenu, { capture: true });
}
