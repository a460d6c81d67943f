// SPDX-License-Identifier: MIT
//
// The camera's place as text: the attribute `camera-orbit`.

/** The camera's place around the model, as in `<model-viewer>`. */
export interface CameraOrbit {
  /** The angle around the upward axis, in radians; 0 is in front. */
  theta: number;
  /** The angle from the upward axis, in radians. */
  phi: number;
  /** The distance as a multiple of that from which the model fills the view. */
  radius: number;
  /** The point that the camera looks at, in radii of the model from its centre. */
  target: readonly number[];
}

/**
 * Parses text like `30deg 75deg 105%`; angles may be in `rad`, the distance `auto`. The target may
 * follow, like `0.1 0 0.25`. Undefined if the text has another form.
 */
export function parseCameraOrbit(text: string): CameraOrbit | undefined {
  const [theta, phi, radius, ...target] = text.trim().split(/\s+/);
  const orbit = {
    theta: angleOf(theta),
    phi: angleOf(phi),
    radius: radius === 'auto' || radius === undefined ? 1 : numberWith('%', radius) / 100,
    target: target.length > 0 ? target.map(Number) : [0, 0, 0],
  };
  const isOrbit = orbit.target.length === 3 && Object.values(orbit).flat().every(Number.isFinite);
  return isOrbit && orbit.radius > 0 ? orbit : undefined;
}

export function formatCameraOrbit({ theta, phi, radius, target }: CameraOrbit): string {
  const degrees = (angle: number) => `${Number(((180 * angle) / Math.PI).toFixed(2))}deg`;
  const place = `${degrees(theta)} ${degrees(phi)} ${Number((100 * radius).toFixed(2))}%`;
  const centre = target.map((x) => Number(x.toFixed(3)));
  return centre.some((x) => x !== 0) ? `${place} ${centre.join(' ')}` : place;
}

function angleOf(text = ''): number {
  return text.endsWith('rad') ? numberWith('rad', text) : (numberWith('deg', text) * Math.PI) / 180;
}

/** NaN without the unit. */
function numberWith(unit: string, text: string): number {
  const number = text.slice(0, -unit.length);
  return text.endsWith(unit) && number.trim() !== '' ? Number(number) : NaN;
}
