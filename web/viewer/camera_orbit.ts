// SPDX-License-Identifier: MIT

/** Where the camera is around the model, as `<model-viewer>` has it. */
export interface CameraOrbit {
  /** The angle around the upward axis, in radians; 0 is in front. */
  theta: number;
  /** The angle from the upward axis, in radians. */
  phi: number;
  /** The distance as a multiple of that from which the model fills the view. */
  radius: number;
}

/** Like `30deg 75deg 105%`, angles also in `rad`, the distance also `auto`; undefined if it is not. */
export function parseCameraOrbit(text: string): CameraOrbit | undefined {
  const [theta, phi, radius, ...rest] = text.trim().split(/\s+/);
  const orbit = {
    theta: angleOf(theta),
    phi: angleOf(phi),
    radius: radius === 'auto' || radius === undefined ? 1 : numberWith('%', radius) / 100,
  };
  const isOrbit = rest.length === 0 && Object.values(orbit).every(Number.isFinite);
  return isOrbit && orbit.radius > 0 ? orbit : undefined;
}

export function formatCameraOrbit({ theta, phi, radius }: CameraOrbit): string {
  const degrees = (angle: number) => `${Number(((180 * angle) / Math.PI).toFixed(2))}deg`;
  return `${degrees(theta)} ${degrees(phi)} ${Number((100 * radius).toFixed(2))}%`;
}

function angleOf(text = ''): number {
  return text.endsWith('rad') ? numberWith('rad', text) : (numberWith('deg', text) * Math.PI) / 180;
}

/** NaN without the unit. */
function numberWith(unit: string, text: string): number {
  const number = text.slice(0, -unit.length);
  return text.endsWith(unit) && number.trim() !== '' ? Number(number) : NaN;
}
