// SPDX-License-Identifier: MIT
//
// The demo around the element: every file here sets up one part of the page.

import type { LoadOptions } from 'geodesic-voronoi';
import { GeodesicVoronoiElement } from '../viewer/element.js';
import { sentence } from '../viewer/session/failure.js';
import { provideModules } from '../viewer/session/library_pool.js';
import { provideModel } from '../viewer/session/model_files.js';
import { setUpAddress } from './address.js';
import { setUpAnnouncements } from './announcements.js';
import { setUpCvtControls } from './cvt_controls.js';
import { CvtReadings } from './cvt_readings.js';
import { setUpDensityControls } from './density_controls.js';
import { byId } from './dom.js';
import { setUpFeedback, showError } from './feedback.js';
import { modelOf } from './first_model.js';
import { setUpFirstSight } from './first_sight.js';
import { keepFocus } from './kept_focus.js';
import { setUpKeyboard } from './keyboard.js';
import { setUpMeshReport } from './mesh_report.js';
import { setUpModelChoice } from './model_choice.js';
import { setUpSheet } from './sheet.js';
import { setUpSiteControls } from './site_controls.js';
import { setUpSizeWarning } from './size_warning.js';
import { setUpToolbar } from './toolbar.js';
import { setUpViewControls } from './view_controls.js';

/** Sets up the page; the fetches of the modules and of the first model have begun already. */
export function setUpPage(
  modules: Promise<LoadOptions>,
  model: Promise<Response>,
  opening: AbortController,
): void {
  provideModules(modules);
  provideModel(modelOf(location.hash), (signal) => {
    // It may be given up before the library is there that asks for the model.
    if (signal.aborted) opening.abort();
    signal.addEventListener('abort', () => opening.abort());
    return model;
  });
  const viewer = byId('viewer', GeodesicVoronoiElement);
  setUpFeedback(viewer);
  setUpModelChoice(viewer);
  setUpMeshReport(viewer);
  setUpSizeWarning(viewer);
  const readings = new CvtReadings(viewer);
  setUpFirstSight(viewer, readings);
  setUpAddress(viewer);
  setUpSiteControls(viewer);
  setUpCvtControls(viewer, readings);
  setUpDensityControls(viewer);
  setUpViewControls(viewer);
  setUpToolbar(viewer);
  setUpKeyboard(viewer);
  keepFocus(viewer);
  setUpAnnouncements(viewer);
  setUpSheet();
  viewer.addEventListener('load', () => void addMenus(viewer), { once: true });
}

async function addMenus(viewer: GeodesicVoronoiElement): Promise<void> {
  try {
    const { setUpMenus } = await import('./menus.js');
    setUpMenus(viewer);
  } catch (error) {
    showError(sentence('Downloads and links cannot be had', error).message);
  }
}
