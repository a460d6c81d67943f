// SPDX-License-Identifier: MIT
//
// A warning about models that are too large.

import type { GeodesicVoronoiElement } from '../../viewer/element.js';
import { listen } from '../base/dom.js';
import { showNote } from '../base/messages.js';
import { integer } from '../base/numbers.js';

/**
 * The memory of a mesh with the diagram of a few hundred sites, measured in Node at 280,000
 * triangles: 690 bytes each with exact distances, 580 with DGPC.
 */
const bytesPerFace = 700;
/** The memory of a browser's tab to rely on; 32-bit WebAssembly has at most 4 GB. */
const bytesThatFit = 1.2e9;

/** Warns of a diagram that may not fit into memory. */
export function setUpSizeWarning(viewer: GeodesicVoronoiElement): void {
  listen(viewer, 'load', ({ info }) => {
    const bytes = info.faces * bytesPerFace;
    if (bytes <= bytesThatFit) return;
    showNote(
      `This model has ${integer(info.faces)} triangles, which take about ` +
        `${(bytes / 1e9).toFixed(1)} GB of memory: a coarser model is safer.`,
    );
  });
}
