// SPDX-License-Identifier: MIT
//
// The format of a file, found from its content, because names can be wrong or missing.

import { invalidFile } from '../api/errors.js';
import { isBinaryStl, mayBeBinaryStl } from './stl_layout.js';
import { requireNoUtf16 } from './text_encoding.js';

export type FileFormat = 'glTF' | 'OBJ' | 'OFF' | 'PLY' | 'binary STL' | 'text STL' | 'zip';

/** Enough to find the first statement after the comments that programs write. */
const maxHeadBytes = 2 ** 16;
const objStatement = /^(v|vt|vn|vp|f|fo|g|o|s|l|p|mtllib|usemtl|mg|lod|maplib)([ \t]|$)/m;

/** The name decides only where the content does not, as in a broken file. */
export function formatOf(bytes: Uint8Array, name: string): FileFormat {
  if (bytes.length === 0) throw invalidFile('the file is empty');
  if (isBinaryStl(bytes)) return 'binary STL';
  requireNoUtf16(bytes);
  const head = new TextDecoder('latin1').decode(bytes.subarray(0, maxHeadBytes));
  // The mark of UTF-8, as this decoder has it; comments of OFF and OBJ, whatever ends their lines.
  const text = head.replace(/^(ï»¿)?(\s|#[^\r\n]*[\r\n])*/, '');
  if (head.startsWith('glTF') || text.startsWith('{')) return 'glTF';
  if (head.startsWith('PK\x03\x04') || head.startsWith('PK\x05\x06')) return 'zip';
  if (/^ply[ \t]*[\r\n]/.test(text)) return 'PLY';
  if (/^((ST|[CN4n])*OFF\b|\d+[ \t]+\d+[ \t]+\d+\s)/.test(text)) return 'OFF';
  const isBinary = head.includes('\0');
  const isTextStl = /^solid\b/i.test(text) && /\bfacet\b|\bendsolid\b/i.test(text);
  if (!isBinary && isTextStl) return 'text STL';
  if (!isBinary && objStatement.test(text)) return 'OBJ';
  switch (/\.(\w+)$/.exec(name)?.[1].toLowerCase()) {
    case 'glb':
    case 'gltf':
      return 'glTF';
    case 'stl':
      return isBinary ? 'binary STL' : 'text STL';
    case 'obj':
      return 'OBJ';
    case 'off':
      return 'OFF';
    case 'ply':
      return 'PLY';
  }
  if (isBinary && mayBeBinaryStl(bytes)) return 'binary STL';
  throw invalidFile(
    'the file has none of the formats that are read: glTF, OBJ, OFF, PLY or STL, or a zip with one of them',
  );
}
