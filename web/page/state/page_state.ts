// SPDX-License-Identifier: MIT
//
// The state that a shared link keeps after its #: v=1, the model's name, how sites were placed and
// where they are, the distance, and the view.

import type { SurfacePoints } from 'geodesic-voronoi';
import { buildAttributes, samplingAttributes } from '../../viewer/attributes/attribute_defaults.js';
import type { GeodesicVoronoiElement, ViewerEvents } from '../../viewer/element.js';
import { lastSegment } from '../../viewer/session/model_files.js';
import { byId } from '../base/dom.js';
import { showError, showNote } from '../base/messages.js';
import { isSample } from '../samples/first_model.js';
import { integer } from '../base/numbers.js';

const version = '1';
/** The most sites in a link: some programs cut off longer addresses. */
const mostSites = 2000;
/** Barycentric coordinates are kept as 16-bit fractions. */
const unit = 65535;
const bytesPerSite = 8;

/** Attributes of the viewer with values that the library may refuse; each has a field. */
const refusable = [...samplingAttributes, ...buildAttributes, 'metric', 'detail'];

/** The attributes that a link keeps. */
export const linkAttributes = [...refusable, 'up', 'layers', 'exploded', 'camera-orbit'];

/** Those that are about one model: the next one begins without them. */
export const ofOneModel = [...buildAttributes, 'detail', 'up', 'exploded', 'camera-orbit'];

/** Whether an address's hash is one that `pageState` wrote. */
export function isPageState(hash: string): boolean {
  return parametersOf(hash).has('v');
}

/** The name of the file that the model came from. */
export function modelName({ info }: GeodesicVoronoiElement): string {
  return lastSegment(info?.origin.file ?? '');
}

/** The hash that restores the present state. */
export function pageState(viewer: GeodesicVoronoiElement): string {
  const parameters = new URLSearchParams({ v: version, model: modelName(viewer) });
  for (const name of linkAttributes) {
    const value = name === 'camera-orbit' ? viewer.cameraOrbit : viewer.getAttribute(name);
    if (isGiven(name, value)) parameters.set(name, value);
  }
  const { sites } = viewer;
  if (sites.face.length <= mostSites) parameters.set('at', encodeSites(sites));
  return `#${parameters}`;
}

/** What a link of the present state does not hold, as sentences. */
export function notHeld(viewer: GeodesicVoronoiElement): string[] {
  const sentences: string[] = [];
  const model = modelName(viewer);
  if (!isSample(model)) {
    sentences.push(
      `The link does not hold the file ${model}: whoever opens it has to open that, too.`,
    );
  }
  if (viewer.sites.face.length > mostSites) {
    sentences.push(
      `The link does not hold more than ${integer(mostSites)} sites: others are placed. ` +
        'The file Sites, in the menu Download, has them all.',
    );
  }
  if (viewer.density) sentences.push('The link does not hold the painted density.');
  return sentences;
}

/** Restores the state in a link; one of another version is told of. */
export function readPageState(viewer: GeodesicVoronoiElement, hash: string): void {
  const parameters = parametersOf(hash);
  if (parameters.get('v') !== version) {
    if (parameters.has('v'))
      tellOnceLoaded(viewer, 'The link was made by another version of this page, and is not used.');
    return;
  }
  dropRefused(viewer, parameters);
  /** Sets an attribute as the link has it. Returns whether it had another value. */
  const restore = (name: string): boolean => {
    const value = parameters.get(name);
    if (!isGiven(name, value)) return false;
    const isOther = viewer.getAttribute(name) !== value;
    viewer.setAttribute(name, value);
    return isOther;
  };
  const at = parameters.get('at');
  const model = parameters.get('model');
  // Until a reader's own file is opened, a sample is shown, to which these may not apply.
  const ofFile = model && !isSample(model) ? ofOneModel : [];
  for (const name of linkAttributes) if (!ofFile.includes(name)) restore(name);
  const waiting = new AbortController();
  let isFirst = true;
  let endNote = () => {};
  const bringBack = ({ detail: { name } }: CustomEvent<ViewerEvents['load']>) => {
    endNote();
    // Sites on a reader's own file make no sense without it.
    if (model && name !== model) {
      if (isFirst && !isSample(model))
        endNote = showNote(
          `This link is of ${model}, which it does not hold: open that file, too.`,
          { title: 'Open file…', act: () => byId('open', HTMLButtonElement).click() },
        );
      isFirst = false;
      return;
    }
    const others = ofFile.filter(restore);
    if (buildAttributes.some((name) => others.includes(name))) return; // The model is opened anew.
    waiting.abort();
    // The list of sites is empty where all were removed.
    if (model && at !== null) showSites(viewer, at);
    // The camera's place applies to this model only. The element takes it up at the end of the task.
    queueMicrotask(() => viewer.removeAttribute('camera-orbit'));
  };
  viewer.addEventListener('load', bringBack, { signal: waiting.signal });
}

