// SPDX-License-Identifier: MIT
//
// The one WebGL context of a page.

import {
  type Camera,
  type Material,
  type Object3D,
  type Scene,
  Vector2,
  type WebGLProgram,
  WebGLRenderer,
} from 'three';
import { nextFrame } from './next_frame.js';
import type { DrawnPixels } from './picture_file.js';

/** Thrown where nothing can be drawn. */
export class NoWebGlError extends Error {
  constructor(cause: unknown) {
    const sentence =
      'This view needs WebGL 2, which this browser does not offer; ' +
      'its settings may have it turned off, with graphics acceleration.';
    super(sentence, { cause });
  }
}

/** Told when the graphics card drops the renderer's context, and when it is there again. */
export interface ContextListener {
  contextLost(): void;
  contextRestored(): void;
}

/** A picture to draw; its size is in CSS pixels, `pixelRatio` in device pixels per CSS pixel. */
export interface Picture {
  scene: Scene;
  camera: Camera;
  width: number;
  height: number;
  pixelRatio: number;
}

/** A part of three.js that its types leave out. */
type CompiledProgram = WebGLProgram & { isReady(): boolean };

/** The bytes of a picture that are read between two frames. */
const bytesPerFrame = 2 ** 22;

let present: SharedRenderer | undefined;

/**
 * The one renderer of all elements of a page: browsers keep few WebGL contexts alive, and each
 * would compile the same shaders. It draws on a hidden canvas, which is copied at once. The first
 * user creates the context, and the last one frees it.
 */
export class SharedRenderer {
  readonly #renderer: WebGLRenderer;
  readonly #size = new Vector2();
  readonly #users = new Set<ContextListener>();

  /** The renderer, until the signal ends its use. Throws a `NoWebGlError` if there can be none. */
  static take(user: ContextListener, signal: AbortSignal): SharedRenderer {
    const renderer = (present ??= new SharedRenderer());
    renderer.#users.add(user);
    signal.addEventListener('abort', () => renderer.#release(user));
    return renderer;
  }

  private constructor() {
    const canvas = document.createElement('canvas');
    canvas.addEventListener('webglcontextlost', () => {
      for (const user of this.#users) user.contextLost();
    });
    canvas.addEventListener('webglcontextrestored', () => {
      for (const user of this.#users) user.contextRestored();
    });
    try {
      this.#renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    } catch (error) {
      throw new NoWebGlError(error);
    }
    this.#renderer.setClearAlpha(0);
  }

  /** The largest width and height of what is drawn. */
  get largestSize(): number {
    return this.#renderer.capabilities.maxTextureSize;
  }

  /** Draws onto a canvas, which takes the picture's size. */
  draw(picture: Picture, target: CanvasRenderingContext2D): void {
    // Without a graphics card, the last picture stays visible.
    if (!this.#render(picture)) return;
    const source = this.#renderer.domElement;
    const { canvas } = target;
    if (canvas.width !== source.width || canvas.height !== source.height) {
      canvas.width = source.width;
      canvas.height = source.height;
    }
    target.globalCompositeOperation = 'copy';
    target.drawImage(source, 0, 0);
  }

  /**
   * Draws a picture out of sight and reads it when the graphics card is done. Reading it at once,
   * as a canvas does for its files, would block the page.
   */
  async read(picture: Picture): Promise<DrawnPixels> {
    if (!this.#render(picture)) throw this.#dropped();
    const gl = this.#renderer.getContext() as WebGL2RenderingContext;
    const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
    const pixels = new Uint8ClampedArray(4 * width * height);
    const buffer = gl.createBuffer();
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    gl.bufferData(gl.PIXEL_PACK_BUFFER, pixels.length, gl.STREAM_READ);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, 0);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    const drawn = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0) as WebGLSync;
    gl.flush();
    do await nextFrame();
    while (!gl.isContextLost() && gl.clientWaitSync(drawn, 0, 0) === gl.TIMEOUT_EXPIRED);
    for (let from = 0; from < pixels.length; from += bytesPerFrame) {
      if (from > 0) await nextFrame();
      gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
      gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, from, pixels.subarray(from, from + bytesPerFrame));
      gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    }
    gl.deleteSync(drawn);
    gl.deleteBuffer(buffer);
    if (gl.isContextLost()) throw this.#dropped();
    return { width, height, pixels };
  }

  /** Resolves when an object's shaders are compiled: its first drawing would wait for them. */
  async compile(object: Object3D, scene: Scene, camera: Camera): Promise<void> {
    const { properties } = this.#renderer;
    const isCompiled = (material: Material) => {
      const { currentProgram } = properties.get(material) as { currentProgram?: CompiledProgram };
      return currentProgram?.isReady() ?? true; // whoever has disposed of it waits for nothing
    };
    const materials = [...this.#renderer.compile(object, camera, scene)];
    while (!materials.every(isCompiled)) await nextFrame();
  }

  /** Draws onto the renderer's own canvas; returns whether there is a graphics card to do it. */
  #render({ scene, camera, width, height, pixelRatio }: Picture): boolean {
    const renderer = this.#renderer;
    if (renderer.getContext().isContextLost()) return false;
    if (renderer.getPixelRatio() !== pixelRatio) renderer.setPixelRatio(pixelRatio);
    if (!renderer.getSize(this.#size).equals({ x: width, y: height })) {
      renderer.setSize(width, height, false);
    }
    renderer.render(scene, camera);
    return true;
  }

  #release(user: ContextListener): void {
    this.#users.delete(user);
    if (this.#users.size > 0) return;
    present = undefined;
    this.#renderer.dispose();
    // Not left to garbage collection, in which browsers free contexts late. A lost one cannot be lost again.
    if (!this.#renderer.getContext().isContextLost()) this.#renderer.forceContextLoss();
  }

  /** Why there are no pixels: without users, the renderer has freed its context itself. */
  #dropped(): Error {
    const isUsed = this.#users.size > 0;
    return new Error(
      isUsed ? 'The graphics card has dropped this view.' : 'The element has left its document.',
    );
  }
}
