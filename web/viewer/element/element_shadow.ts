// SPDX-License-Identifier: MIT
//
// The inside of the element: its canvas, and what lies on it.

import { legendStyle } from '../layers/legend.js';
import { contextLost } from '../session/failure.js';
import { english, make } from '../stage/make.js';

/**
 * The canvas keeps its shape (`object-fit`) on paper, for which browsers do not draw it anew. In full
 * screen there is not the browser's black, on which lines are lost.
 */
const style = `
  :host {
    display: block;
    position: relative;
    box-sizing: border-box;
    width: 300px;
    height: 200px;
    overflow: hidden;
    contain: strict;
    container-type: size;
  }
  :host([hidden]) { display: none; }
  :host(:fullscreen) { background: Canvas; }
  canvas {
    /* All of the element; its padding is room for what lies on the view. */
    position: absolute; inset: 0; width: 100%; height: 100%; outline: none;
    object-fit: contain;
    /* The camera's controls would set it to "none" everywhere. */
    touch-action: var(--own-touch-action, none) !important;
    color: CanvasText; /* themeOf() tells dark pages by it */
  }
  canvas:focus-visible { box-shadow: inset 0 0 0 3px var(--focus-color, Highlight); }
  :host([interactive='none']) canvas { pointer-events: none; }
  .aim {
    position: absolute; inset: 50% auto auto 50%; width: 28px; height: 28px;
    margin: -14px; pointer-events: none; opacity: 0;
    background:
      linear-gradient(#1f2933 0 0) 50% 50% / 2px 100% no-repeat,
      linear-gradient(#1f2933 0 0) 50% 50% / 100% 2px no-repeat;
    mask: radial-gradient(circle, transparent 5px, #000 5.5px);
    filter: drop-shadow(0 0 1px #fff) drop-shadow(0 0 1px #fff);
  }
  canvas:focus-visible + .aim { opacity: 1; }
  .message {
    position: absolute; inset: auto 0 50%; margin: auto; padding: 1em 1.25em;
    width: fit-content; max-width: 28em; text-align: center; overflow-wrap: anywhere;
    color: var(--message-color, CanvasText); border-radius: 10px;
    background: var(--message-background, color-mix(in srgb, Canvas 88%, transparent));
  }
  .poster {
    position: absolute; inset: 0; box-sizing: border-box; padding: inherit;
    pointer-events: none; background: var(--poster-color, none);
  }
  .poster img { width: 100%; height: 100%; object-fit: contain; }
  .poster[hidden], .poster img[hidden] { display: none; }
  :host([reveal='manual']) .poster { pointer-events: auto; }
  .progress {
    position: absolute; inset: 0 0 auto; height: var(--progress-bar-height, 4px);
    pointer-events: none; visibility: hidden;
  }
  /* Short work shows no bar: it would only flicker. */
  .progress.busy { visibility: visible; transition: visibility 0s 0.3s; }
  .progress .bar {
    height: 100%; background: var(--progress-bar-color, Highlight);
    transform-origin: left; scale: var(--share, 0) 1;
  }
  .hint {
    position: absolute; inset: auto 0 1em; margin: auto; width: fit-content; max-width: 90%;
    padding: 0.4em 0.9em; border-radius: 2em; pointer-events: none; opacity: 0;
    font: 0.875rem/1.4 system-ui, sans-serif;
    color: var(--hint-color, #fff); background: var(--hint-background, rgb(31 41 51 / 85%));
    transition: opacity 0.3s;
  }
  .hint.shown { opacity: 1; }
  .unseen { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
`;

const hintMilliseconds = 2000;

/**
 * What the element's shadow holds: its canvas and what lies on it. Made by DOM calls and a
 * constructed style sheet, which a strict content security policy allows.
 */
export class ElementShadow {
  readonly canvas = make('canvas', { tabIndex: 0 });
  readonly #root: ShadowRoot;
  readonly #aim = make('div', { className: 'aim' });
  readonly #message = make('p', { className: 'message', hidden: true, ...english });
  readonly #poster = make('div', { className: 'poster' });
  readonly #posterImage = make('img', { alt: '', hidden: true });
  readonly #progress = make('div', { className: 'progress' });
  readonly #bar = make('div', { className: 'bar' });
  readonly #hint = make('div', { className: 'hint', ...english });
  readonly #instructions = make('p', { className: 'unseen', id: 'instructions', ...english });
  readonly #announcement = make('p', { className: 'unseen', ...english });
  #hintTimer = 0;
  #failure: string | undefined;
  #isContextLost = false;

