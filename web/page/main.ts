// SPDX-License-Identifier: MIT
import { GeodesicVoronoiElement } from '../viewer/element.js';
import { setUpCvtControls } from './cvt_controls.js';
import { setUpDensityControls } from './density_controls.js';
import { byId } from './dom.js';
import { setUpDownloads } from './downloads.js';
import { setUpFeedback } from './feedback.js';
import { setUpKeyboard } from './keyboard.js';
import { setUpMeshReport } from './mesh_report.js';
import { setUpModelChoice } from './model_choice.js';
import { setUpSheet } from './sheet.js';
import { setUpSiteControls } from './site_controls.js';
import { setUpViewControls } from './view_controls.js';

const viewer = byId('viewer', GeodesicVoronoiElement);
setUpModelChoice(viewer);
setUpMeshReport(viewer);
setUpSiteControls(viewer);
setUpCvtControls(viewer);
setUpDensityControls(viewer);
setUpViewControls(viewer);
setUpFeedback(viewer);
setUpDownloads(viewer);
setUpKeyboard(viewer);
setUpSheet();
