// SPDX-License-Identifier: MIT
//
// The buttons on the view.

import { upAxisOf } from '../../viewer/attributes/attribute_defaults.js';
import type { GeodesicVoronoiElement } from '../../viewer/element.js';
import { byId, listen, onClick, watchAttributes } from '../base/dom.js';

const axes = ['y', 'z', 'x'] as const;

/** The buttons on the view: undo and redo, fitting, the upward axis, room for the view. */
export function setUpToolbar(viewer: GeodesicVoronoiElement): void {
  setUpHistory(viewer);
  onClick('fit', () => viewer.refit());
  setUpAxis(viewer);
  setUpFullscreen();
  setUpPanelButton();
}

function setUpHistory(viewer: GeodesicVoronoiElement): void {
  const undo = onClick('undo', () => viewer.undo());
  const redo = onClick('redo', () => viewer.redo());
  listen(viewer, 'sites-change', ({ canUndo, canRedo }) => {
    undo.disabled = !canUndo;
    redo.disabled = !canRedo;
  });
}

function setUpAxis(viewer: GeodesicVoronoiElement): void {
  const axis = () => upAxisOf(viewer, viewer.info);
  const button = onClick('up', () => {
    viewer.setAttribute('up', axes[(axes.indexOf(axis()) + 1) % axes.length]);
  });
  const name = button.querySelector('span');
  const tell = () => {
    const letter = axis().toUpperCase();
    if (name) name.textContent = letter;
    button.ariaLabel = `Upward axis: ${letter}`;
  };
  watchAttributes(viewer, ['up'], tell);
  listen(viewer, 'load', tell); // whose default depends on the format
}

function setUpFullscreen(): void {
  const view = byId('view', HTMLElement);
  const button = onClick('fullscreen', () => {
    if (document.fullscreenElement) void document.exitFullscreen();
    else void view.requestFullscreen();
  });
  // Some phones have no full screen.
  button.hidden = !document.fullscreenEnabled;
  document.addEventListener('fullscreenchange', () => {
    button.ariaPressed = String(document.fullscreenElement !== null);
  });
}

function setUpPanelButton(): void {
  const button = onClick('hide-panel', () => {
    const isHidden = document.body.classList.toggle('without-panel');
    button.ariaPressed = String(isHidden);
  });
}
