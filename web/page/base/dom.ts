// SPDX-License-Identifier: MIT
//
// Finding elements of the page and listening to them.

import type { GeodesicVoronoiElement, ViewerEvents } from '../../viewer/element.js';

/** The element with this id, checked to be of this class. */
export function byId<T extends HTMLElement>(id: string, type: new () => T): T {
  const element = document.getElementById(id);
  if (!(element instanceof type)) throw new Error(`There is no ${type.name} with the id ${id}.`);
  return element;
}

/** Calls back at each click of a button. */
export function onClick(id: string, listener: () => void): HTMLButtonElement {
  const button = byId(id, HTMLButtonElement);
  button.addEventListener('click', listener);
  return button;
}

/** Keeps fields at the values of the viewer's attributes, by whose names they are given. */
export function showAttributes(
  viewer: GeodesicVoronoiElement,
  fields: Readonly<Record<string, HTMLInputElement | HTMLSelectElement>>,
): void {
  const initial = Object.entries(fields).map(([name, field]) => ({
    name,
    field,
    value: field.value,
  }));
  const show = () => {
    for (const { name, field, value } of initial) field.value = viewer.getAttribute(name) ?? value;
  };
  show();
  new MutationObserver(show).observe(viewer, { attributeFilter: Object.keys(fields) });
}

/** Calls back with the `detail` of each event of the viewer. */
export function listen<Type extends keyof ViewerEvents>(
  viewer: GeodesicVoronoiElement,
  type: Type,
  listener: (detail: ViewerEvents[Type]) => void,
): void {
  viewer.addEventListener(type, (event) => listener((event as CustomEvent).detail));
}
