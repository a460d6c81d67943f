// SPDX-License-Identifier: MIT
import { type GltfResources, gltfResourceUris } from 'geodesic-voronoi';

/** A glTF with the files that it names. */
export interface ModelFiles {
  name: string;
  bytes: Uint8Array;
  resources: GltfResources;
}

/** Of what a person chose or dropped, the one model with the files beside it that it needs. */
export async function readModelFiles(files: readonly File[]): Promise<ModelFiles> {
  const models = files.filter((file) => /\.(glb|gltf)$/i.test(file.name));
  if (models.length === 0) {
    const names = files.map((file) => file.name).join(', ');
    throw new Error(
      files.length === 0
        ? 'No file arrived: drop a .glb file, or a .gltf file with the files it names.'
        : `${names} is not a model this page reads: it takes .glb, or .gltf with the files it names.`,
    );
  }
  if (models.length > 1) {
    throw new Error(
      `${models.map((file) => file.name).join(' and ')} arrived together: choose one model at a time.`,
    );
  }
  const [model] = models;
  const bytes = await bytesOf(model);
  const resources: GltfResources = {};
  const missing: string[] = [];
  for (const uri of gltfResourceUris(bytes)) {
    const wanted = lastSegment(uri);
    const file = files.find(({ name }) => name === wanted);
    if (file) resources[uri] = await bytesOf(file);
    else missing.push(wanted);
  }
  if (missing.length > 0) {
    throw new Error(
      `${model.name} needs ${missing.join(' and ')}: choose or drop all its files together.`,
    );
  }
  return { name: model.name, bytes, resources };
}

/** The model at an address; what it names is taken from where it says. */
export async function fetchModelFiles(
  address: string,
  { signal, onProgress }: { signal: AbortSignal; onProgress: (share: number) => void },
): Promise<ModelFiles> {
  const url = new URL(address, document.baseURI);
  const bytes = await fetchBytes(url, signal, onProgress);
  const resources: GltfResources = {};
  for (const uri of gltfResourceUris(bytes)) {
    resources[uri] = await fetchBytes(new URL(uri, url), signal, () => {});
  }
  return { name: lastSegment(url.pathname), bytes, resources };
}

async function fetchBytes(
  url: URL,
  signal: AbortSignal,
  onProgress: (share: number) => void,
): Promise<Uint8Array> {
  const name = lastSegment(url.pathname);
  let response: Response;
  try {
    response = await fetch(url, { signal });
  } catch (cause) {
    signal.throwIfAborted();
    throw new Error(`${name} cannot be fetched: the server does not answer.`, { cause });
  }
  if (!response.ok) {
    throw new Error(`${name} cannot be fetched: the server answers ${response.status}.`);
  }
  if (!response.body) return new Uint8Array(await response.arrayBuffer());

  // With an encoding, the length is that of what is sent and not of what arrives.
  const length = response.headers.has('Content-Encoding')
    ? 0
    : Number(response.headers.get('Content-Length'));
  const chunks: Uint8Array[] = [];
  let received = 0;
  const reader = response.body.getReader();
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    chunks.push(part.value);
    received += part.value.length;
    if (length > 0) onProgress(Math.min(1, received / length));
  }
  const bytes = new Uint8Array(received);
  let offset = 0;
  for (const chunk of chunks) {
    bytes.set(chunk, offset);
    offset += chunk.length;
  }
  return bytes;
}

async function bytesOf(file: File): Promise<Uint8Array> {
  try {
    return new Uint8Array(await file.arrayBuffer());
  } catch (cause) {
    throw new Error(`${file.name} cannot be read: is it a folder, or has it changed meanwhile?`, {
      cause,
    });
  }
}

/** What stands after the last slash, as a person would write it. */
function lastSegment(path: string): string {
  const name = path.slice(path.lastIndexOf('/') + 1);
  try {
    return decodeURIComponent(name);
  } catch {
    return name;
  }
}
