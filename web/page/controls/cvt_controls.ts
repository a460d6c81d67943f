// SPDX-License-Identifier: MIT
//
// The buttons and fields of the centroidal tessellation.

import type { CvtStatus, GeodesicVoronoiElement } from '../../viewer/element.js';
import { bindAttributes, listen, onClick } from '../base/dom.js';

/** The text of the button that plays. */
const actions: Record<CvtStatus, string> = {
  idle: 'Even out regions',
  running: 'Pause',
  paused: 'Even out further',
  done: 'Even out regions',
};

/** The centroidal tessellation: how it goes, playing it, and going back to before it. */
export function setUpCvtControls(viewer: GeodesicVoronoiElement): void {
  bindAttributes(viewer, 'cvt-method', 'cvt-iterations', 'cvt-tolerance');
  const isRunning = () => viewer.cvtStatus === 'running';
  // In the exploded view, one would not see it play.
  const endExplodedView = () => {
    if (viewer.exploded > 0) viewer.exploded = 0;
  };
  const play = onClick('cvt-play', () => {
    endExplodedView();
    if (isRunning()) viewer.pauseCvt();
    else viewer.playCvt();
  });
  const step = onClick('cvt-step', () => {
    endExplodedView();
    viewer.stepCvt();
  });
  const reset = onClick('cvt-reset', () => viewer.resetCvt());
  const update = () => {
    play.textContent = actions[viewer.cvtStatus];
    play.disabled = step.disabled = viewer.sites.face.length === 0;
    reset.disabled = viewer.cvtStatus === 'idle';
  };
  listen(viewer, 'cvt-change', update);
  listen(viewer, 'sites-change', update);
}
