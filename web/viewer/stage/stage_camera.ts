// SPDX-License-Identifier: MIT
//
// The camera of a stage: where it stands around its target, and what moves it.

import { PerspectiveCamera, Quaternion, Spherical, Vector2, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { CameraOrbit } from './camera_orbit.js';
import { type Framing, framingOf } from './framing.js';
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

export class StageCamera {
  readonly object = new PerspectiveCamera(fieldOfView, 1, 0.01, 10);
  readonly #canvas: HTMLCanvasElement;
  readonly #moved: () => void;
  readonly #redraw: () => void;
  /** The rotation from a scene whose y axis points up to this one. */
  readonly #upright = new Quaternion();
  #controls: OrbitControls;
  /** The view's size in CSS pixels. */
  #size = { width: 0, height: 0 };
  #padding: Padding = { top: 0, right: 0, bottom: 0, left: 0 };
  /** The points that were framed last. */
  #points: Float32Array = new Float32Array();
  /** The distance from which these points fill the view. */
  #framingDistance = 3;
  /** Whether the camera stands as `frame` left it. */
  #isFramed = false;
  #reach = 1;
  #isApproaching = false;

  /** `moved` is told of other places of the camera, `redraw` that the view has to be drawn anew. */
  constructor(canvas: HTMLCanvasElement, moved: () => void, redraw: () => void) {
    this.#canvas = canvas;
    this.#moved = moved;
    this.#redraw = redraw;
    this.object.position.copy(firstDirection); // so that no other place is told of before a model is framed
    this.#controls = this.#newControls();
  }

  get size(): { width: number; height: number } {
    return this.#size;
  }

  /** Turns the scene so that this axis points up, and frames it anew. */
  set up(axis: UpAxis) {
    if (this.object.up.equals(axes[axis])) return;
    this.object.up.copy(axes[axis]);
    this.#upright.setFromUnitVectors(axes.y, axes[axis]);
    // Controls take over the camera's upward direction only when they are made.
    this.#controls.dispose();
    this.#controls = this.#newControls();
    this.frame(this.#points);
  }

  /** The radius around the origin that the content takes. As much of it stays in view, wherever the camera is. */
  set reach(reach: number) {
    if (reach === this.#reach) return;
    const { orbit } = this;
    const isFramed = this.#isFramed;
    this.#reach = reach;
    this.orbit = orbit;
    this.#isFramed = isFramed;
  }

  /**
   * Sets the view's size in CSS pixels. A framed model stays framed, any other orbit the same share of the
   * distance from which the model fills the view; the target is in the middle of what the padding leaves.
   */
  resize(width: number, height: number, padding: Padding): void {
    this.#size = { width, height };
    this.#padding = padding;
    this.object.aspect = width / height;
    const right = (padding.right - padding.left) / 2;
    const down = (padding.bottom - padding.top) / 2;
    // This call updates the projection, too.
    this.object.setViewOffset(width, height, right, down, width, height);
    if (this.#isFramed) {
      this.frame(this.#points);
    } else {
      const { orbit } = this;
      this.#framingDistance = this.#framing().distance;
      this.orbit = orbit;
    }
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
    this.#standAt(this.#firstDirection.multiplyScalar(this.#reach * distance));
    this.#isFramed = true;
  }

  get #firstDirection(): Vector3 {
    return firstDirection.clone().applyQuaternion(this.#upright);
  }

  /** Where the points to be framed fill what the padding leaves of the view, but for a margin. */
  #framing(): Framing {
    const back = this.#firstDirection;
    const right = this.object.up.clone().cross(back).normalize();
    const { width, height } = this.#size;
    const padding = this.#padding;
    const share = (free: number, whole: number) =>
      (1 - margin) * (whole > 0 ? Math.max(leastShare, free / whole) : 1);
    const half = Math.tan((fieldOfView * Math.PI) / 360);
    const h = half * this.object.aspect * share(width - padding.left - padding.right, width);
    const v = half * share(height - padding.top - padding.bottom, height);
    return framingOf(this.#points, { right, up: back.clone().cross(right), back }, h, v);
  }

  /** Turns to look against a direction of the scene, as far from the target as before. */
  lookAgainst(direction: Vector3): void {
    const distance = this.#back.length();
    this.#stopGliding();
    this.#standAt(direction.clone().setLength(distance));
  }

  /** The camera's place around its target, as if the content did not reach beyond the unit sphere. */
  get orbit(): CameraOrbit {
    const { theta, phi, radius } = this.#placeAround();
    const target = this.#controls.target.clone().divideScalar(this.#reach).toArray();
    return { theta, phi, radius: radius / (this.#reach * this.#framingDistance), target };
  }

  set orbit({ theta, phi, radius, target }: CameraOrbit) {
    this.#stopGliding();
    this.#controls.target.fromArray(target).multiplyScalar(this.#reach);
    this.#placeAt(new Spherical(radius * this.#reach * this.#framingDistance, phi, theta));
  }

  /** Turns around what the camera looks at, in radians. */
  turn(right: number, up: number): void {
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
    this.#moved();
  }

  /** Looks in the same direction, at a point as deep in the view as this place. */
  #lookAsFarAs(place: Vector3): void {
    const ahead = this.object.getWorldDirection(new Vector3());
    this.#controls.target.copy(this.object.position).addScaledVector(ahead, this.#depthOf(place));
  }

  #depthOf(place: Vector3): number {
    return place
      .clone()
      .sub(this.object.position)
      .dot(this.object.getWorldDirection(new Vector3()));
  }

  /** Changes the distance to what the camera looks at, or to what it approaches, by a factor. */
  dolly(factor: number): void {
    const back = this.#back.multiplyScalar(factor);
    this.object.position.copy(this.#controls.target).add(back);
    this.#endApproach();
    this.#controls.update();
    this.#redraw();
  }

  /** Device coordinates of what the camera looks at: the middle of what the padding leaves. */
  get middle(): Vector2 {
    const { x, y } = this.#controls.target.clone().project(this.object);
    return new Vector2(x, y);
  }

  /** Goes on with the movement that a gesture leaves behind; each step of it asks for a next drawing. */
  glide(): void {
    this.#controls.update();
  }

  /** Fits the depth range tightly around the content: depth has to tell lines from the surface. */
  fitDepthRange(): void {
    const distance = this.#depthOf(new Vector3());
    const radius = 1.01 * this.#reach;
    this.object.far = Math.max(distance, 0) + radius;
    this.object.near = Math.max(distance - radius, 0.002);
    this.object.updateProjectionMatrix();
  }

  dispose(): void {
    this.#controls.dispose();
  }

  /** From the target to the camera. */
  get #back(): Vector3 {
    return this.object.position.clone().sub(this.#controls.target);
  }

  /** The camera's place around its target, as if y pointed up. */
  #placeAround(): Spherical {
    return new Spherical().setFromVector3(
      this.#back.applyQuaternion(this.#upright.clone().invert()),
    );
  }

  #placeAt(place: Spherical): void {
    this.#standAt(new Vector3().setFromSpherical(place.makeSafe()).applyQuaternion(this.#upright));
  }

  /** Stands at this vector from the target. */
  #standAt(back: Vector3): void {
    this.object.position.copy(this.#controls.target).add(back);
    this.#controls.update();
    this.#redraw();
  }

  #newControls(): OrbitControls {
    const controls = new OrbitControls(this.object, this.#canvas);
    controls.enableDamping = !matchMedia('(prefers-reduced-motion: reduce)').matches;
    controls.dampingFactor = 0.2;
    controls.zoomToCursor = true;
    controls.minDistance = 0.02;
    controls.maxDistance = 40;
    controls.addEventListener('change', () => {
      this.#isFramed = false;
      this.object.updateMatrixWorld();
      this.#moved();
      this.#redraw();
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
}
