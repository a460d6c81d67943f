// SPDX-License-Identifier: MIT
//
// Tells clicks, drags and long presses apart.

import { pointerReach, type SurfaceTools } from './surface_tools.js';

/** A press that moves farther than this, in CSS pixels, is a drag and never a click. */
const clickRadius = 4;
const longPressMilliseconds = 600;

interface Press {
  event: PointerEvent;
  /** The thing that is dragged; undefined for the camera. */
  site: number | 'brush' | undefined;
  moved: boolean;
}

/**
 * Clicks, drags of sites, strokes of a brush and hovering on a canvas. Presses on a site or with
 * the brush are kept from the camera's controls. Others are left to them, and only watched to tell
 * clicks from turns of the model.
 */
export class PointerGestures {
  readonly #canvas: HTMLCanvasElement;
  readonly #tools: SurfaceTools;
  #press: Press | undefined;
  #longPress = 0;
  #isHandingOver = false;

  /** Must be made before the camera's controls, or these see a press on a site first. Ends with the signal. */
  constructor(canvas: HTMLCanvasElement, tools: SurfaceTools, signal: AbortSignal) {
    this.#canvas = canvas;
    this.#tools = tools;
    const listen = (type: string, listener: (event: PointerEvent) => void, capture = false) =>
      canvas.addEventListener(type, listener as EventListener, { signal, capture });
    listen('pointerdown', (event) => this.#down(event), true);
    listen('pointermove', (event) => this.#moveTo(event));
    listen('pointerup', (event) => this.#up(event));
    listen('pointercancel', () => this.cancel());
    // A lifted finger also "leaves", but the reader still wants to see what it pointed at.
    listen('pointerleave', ({ pointerType }) => pointerType !== 'touch' && this.#tools.leave());
    listen('wheel', ({ clientX, clientY }) => this.#tools.approach(clientX, clientY));
    listen('contextmenu', (event) => event.preventDefault());
  }

  /** Whether a site is dragged or a stroke painted, of which a press is the first dab. */
  get dragging(): boolean {
    const { site, moved } = this.#press ?? {};
    return site === 'brush' || (site !== undefined && moved === true);
  }

  /** Forgets the press; a site that was dragged returns, and what a stroke has painted goes. */
  cancel(): void {
    if (this.#press?.site === 'brush') this.#tools.cancelStroke();
    else if (this.dragging) this.#tools.cancelMove();
    this.#end();
  }

  #down(event: PointerEvent): void {
    if (this.#isHandingOver) return;
    if (this.#press) {
      // A second finger turns a click or a drag of a site into a gesture of the camera.
      const { site, event: first } = this.#press;
      this.cancel();
      if (site !== undefined) this.#handOver(first);
      const x = (first.clientX + event.clientX) / 2;
      this.#tools.approach(x, (first.clientY + event.clientY) / 2);
      return;
    }
    // One more finger beside one that stays on the view, as when a pinch is taken up again.
    if (!event.isPrimary) return;
    const { clientX: x, clientY: y } = event;
    const site = isPlain(event) ? this.#grasped(x, y, reachOf(event)) : undefined;
    this.#press = { event, site, moved: false };
    if (event.pointerType === 'touch') this.#tools.hover(x, y);
    if (site === undefined) return;

    event.stopImmediatePropagation();
    // Not as by keys: no frame and no mark at the centre.
    this.#canvas.focus({ preventScroll: true, focusVisible: false } as FocusOptions);
    this.#canvas.setPointerCapture(event.pointerId);
    if (site === 'brush') return;
    if (event.pointerType !== 'mouse') {
      this.#longPress = window.setTimeout(() => {
        this.#end();
        this.#tools.remove(site);
      }, longPressMilliseconds);
    }
  }

  /** Passes on to the camera's controls a press that was kept from them. */
  #handOver(press: PointerEvent): void {
    this.#isHandingOver = true;
    this.#canvas.dispatchEvent(new PointerEvent('pointerdown', press));
    this.#isHandingOver = false;
  }

  #grasped(x: number, y: number, reach: number): number | 'brush' | undefined {
    return this.#tools.beginStroke(x, y) ? 'brush' : this.#tools.siteAt(x, y, reach);
  }

  #moveTo(event: PointerEvent): void {
    const { clientX: x, clientY: y } = event;
    const press = this.#press;
    if (!press) {
      this.#tools.hover(x, y);
      return;
    }
    const { pointerId, clientX, clientY } = press.event;
    if (event.pointerId !== pointerId) return;
    if (!press.moved && Math.hypot(x - clientX, y - clientY) <= clickRadius) return;
    // Not before: a second finger makes a pinch of the press.
    if (!press.moved && typeof press.site === 'number') this.#tools.select(press.site);
    press.moved = true;
    clearTimeout(this.#longPress);
    if (press.site === 'brush') this.#tools.stroke(x, y);
    else if (press.site !== undefined) this.#tools.move(press.site, x, y);
    else this.#tools.hover(x, y);
  }

  #up(event: PointerEvent): void {
    const press = this.#press;
    if (!press || event.pointerId !== press.event.pointerId) return;
    if (press.site === 'brush') this.#tools.endStroke();
    else if (press.site !== undefined && press.moved) this.#tools.endMove();
    else if (press.site !== undefined) this.#tools.select(press.site);
    this.#end();
    if (press.moved || press.site !== undefined) return;
    const { clientX: x, clientY: y } = event;
    if (isPlain(event)) {
      this.#tools.click(x, y);
    } else if (event.button === 2) {
      const site = this.#tools.siteAt(x, y, reachOf(event));
      if (site !== undefined) this.#tools.remove(site);
    }
  }

  #end(): void {
    clearTimeout(this.#longPress);
    this.#press = undefined;
  }
}

/** With a modifier or another button the camera's controls pan. */
function isPlain({ button, ctrlKey, metaKey, shiftKey }: PointerEvent): boolean {
  return button === 0 && !ctrlKey && !metaKey && !shiftKey;
}

function reachOf({ pointerType }: PointerEvent): number {
  return pointerType === 'touch' ? 22 : pointerReach;
}