/** Whether an attribute has a value; an empty list of layers is one. */
function isGiven(name: string, value: string | null): value is string {
  return value !== null && (value !== '' || name === 'layers');
}

/** Removes the values that their fields would not take, and tells of them once there is a model. */
function dropRefused(viewer: GeodesicVoronoiElement, parameters: URLSearchParams): void {
  const refused = refusable
    .map((name) => ({ name, value: parameters.get(name) }))
    .filter(({ name, value }) => isGiven(name, value) && !isTaken(name, value));
  if (refused.length === 0) return;
  for (const { name } of refused) parameters.delete(name);
  const list = refused.map(({ name, value }) => `${name}=${value}`).join(', ');
  tellOnceLoaded(viewer, `The link is damaged. These parts cannot be used: ${list}.`);
}

/** Tells of a fault of the link once there is a model: opening one ends what is told before. */
function tellOnceLoaded(viewer: GeodesicVoronoiElement, text: string): void {
  viewer.addEventListener('load', () => showError(text), { once: true });
}

/** Whether the page's field of an attribute takes a value. */
function isTaken(name: string, value: string): boolean {
  const radios = document.querySelectorAll<HTMLInputElement>(`input[name="${name}"]`);
  if (radios.length > 0) return [...radios].some((radio) => radio.value === value);
  // A copy: the field itself is not checked while its panel is disabled.
  const field = document.getElementById(name === 'sites' ? 'count' : name)?.cloneNode(true);
  const copy = field as HTMLInputElement | HTMLSelectElement;
  copy.value = value;
  return copy.value === value && copy.checkValidity();
}

function showSites(viewer: GeodesicVoronoiElement, text: string): void {
  try {
    const sites = decodeSites(text);
    const faces = viewer.info?.inputFaces ?? 0;
    if (sites.face.some((face) => face < 0 || face >= faces)) throw new RangeError();
    viewer.sites = sites;
  } catch {
    showError('The link is damaged: its sites cannot be read. Others have been placed.');
  }
}

function parametersOf(hash: string): URLSearchParams {
  return new URLSearchParams(hash.slice(1));
}

function encodeSites({ face, bary }: SurfacePoints): string {
  const bytes = new DataView(new ArrayBuffer(bytesPerSite * face.length));
  face.forEach((f, i) => {
    bytes.setUint32(bytesPerSite * i, f);
    for (const k of [0, 1]) {
      bytes.setUint16(bytesPerSite * i + 4 + 2 * k, Math.round(unit * bary[3 * i + k]));
    }
  });
  const text = String.fromCharCode(...new Uint8Array(bytes.buffer));
  return btoa(text).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
}

function decodeSites(text: string): SurfacePoints {
  const binary = atob(text.replace(/-/g, '+').replace(/_/g, '/'));
  const bytes = new DataView(Uint8Array.from(binary, (c) => c.charCodeAt(0)).buffer);
  const count = bytes.byteLength / bytesPerSite;
  if (!Number.isInteger(count)) throw new RangeError();
  const face = new Int32Array(count);
  const bary = new Float64Array(3 * count);
  for (let i = 0; i < count; ++i) {
    face[i] = bytes.getUint32(bytesPerSite * i);
    const [a, b] = [0, 1].map((k) => bytes.getUint16(bytesPerSite * i + 4 + 2 * k) / unit);
    // Both may have been rounded up.
    const rest = 1 - a;
    bary.set([a, Math.min(b, rest), Math.max(0, rest - b)], 3 * i);
  }
  return { face, bary };
}
