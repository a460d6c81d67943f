// SPDX-License-Identifier: MIT
//
// The scene and its camera.

import {
  DirectionalLight,
  HemisphereLight,
  type Mesh,
  type Object3D,
  PerspectiveCamera,
  Quaternion,
  Scene,
  Spherical,
  Vector2,
  Vector3,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { CameraOrbit } from './camera_orbit.js';
import { type Framing, framingOf } from './framing.js';
import type { DrawnPixels } from './picture_file.js';
import type { Picture, SharedRenderer } from './shared_renderer.js';
import type { Padding } from './view_padding.js';

const fieldOfView = 32;
/** Room around a framed model, as a share of the view within its padding. */
const margin = 0.12;
/** The least share of the view that a model gets, however much padding there is. */
const leastShare = 0.25;
/** The direction from which a framed model is seen, if y points up. */
const firstDirection = new Vector3(0.45, 0.4, 1).normalize();

/** The axis of the model that points up on the screen. */
export type UpAxis = 'x' | 'y' | 'z';
const axes: Readonly<Record<UpAxis, Vector3>> = {
  x: new Vector3(1, 0, 0),
  y: new Vector3(0, 1, 0),
  z: new Vector3(0, 0, 1),
};

/**
 * The scene with its camera, lights and controls on one canvas. It draws only when something
 * changed and is in view. Its content lies within the unit sphere (`ModelFrame`), or within
 * `reach`.
 */
export class Stage {
  readonly camera = new PerspectiveCamera(fieldOfView, 1, 0.01, 10);
  readonly canvas: HTMLCanvasElement;
  readonly #renderer: SharedRenderer;
  readonly #picture: CanvasRenderingContext2D;
  readonly #scene = new Scene();
  readonly #cameraMoved: () => void;
  /** The rotation from a scene whose y axis points up to this one. */
  readonly #upright = new Quaternion();
  #controls: OrbitControls;
  /** The view's size in CSS pixels. */
  #size = { width: 0, height: 0 };
  #padding: Padding = { top: 0, right: 0, bottom: 0, left: 0 };
  /** The points that were framed last. */
  #points: Float32Array = new Float32Array();
  /** Whether the camera stands as `frame` left it. */
  #isFramed = false;
  #reach = 1;
  #isApproaching = false;
  #drawing = 0;
  /** The distance from which these points fill the view. */
  #framingDistance = 3;
  #isInView = true;
  #isOutdated = false;

  constructor(canvas: HTMLCanvasElement, renderer: SharedRenderer, cameraMoved: () => void) {
    this.canvas = canvas;
    this.#renderer = renderer;
    this.#cameraMoved = cameraMoved;
    this.#picture = canvas.getContext('2d') as CanvasRenderingContext2D;
    this.#scene.add(this.camera);
    this.#addLights();
    this.camera.position.copy(firstDirection); // so that no other place is told of before a model is framed
    this.#controls = this.#newControls();
  }

  /** Turns the scene so that this axis points up, and frames it anew. */
  set up(axis: UpAxis) {
    if (this.camera.up.equals(axes[axis])) return;
    this.camera.up.copy(axes[axis]);
    this.#upright.setFromUnitVectors(axes.y, axes[axis]);
    // Controls take over the camera's upward direction only when they are made.
    this.#controls.dispose();
    this.#controls = this.#newControls();
    this.frame(this.#points);
  }

  /** The radius around the origin that the content takes. What is framed stays so. */
  set reach(reach: number) {
    if (reach === this.#reach) return;
    this.#reach = reach;
    if (this.#isFramed) this.frame(this.#points);
  }

  /** Out of view nothing is drawn, and the scene's memory on the graphics card is freed. */
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
      // While the controls glide they change the camera, which calls for the next drawing.
      this.#controls.update();
      this.draw();
    });
  }

  draw(): void {
    this.#isOutdated = false;
    if (this.#size.width > 0) this.#renderer.draw(this.#view(1), this.#picture);
  }

  /** Resolves when an object's shaders are compiled, so that it can be drawn at once. */
  compile(object: Object3D): Promise<void> {
    return this.#renderer.compile(object, this.#scene, this.camera);
  }

  /** The pixels of the present view, `scale` times as large as it is shown. */
  async read(scale: number): Promise<DrawnPixels> {
    if (!(scale > 0)) throw new RangeError(`scale is ${scale}, not a number above 0.`);
    if (this.#size.width === 0) throw new Error('The view has no size.');
    try {
      return await this.#renderer.read(this.#view(scale));
    } finally {
      // Brings the renderer back to the size that is shown.
      this.invalidate();
    }
  }

  /**
   * Sets the size in CSS pixels. Draws at once, or the canvas would stretch its old content. A
   * framed model stays framed, and the camera's target is in the middle of what the padding leaves.
   */
  resize(width: number, height: number, padding: Padding): void {
    if (width === 0 || height === 0) return;
    this.#size = { width, height };
    this.#padding = padding;
    this.camera.aspect = width / height;
    const right = (padding.right - padding.left) / 2;
    const down = (padding.bottom - padding.top) / 2;
    // This call updates the projection, too.
    this.camera.setViewOffset(width, height, right, down, width, height);
    if (this.#isFramed) this.frame(this.#points);
    else this.#framingDistance = this.#framing().distance;
    this.draw();
  }

  add(object: Object3D): void {
    this.#scene.add(object);
    this.invalidate();
  }

  remove(object: Object3D): void {
    this.#scene.remove(object);
    this.invalidate();
  }

  /**
   * Looks from the first direction at the middle of these points (x, y, z triples), `reach` times as
   * far, so that all of them just fit.
   */
  frame(points: Float32Array): void {
    this.#points = points;
    const { target, distance } = this.#framing();
    this.#framingDistance = distance;
    this.#stopGliding();
    this.#controls.target.copy(target).multiplyScalar(this.#reach);
    this.camera.position
      .copy(this.#firstDirection)
      .multiplyScalar(this.#reach * distance)
      .add(this.#controls.target);
    this.#controls.update();
    this.#isFramed = true;
    this.invalidate();
  }

  get #firstDirection(): Vector3 {
    return firstDirection.clone().applyQuaternion(this.#upright);
  }

  /** Where the points to be framed fill what the padding leaves of the view, but for a margin. */
  #framing(): Framing {
    const back = this.#firstDirection;
    const right = this.camera.up.clone().cross(back).normalize();
    const { width, height } = this.#size;
    const padding = this.#padding;
    const share = (free: number, whole: number) =>
      (1 - margin) * (whole > 0 ? Math.max(leastShare, free / whole) : 1);
    const half = Math.tan((fieldOfView * Math.PI) / 360);
    const h = half * this.camera.aspect * share(width - padding.left - padding.right, width);
    const v = half * share(height - padding.top - padding.bottom, height);
    return framingOf(this.#points, { right, up: back.clone().cross(right), back }, h, v);
  }

  /**
   * Turns the camera to look against a direction of the scene, as far from its target as before.
   */
  lookAgainst(direction: Vector3): void {
    const { target } = this.#controls;
    const distance = this.camera.position.distanceTo(target);
    this.#stopGliding();
    this.camera.position.copy(direction).setLength(distance).add(target);
    this.#controls.update();
    this.invalidate();
  }

  /** The camera's place around its target. */
  get cameraOrbit(): CameraOrbit {
    const { theta, phi, radius } = this.#placeAround();
    const target = this.#controls.target.toArray();
    return { theta, phi, radius: radius / this.#framingDistance, target };
  }

  set cameraOrbit({ theta, phi, radius, target }: CameraOrbit) {
    this.#stopGliding();
    this.#controls.target.fromArray(target);
    this.#placeAt(new Spherical(radius * this.#framingDistance, phi, theta));
  }

  /** Turns the camera around what it looks at, in radians. */
  orbit(right: number, up: number): void {
    const place = this.#placeAround();
    place.theta += right;
    place.phi -= up;
    this.#placeAt(place);
  }

  /**
   * Until the gesture that begins here ends, zooming is by shares of the distance to this place: it
   * comes ever nearer, and does not go through the surface on its way to the model's middle.
   */
  approach(place: Vector3): void {
    this.#isApproaching = true;
    this.#lookAsFarAs(place);
  }

  /** The camera turns around the model's middle again, but nearer to the surface, around that. */
  #endApproach(): void {
    if (!this.#isApproaching) return;
    this.#isApproaching = false;
    const middle = new Vector3();
    const depth = this.#depthOf(this.#controls.target);
    const depthOfMiddle = this.#depthOf(middle);
    if (depthOfMiddle > depth && depthOfMiddle < 2 * depth) this.#lookAsFarAs(middle);
    this.#cameraMoved();
  }

  /** Looks in the same direction, at a point as deep in the view as this place. */
  #lookAsFarAs(place: Vector3): void {
    const ahead = this.camera.getWorldDirection(new Vector3());
    this.#controls.target.copy(this.camera.position).addScaledVector(ahead, this.#depthOf(place));
  }

  #depthOf(place: Vector3): number {
    return place
      .clone()
      .sub(this.camera.position)
      .dot(this.camera.getWorldDirection(new Vector3()));
  }

  /** Changes the distance to what the camera looks at, or to what it approaches, by a factor. */
  dolly(factor: number): void {
    const { target } = this.#controls;
    this.camera.position.sub(target).multiplyScalar(factor).add(target);
    this.#endApproach();
    this.#controls.update();
    this.invalidate();
  }

  /** Device coordinates of what the camera looks at: the middle of what the padding leaves. */
  get middle(): Vector2 {
    const { x, y } = this.#controls.target.clone().project(this.camera);
    return new Vector2(x, y);
  }

  /** Device coordinates (-1 … 1) of a place on the page. */
  toDevice(clientX: number, clientY: number): Vector2 {
    const box = this.canvas.getBoundingClientRect();
    return new Vector2(
      (2 * (clientX - box.left)) / box.width - 1,
      1 - (2 * (clientY - box.top)) / box.height,
    );
  }

  /**
   * A function that maps points of the scene to places on the page, undefined for points behind the
   * camera. It holds while the camera stands still.
   */
  projection(): (point: Vector3) => { x: number; y: number } | undefined {
    this.camera.updateMatrixWorld();
    const box = this.canvas.getBoundingClientRect();
    const device = new Vector3();
    return (point) => {
      device.copy(point).project(this.camera);
      if (device.z > 1) return undefined;
      return {
        x: box.left + ((device.x + 1) * box.width) / 2,
        y: box.top + ((1 - device.y) * box.height) / 2,
      };
    };
  }

  dispose(): void {
    cancelAnimationFrame(this.#drawing);
    this.#controls.dispose();
  }

  /** The camera's place around its target, as if y pointed up. */
  #placeAround(): Spherical {
    const back = this.camera.position.clone().sub(this.#controls.target);
    return new Spherical().setFromVector3(back.applyQuaternion(this.#upright.clone().invert()));
  }

  #placeAt(place: Spherical): void {
    this.camera.position
      .setFromSpherical(place.makeSafe())
      .applyQuaternion(this.#upright)
      .add(this.#controls.target);
    this.#controls.update();
    this.invalidate();
  }

  #newControls(): OrbitControls {
    const controls = new OrbitControls(this.camera, this.canvas);
    controls.enableDamping = !matchMedia('(prefers-reduced-motion: reduce)').matches;
    controls.dampingFactor = 0.2;
    controls.zoomToCursor = true;
    controls.minDistance = 0.02;
    controls.maxDistance = 40;
    controls.addEventListener('change', () => {
      this.#isFramed = false;
      this.camera.updateMatrixWorld();
      this.#cameraMoved();
      this.invalidate();
    });
    controls.addEventListener('end', () => this.#endApproach());
    return controls;
  }

  /** Stops the movement that the controls still continue after a gesture. */
  #stopGliding(): void {
    const { enableDamping } = this.#controls;
    this.#controls.enableDamping = false;
    this.#controls.update();
    this.#controls.enableDamping = enableDamping;
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
    this.camera.add(key, key.target, rim, rim.target);
    this.#scene.add(sky);
  }

  /** The view, `scale` times as large as it is shown. */
  #view(scale: number): Picture {
    this.#fitDepthRange();
    const { width, height } = this.#size;
    const largest = this.#renderer.largestSize / Math.max(width, height);
    return {
      scene: this.#scene,
      camera: this.camera,
      width,
      height,
      pixelRatio: Math.min(scale * Math.min(devicePixelRatio, 2), largest),
    };
  }

  /** Fits the depth range tightly around the content: depth has to tell lines from the surface. */
  #fitDepthRange(): void {
    const distance = this.#depthOf(new Vector3());
    const radius = 1.01 * this.#reach;
    this.camera.far = Math.max(distance, 0) + radius;
    this.camera.near = Math.max(distance - radius, 0.002);
    this.camera.updateProjectionMatrix();
  }
}
