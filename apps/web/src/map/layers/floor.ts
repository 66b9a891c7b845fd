import type { MapInfo } from '../../api/messages';
import { rgb, type Palette } from '../palette';
import type { View } from '../view';

const OCCUPIED = 100;
const UNKNOWN = 255;

/** The map as a picture, a pixel a cell, upper row first. */
export function paintFloor(map: MapInfo, cells: Uint8Array, palette: Palette): OffscreenCanvas {
  const [free, occupied, unknown] = [rgb(palette.free), rgb(palette.occupied), rgb(palette.unknown)];
  const colors = new Uint8Array(3 * 256);
  for (let value = 0; value < 256; value++) {
    colors.set(value === UNKNOWN ? unknown : value >= OCCUPIED / 2 ? occupied : free, 3 * value);
  }
  const canvas = new OffscreenCanvas(map.width, map.height);
  const context = canvas.getContext('2d')!;
  const image = context.createImageData(map.width, map.height);
  for (let row = 0; row < map.height; row++) {
    let to = 4 * (map.height - 1 - row) * map.width;
    for (let column = 0; column < map.width; column++, to += 4) {
      const from = 3 * cells[row * map.width + column]!;
      image.data[to] = colors[from]!;
      image.data[to + 1] = colors[from + 1]!;
      image.data[to + 2] = colors[from + 2]!;
      image.data[to + 3] = 255;
    }
  }
  context.putImageData(image, 0, 0);
  return canvas;
}

/** Draws the floor in canvas coordinates. */
export function drawFloor(
  context: CanvasRenderingContext2D,
  map: MapInfo,
  picture: OffscreenCanvas,
  view: View,
) {
  const { px, py } = view.toPixel({ x: map.originX, y: map.originY + map.height * map.resolution });
  const cell = map.resolution * view.scale;
  context.imageSmoothingEnabled = cell < 3; // close up, cells are cells
  context.imageSmoothingQuality = 'high';
  context.drawImage(picture, px, py, map.width * cell, map.height * cell);
}
