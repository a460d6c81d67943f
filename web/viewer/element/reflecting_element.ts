// SPDX-License-Identifier: MIT
//
// Attributes of the element that are also properties.

import { Attributes } from '../attributes/attribute_values.js';
import type { ViewerEventMap } from '../events.js';
import type { Layer } from '../drawing/model_drawing.js';
import type { Status } from '../session/session_listener.js';

/** Where there is no DOM, importing the element does nothing. */
const Base = (globalThis.HTMLElement ?? class {}) as typeof HTMLElement;

/** The events of the element, and those that every element has, as `click`. */
type EventMap = ViewerEventMap & Omit<HTMLElementEventMap, keyof ViewerEventMap>;

type Listener<Type extends keyof EventMap> = (this: HTMLElement, event: EventMap[Type]) => unknown;

export interface ReflectingElement {
  addEventListener<Type extends keyof EventMap>(
    type: Type,
    listener: Listener<Type>,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
  removeEventListener<Type extends keyof EventMap>(
    type: Type,
    listener: Listener<Type>,
    options?: boolean | EventListenerOptions,
  ): void;
  removeEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | EventListenerOptions,
  ): void;
}

/**
 * The element's attributes as properties, and the types of its events. React and Vue set the
 * properties in place of the attributes, so these take an attribute's text, too.
 */
export class ReflectingElement extends Base {
  protected readonly attributeValues = new Attributes(this);

  constructor() {
    super();
    // Properties that a page set before the element was defined would hide those of the class.
    const { observedAttributes, prototype } = new.target as typeof ReflectingElement & {
      observedAttributes: readonly string[];
    };
    for (const [name, value] of Object.entries(this)) {
      if (!(name in prototype)) continue;
      Reflect.deleteProperty(this, name);
      const attribute = name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
      const isText = Array.isArray(value) || Object(value) !== value;
      if (isText && observedAttributes.includes(attribute)) this.reflect(attribute, value);
      // Setters of other values need the whole element. What one throws, as `sites` does without a
      // model, is then an uncaught error of the page.
      else queueMicrotask(() => Reflect.set(this, name, value));
    }
  }

  /** Sets an attribute to a property's value; without a value, as React sets properties that are gone, removes it. */
  protected reflect(attribute: string, value: unknown): void {
    if (value === undefined || value === null) this.removeAttribute(attribute);
    else this.setAttribute(attribute, Array.isArray(value) ? value.join(' ') : String(value));
  }

  /** Address of the model. */
  get src(): string {
    return this.getAttribute('src') ?? '';
  }

  set src(address: string | undefined) {
    this.reflect('src', address);
  }

  /** Describes the view to those who do not see it. */
  get alt(): string {
    return this.getAttribute('alt') ?? '';
  }

  set alt(text: string | undefined) {
    this.reflect('alt', text);
  }

  /** Address of a picture that is shown until there is a model, and if there can be none. */
  get poster(): string {
    return this.getAttribute('poster') ?? '';
  }

  set poster(address: string | undefined) {
    this.reflect('poster', address);
  }

  /** With 'lazy' nothing is fetched or made before the element is near the view. */
  get loading(): 'eager' | 'lazy' {
    return this.getAttribute('loading') === 'lazy' ? 'lazy' : 'eager';
  }

  set loading(loading: 'eager' | 'lazy' | undefined) {
    this.reflect('loading', loading);
  }

  /** With 'manual' the poster stays until `dismissPoster()`. */
  get reveal(): 'auto' | 'manual' {
    return this.getAttribute('reveal') === 'manual' ? 'manual' : 'auto';
  }

  set reveal(reveal: 'auto' | 'manual' | undefined) {
    this.reflect('reveal', reveal);
  }

  /** What pointer and keys do: change sites and density too, move the camera only, or nothing. */
  get interactive(): 'edit' | 'camera' | 'none' {
    return this.attributeValues.interactive;
  }

  set interactive(interactive: 'edit' | 'camera' | 'none' | undefined) {
    this.reflect('interactive', interactive);
  }

  /** What the element is doing. */
  get status(): Status {
    return (this.getAttribute('status') ?? 'empty') as Status;
  }

  /** The layers that are shown. */
  get layers(): readonly Layer[] {
    return this.attributeValues.layers;
  }

  set layers(shown: readonly Layer[] | string | undefined) {
    this.reflect('layers', shown);
  }

  /** How far the regions move away from each other in the exploded view, 0 (none) … 1. */
  get exploded(): number {
    return this.attributeValues.exploded;
  }

  set exploded(share: number | string | undefined) {
    this.reflect('exploded', share);
  }
}