  constructor(host: HTMLElement) {
    this.#root = host.shadowRoot ?? host.attachShadow({ mode: 'open', delegatesFocus: true });
    this.applyStyle();

    // Attributes, since browsers have these as properties only of late.
    this.#hint.setAttribute('role', 'status');
    this.#announcement.setAttribute('role', 'status');
    this.#message.setAttribute('role', 'alert');
    this.canvas.setAttribute('aria-describedby', 'instructions');
    this.#poster.append(make('slot', { name: 'poster' }, this.#posterImage));
    this.#bar.setAttribute('role', 'progressbar');
    this.#bar.setAttribute('aria-label', 'Progress');
    this.#progress.append(make('slot', { name: 'progress-bar' }, this.#bar));
    const parts = {
      canvas: this.canvas,
      aim: this.#aim,
      poster: this.#poster,
      'progress-bar': this.#progress,
      message: this.#message,
      hint: this.#hint,
    };
    for (const [name, part] of Object.entries(parts)) part.setAttribute('part', name);
    this.#root.replaceChildren(...Object.values(parts), this.#instructions, this.#announcement);
  }

  /** Style sheets stay with the document that they were made in, so each document needs its own. */
  applyStyle(): void {
    const { defaultView } = this.#root.ownerDocument;
    if (!defaultView) return; // a document that is not shown
    const sheet = new defaultView.CSSStyleSheet();
    sheet.replaceSync(style + legendStyle);
    this.#root.adoptedStyleSheets = [sheet];
  }

  /** Describes the canvas to assistive technology; without instructions, nothing can be done there. */
  describe(label: string, instructions: string): void {
    this.canvas.setAttribute('aria-label', label);
    this.canvas.setAttribute('role', instructions ? 'application' : 'img');
    this.#instructions.textContent = instructions;
    if (instructions) this.canvas.tabIndex = 0;
    else this.canvas.removeAttribute('tabindex');
  }

  get failure(): string | undefined {
    return this.#failure;
  }

  /** Why there is no view, no model or no diagram, as a sentence on the view; undefined once there is. */
  set failure(sentence: string | undefined) {
    this.#failure = sentence;
    this.#showMessage();
  }

  /** While the context is lost, the view says this alone. */
  set isContextLost(isLost: boolean) {
    this.#isContextLost = isLost;
    this.#showMessage();
  }

  #showMessage(): void {
    const sentence = this.#isContextLost ? contextLost : this.#failure;
    this.#message.hidden = sentence === undefined;
    this.#message.textContent = sentence ?? '';
  }

  /** The address of the picture in the poster's slot; empty for none. */
  set poster(address: string) {
    this.#posterImage.hidden = address === '';
    if (address) this.#posterImage.src = address;
    else this.#posterImage.removeAttribute('src');
  }

  get showsPoster(): boolean {
    return !this.#poster.hidden;
  }

  set showsPoster(shows: boolean) {
    this.#poster.hidden = !shows;
  }

  /** 0 … 1; undefined if nothing is under way. */
  set progress(share: number | undefined) {
    this.#progress.classList.toggle('busy', share !== undefined);
    this.#progress.style.setProperty('--share', String(share ?? 0));
    this.#bar.setAttribute('aria-valuenow', String(Math.round(100 * (share ?? 0))));
  }

  hint(sentence: string): void {
    this.#hint.textContent = sentence;
    this.#hint.classList.add('shown');
    clearTimeout(this.#hintTimer);
    this.#hintTimer = window.setTimeout(
      () => this.#hint.classList.remove('shown'),
      hintMilliseconds,
    );
  }

  /** Has screen readers say a sentence. */
  announce(sentence: string): void {
    this.#announcement.textContent = sentence;
  }

  dispose(): void {
    clearTimeout(this.#hintTimer);
    this.#root.replaceChildren();
  }
}
