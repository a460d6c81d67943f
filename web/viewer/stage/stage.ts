// SPDX-License-Identifier: MIT
//
// The scene and its view.

import {
  DirectionalLight,
  HemisphereLight,
  type Mesh,
  type Object3D,
  Scene,
  Vector2,
  Vector3,
} from 'three';
import { StageCamera } from './stage_camera.js';
import type { DrawnPixels } from './picture_file.js';
import type { Picture, SharedRenderer } from './shared_renderer.js';
import { ViewOnPage } from './view_on_page.js';
import type { Padding } from './view_padding.js';

interface Point {
  x: number;
  y: number;
}

/** How many pixels per CSS pixel are drawn at most: more are hardly seen, and take as much longer. */
const mostPixelRatio = 2;

/**
 * The scene with its camera and lights on one canvas. It draws only when something changed and is in
 * view. Its content lies within the unit sphere (`ModelFrame`), or within the camera's `reach`.
 */
export class Stage {
  readonly canvas: HTMLCanvasElement;
  readonly camera: StageCamera;
  readonly #renderer: SharedRenderer;
  readonly #picture: CanvasRenderingContext2D;
  readonly #onPage: ViewOnPage;
  readonly #scene = new Scene();
  #drawing = 0;
  #isInView = true;
  #isOutdated = false;

  constructor(canvas: HTMLCanvasElement, renderer: SharedRenderer, cameraMoved: () => void) {
    this.canvas = canvas;
    this.#renderer = renderer;
    this.#onPage = new ViewOnPage(canvas);
    this.#picture = canvas.getContext('2d') as CanvasRenderingContext2D;
    this.camera = new StageCamera(canvas, cameraMoved, () => this.invalidate());
    this.#scene.add(this.camera.object);
    this.#addLights();
  }

  /** Out of view nothing is drawn, and the geometries on the graphics card are freed. */
  set inView(isInView: boolean) {
    if (isInView === this.#isInView) return;
    this.#isInView = isInView;
    if (!isInView) {
      this.#scene.traverse((object) => (object as Partial<Mesh>).geometry?.dispose());
    } else if (this.#isOutdated) {
      this.invalidate();
    }
  }

  /** Draws soon: once, however often it is called before. */
  invalidate(): void {
    if (!this.#isInView) {
      this.#isOutdated = true;
      return;
    }
    this.#drawing ||= requestAnimationFrame(() => {
      this.#drawing = 0;
      this.camera.glide();
      this.#draw();
    });
  }

  #draw(): void {
    this.#isOutdated = !this.#isInView;
    if (this.#isOutdated || this.camera.size.width === 0) return;
    const zoom = Math.max(1, this.#zoom());
    const pixelRatio = Math.min(zoom * devicePixelRatio, mostPixelRatio);
    this.#renderer.draw(this.#view(pixelRatio), this.#picture);
  }

  /** Resolves when an object's shaders are compiled, so that it can be drawn at once. */
  compile(object: Object3D): Promise<void> {
    return this.#renderer.compile(object, this.#scene, this.camera.object);
  }

  /** The pixels of the present view, `scale` times as large as it is shown. */
  async read(scale: number): Promise<DrawnPixels> {
    if (!(scale > 0)) throw new RangeError(`scale is ${scale}, not a number above 0.`);
    if (this.camera.size.width === 0) throw new Error('The view has no size.');
    try {
      const pixelRatio = scale * Math.min(devicePixelRatio, mostPixelRatio);
      return await this.#renderer.read(this.#view(pixelRatio));
    } finally {
      // Brings the renderer back to the size that is shown.
      this.invalidate();
    }
  }

  /** Sets the size in CSS pixels. Draws at once, or the canvas would stretch its old content. */
  resize(width: number, height: number, padding: Padding): void {
    if (width === 0 || height === 0) return;
    this.camera.resize(width, height, padding);
    this.#draw();
  }

  add(object: Object3D): void {
    this.#scene.add(object);
    this.invalidate();
  }

  remove(object: Object3D): void {
    this.#scene.remove(object);
    this.invalidate();
  }

  /** How many times as large as its CSS says the view is: slides and the like are scaled to fit. */
  #zoom(): number {
    const { width } = getComputedStyle(this.canvas);
    const { a, b } = this.toPage;
    return (2 * Math.hypot(a, b)) / Number.parseFloat(width);
  }

  /** From device coordinates (-1 … 1) to places on the page. */
  get toPage(): DOMMatrix {
    return this.#onPage.toPage;
  }

  /** From device coordinates to CSS pixels from the view's corner. */
  get toView(): DOMMatrix {
    const { width, height } = this.camera.size;
    return new DOMMatrix([width / 2, 0, 0, -height / 2, width / 2, height / 2]);
  }

  /** Device coordinates of a place on the page. */
  toDevice(clientX: number, clientY: number): Vector2 {
    const { x, y } = this.toPage.inverse().transformPoint({ x: clientX, y: clientY });
    return new Vector2(x, y);
  }

  /**
   * A function that maps points of the scene to where they are seen, by `toPage` or `toView`;
   * undefined for points behind the camera and for those that are not finite. It holds while the
   * camera stands still.
   */
  projection({ a, b, c, d, e, f }: DOMMatrix): (point: Vector3) => Point | undefined {
    const { object: camera } = this.camera;
    this.camera.fitDepthRange(); // or what is far away now would count as behind the camera
    camera.updateMatrixWorld();
    const device = new Vector3();
    return (point) => {
      const { x, y, z } = device.copy(point).project(camera);
      return z <= 1 ? { x: a * x + c * y + e, y: b * x + d * y + f } : undefined;
    };
  }

  dispose(): void {
    this.inView = false; // what is still under way may ask for one more drawing
    cancelAnimationFrame(this.#drawing);
    this.camera.dispose();
  }

  /** Lights move with the camera, so that the visible side is always well lit. */
  #addLights(): void {
    const sky = new HemisphereLight(0xffffff, 0xa9a49c, 1.45);
    const key = new DirectionalLight(0xffffff, 1.95);
    key.position.set(-0.6, 0.9, 0.8);
    key.target.position.set(0, 0, -1);
    const rim = new DirectionalLight(0xdfe8ff, 0.45);
    rim.position.set(0.9, -0.3, 0.2);
    rim.target.position.set(0, 0, -1);
    this.camera.object.add(key, key.target, rim, rim.target);
    this.#scene.add(sky);
  }

  /** The view, in so many pixels per CSS pixel as there can be. */
  #view(pixelRatio: number): Picture {
    this.camera.fitDepthRange();
    const { width, height } = this.camera.size;
    const largest = this.#renderer.largestSize / Math.max(width, height);
    return {
      scene: this.#scene,
      camera: this.camera.object,
      width,
      height,
      pixelRatio: Math.min(pixelRatio, largest),
    };
  }
}
