// SPDX-License-Identifier: MIT
//
// Finding elements of the page and listening to them.

import { attributeOf } from '../../viewer/attributes/attribute_defaults.js';
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

/** Calls back now, and when one of these attributes of the viewer has changed. */
export function watchAttributes(
  viewer: GeodesicVoronoiElement,
  names: string[],
  listener: () => void,
): void {
  listener();
  new MutationObserver(listener).observe(viewer, { attributeFilter: names });
}

type Field = HTMLInputElement | HTMLSelectElement;

/**
 * Keeps fields at the values of the viewer's attributes, by whose names they are given. One that is set
 * to what it was, as after a failure, leaves its field as it is.
 */
export function showAttributes(
  viewer: GeodesicVoronoiElement,
  fields: Readonly<Record<string, Field>>,
): void {
  const shown = new Map<string, string>();
  watchAttributes(viewer, Object.keys(fields), () => {
    for (const [name, field] of Object.entries(fields)) {
      const value = attributeOf(viewer, name);
      if (shown.get(name) !== value) field.value = value;
      shown.set(name, value);
    }
  });
}

/** Has fields set attributes of the viewer, by whose names they have their ids, and show them. */
export function bindAttributes(viewer: GeodesicVoronoiElement, ...names: string[]): void {
  for (const name of names) {
    const field = byId(name, HTMLElement) as Field;
    field.addEventListener('change', () => {
      if (field.reportValidity()) viewer.setAttribute(name, field.value);
    });
    showAttributes(viewer, { [name]: field });
  }
}

/** Calls back with the `detail` of each event of the viewer. */
export function listen<Type extends keyof ViewerEvents>(
  viewer: GeodesicVoronoiElement,
  type: Type,
  listener: (detail: ViewerEvents[Type]) => void,
): void {
  viewer.addEventListener(type, (event) => listener((event as CustomEvent).detail));
}
