// SPDX-License-Identifier: MIT
//
// The element's attributes that have a default, and what it is.

import type { MeshInfo } from 'geodesic-voronoi';
import type { UpAxis } from '../stage/stage_camera.js';

/** How a model is made of its file. */
const build = { 'max-edge': '0', weld: '0', orientation: 'unify', 'min-component': '0' };
/** How sites are placed. */
const sampling = { sites: '0', seed: '1', sampling: 'random', 'per-component': '0' };

export const buildAttributes = Object.keys(build) as (keyof typeof build)[];
/** What the opened model depends on. */
export const openingAttributes = [...buildAttributes, 'limits'] as const;
export const samplingAttributes = Object.keys(sampling) as (keyof typeof sampling)[];

/** The library has the same defaults for what its functions take, so code may leave these out. */
export const attributeDefaults: Readonly<Record<string, string>> = {
  ...build,
  ...sampling,
  metric: 'exact',
  detail: '0',
  'cvt-method': 'lbfgs',
  'cvt-iterations': '50',
  'cvt-tolerance': '0',
  'brush-size': '20',
  'brush-density': '100',
  layers: 'regions bisectors sites',
  exploded: '0',
};

/** The attributes that are not named as the library's options which they set. */
const ofOptions: Readonly<Record<string, string>> = {
  maxEdge: 'max-edge',
  minComponent: 'min-component',
  count: 'sites',
  perComponent: 'per-component',
  energyTolerance: 'cvt-tolerance',
  method: 'cvt-method',
};

/** A sentence of the library with the attribute for an option, and without advice for programmers. */
export function namingAttributes(sentence: string): string {
  return sentence
    .replace(/(?<=: )\w+(?= is )/, (option) => ofOptions[option] ?? option)
    .replace(/; raise the limit \w+ to read it/, '');
}

/** The text of an attribute, or else its default. */
export function attributeOf(element: Pick<Element, 'getAttribute'>, name: string): string {
  return element.getAttribute(name) ?? attributeDefaults[name];
}

/**
 * The axis of a model that points up. Unless one is given, that is the third of an STL: programs for
 * printers and machine parts, which write these, have it upwards.
 */
export function upAxisOf(
  element: Pick<Element, 'getAttribute'>,
  info: MeshInfo | undefined,
): UpAxis {
  const axis = element.getAttribute('up');
  if (axis === 'x' || axis === 'y' || axis === 'z') return axis;
  return info?.origin.format === 'STL' ? 'z' : 'y';
}
