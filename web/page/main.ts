// SPDX-License-Identifier: MIT
//
// The demo around the element: sets up the parts of the page, which are in the folders.

import type { LoadOptions } from 'geodesic-voronoi';
import { GeodesicVoronoiElement } from '../viewer/element.js';
import { provideModules } from '../viewer/session/library_pool.js';
import { provideModel } from '../viewer/session/model_files.js';
import { byId } from './base/dom.js';
import { showFailure } from './base/messages.js';
import { fetched } from './base/scripts.js';
import { setUpAddress } from './state/address.js';
import { Edits } from './state/edits.js';
import { setUpFirstSight } from './state/first_sight.js';
import { setUpMeshReport } from './model/mesh_report.js';
import { setUpModelChoice } from './model/model_choice.js';
import { setUpCvtControls } from './controls/cvt_controls.js';
import { setUpDensityControls } from './controls/density_controls.js';
import { keepFocus } from './controls/kept_focus.js';
import { setUpKeyboard } from './controls/keyboard.js';
import { setUpSheet } from './controls/sheet.js';
import { setUpSiteControls } from './controls/site_controls.js';
import { setUpToolbar } from './controls/toolbar.js';
import { setUpViewControls } from './controls/view_controls.js';
import { CvtReadings } from './readings/cvt_readings.js';
import { setUpFeedback } from './readings/feedback.js';

/** How long after the first diagram the rest of the page is fetched, in milliseconds. */
const restMilliseconds = 2000;

/** A model that is being fetched. The address that the page has by now may name another one. */
interface FetchedModel {
  address: string;
  response: Promise<Response>;
  opening: AbortController;
}

/** Sets up the page; the fetches of the modules and of the first model have begun already. */
export function setUpPage(modules: Promise<LoadOptions>, model: FetchedModel): void {
  provideModules(modules);
  const { address, response, opening } = model;
  provideModel(address, (signal) => {
    // It may be given up before the library is there that asks for the model.
    if (signal.aborted) opening.abort();
    signal.addEventListener('abort', () => opening.abort());
    return response;
  });
  const viewer = byId('viewer', GeodesicVoronoiElement);
  setUpFeedback(viewer);
  const edits = new Edits(viewer);
  setUpModelChoice(viewer, edits);
  setUpMeshReport(viewer);
  const readings = new CvtReadings(viewer);
  setUpFirstSight(viewer, readings);
  setUpAddress(viewer, edits);
  setUpSiteControls(viewer);
  setUpCvtControls(viewer);
  setUpDensityControls(viewer);
  setUpViewControls(viewer);
  setUpToolbar(viewer);
  setUpKeyboard(viewer);
  keepFocus(viewer);
  setUpSheet();
  addMenus(viewer);
  viewer.addEventListener('diagram', () => setTimeout(fetchTheRest, restMilliseconds), {
    once: true,
  });
}

/** Fetches what opening and saving files needs, which should do without the server later on. */
function fetchTheRest(): void {
  const scripts = [
    import('./model/sites_file.js'),
    import('./model/own_models.js'),
    import('./menus/exports.js'),
  ];
  for (const script of scripts) script.catch(() => {}); // it is tried again when it is needed
}

/** Adds the menus with the next model; if they cannot be fetched then, with the one after it. */
function addMenus(viewer: GeodesicVoronoiElement): void {
  const add = async () => {
    try {
      const { setUpMenus } = await fetched(import('./menus/menus.js'));
      setUpMenus(viewer);
    } catch (error) {
      showFailure('Downloads and links cannot be loaded', error);
      addMenus(viewer);
    }
  };
  viewer.addEventListener('load', () => void add(), { once: true });
}
