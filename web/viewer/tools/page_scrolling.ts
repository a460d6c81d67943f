// SPDX-License-Identifier: MIT
//
// Decides whether the wheel and swipes over the view scroll the page or move the camera.

/**
 * A view that takes this share of the window in both directions leaves no page to scroll beside it.
 */
const aloneShare = 0.95;

/**
 * Decides who gets the wheel and swipes over the canvas: the page, which scrolls, until the canvas
 * has been clicked or focused; the camera from then on, and where there is nothing to scroll. Two
 * fingers, and the wheel with Ctrl, are always the camera's.
 */
export class PageScrolling {
  readonly #canvas: HTMLCanvasElement;
  readonly #touchAction: () => string | undefined;

  /**
   * Must be made before the camera's controls; ends with the signal. `touchAction` returns the choice of
   * the page's author, if any, which no click or tap changes; `hint` gets a sentence on how to reach the
   * camera when the page has scrolled instead.
   */
  constructor(
    canvas: HTMLCanvasElement,
    touchAction: () => string | undefined,
    hint: (sentence: string) => void,
    signal: AbortSignal,
  ) {
    this.#canvas = canvas;
    this.#touchAction = touchAction;
    const listen = <Type extends keyof HTMLElementEventMap>(
      type: Type,
      listener: (event: HTMLElementEventMap[Type]) => void,
      options?: AddEventListenerOptions,
    ) => canvas.addEventListener(type, listener, { signal, ...options });
    listen(
      'wheel',
      (event) => {
        if (event.ctrlKey || this.#isOfCamera) return;
        event.stopImmediatePropagation();
        const isForGood = touchAction() !== undefined;
        hint(`${isForGood ? 'Hold Ctrl and' : 'Click the model, then'} scroll to zoom`);
      },
      { capture: true, passive: true },
    );
    listen(
      'touchmove',
      (event) => {
        if (event.touches.length > 1 && event.cancelable) event.preventDefault();
      },
      { passive: false },
    );
    listen('pointercancel', ({ pointerType }) => {
      const isForGood = touchAction() !== undefined;
      if (pointerType === 'touch')
        hint(isForGood ? 'Use two fingers' : 'Tap the model, or use two fingers');
    });
    listen('focus', () => this.update());
    listen('blur', () => this.update());
    listen('pointerenter', () => this.update());
    this.update();
  }

  /** Decides anew whether swipes scroll the page: the browser has to know before one begins. */
  update(): void {
    const action = this.#isOfCamera ? 'none' : (this.#touchAction() ?? 'pan-y');
    this.#canvas.style.setProperty('--own-touch-action', action);
  }

  get #isOfCamera(): boolean {
    const wanted = this.#touchAction();
    if (wanted !== undefined) return wanted === 'none';
    const { activeElement } = this.#canvas.getRootNode() as ShadowRoot;
    return activeElement === this.#canvas || this.#isAlone || !isInScroller(this.#canvas);
  }

  get #isAlone(): boolean {
    const { width, height } = this.#canvas.getBoundingClientRect();
    return width >= aloneShare * innerWidth && height >= aloneShare * innerHeight;
  }
}

/** Whether anything around the element has more than it shows, and scrolls. */
function isInScroller(element: Element): boolean {
  const page = document.scrollingElement;
  for (let around = parentOf(element); around; around = parentOf(around)) {
    if (around.scrollHeight <= around.clientHeight + 1) continue;
    const { overflowY } = getComputedStyle(around);
    const scrolls = overflowY === 'auto' || overflowY === 'scroll';
    if (scrolls || (around === page && overflowY === 'visible')) return true;
  }
  return false;
}

/** The parent, or the element whose shadow this is. */
function parentOf(element: Element): Element | undefined {
  return element.parentElement ?? (element.getRootNode() as Partial<ShadowRoot>).host;
}
