// SPDX-License-Identifier: MIT
//
// A warning about models that are too large.

import type { GeodesicVoronoiElement } from '../viewer/element.js';
import { listen } from './dom.js';
import { showNote } from './feedback.js';
import { integer } from './numbers.js';

/** What a diagram of a few hundred sites takes, in bytes per triangle; measured, see the README. */
const bytesPerFace = { exact: 800, dgpc: 280 };
/** The memory of a browser's tab to rely on; 32-bit WebAssembly has at most 4 GB. */
const bytesThatFit = 1.2e9;

/** Warns of a diagram that will not fit into memory, and uses the metric that takes less. */
export function setUpSizeWarning(viewer: GeodesicVoronoiElement): void {
  listen(viewer, 'load', ({ info }) => {
    const isExact = (viewer.getAttribute('metric') ?? 'exact') === 'exact';
    const bytes = info.faces * (isExact ? bytesPerFace.exact : bytesPerFace.dgpc);
    if (bytes <= bytesThatFit) return;
    const size = `This model has ${integer(info.faces)} triangles`;
    if (isExact) {
      viewer.setAttribute('metric', 'dgpc');
      showNote(
        `${size}: exact distances would take about ${gigabytes(bytes)} of memory, so fast ones ` +
          `(DGPC, about ${gigabytes(info.faces * bytesPerFace.dgpc)}) are used.`,
        { title: 'Exact anyway', act: () => viewer.setAttribute('metric', 'exact') },
      );
    } else {
      showNote(
        `${size}, which take about ${gigabytes(bytes)} of memory: a coarser model is safer.`,
      );
    }
  });
}

function gigabytes(bytes: number): string {
  return `${(bytes / 1e9).toFixed(1)} GB`;
}
