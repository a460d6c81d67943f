// SPDX-License-Identifier: MIT
//
// Files of pictures.

/** Pixels as WebGL has them: from the lowest row up, colours multiplied by their opacity. */
export interface DrawnPixels {
  width: number;
  height: number;
  /** Red, green, blue and opacity, a byte each. */
  pixels: Uint8ClampedArray<ArrayBuffer>;
}

/** A format of `canvas.toBlob`: a media type, and for some of these a quality from 0 to 1. */
export interface PictureFormat {
  type: string;
  quality?: number;
}

/** The file of a picture whose pixels are given away. */
export function pictureFile(drawn: DrawnPixels, format: PictureFormat): Promise<Blob> {
  const { width, height, pixels } = drawn;
  const canvas = new OffscreenCanvas(width, height);
  // The context is only read, which a canvas in memory does faster.
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (!context) throw new Error('The picture is too large.');
  turnOver(drawn);
  divideByOpacity(pixels);
  context.putImageData(new ImageData(pixels, width, height), 0, 0);
  return canvas.convertToBlob(format);
}

function turnOver({ width, height, pixels }: DrawnPixels): void {
  const row = 4 * width;
  for (let top = 0, bottom = row * (height - 1); top < bottom; top += row, bottom -= row) {
    const upper = pixels.slice(top, top + row);
    pixels.copyWithin(top, bottom, bottom + row);
    pixels.set(upper, bottom);
  }
}

function divideByOpacity(pixels: Uint8ClampedArray): void {
  for (let i = 0; i < pixels.length; i += 4) {
    const opacity = pixels[i + 3];
    if (opacity === 0 || opacity === 255) continue;
    for (let k = i; k < i + 3; ++k) pixels[k] = (255 * pixels[k]) / opacity;
  }
}
