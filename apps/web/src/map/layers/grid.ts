import type { Palette } from '../palette';
import type { Point, View } from '../view';

const LEAST_PIXELS = 40;
const STEPS = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100];

/** Distance of the grid's lines [m], so that they are not too dense to be seen. */
export function gridStep(scale: number): number {
  return STEPS.find((step) => step * scale >= LEAST_PIXELS) ?? 100;
}

/** Draws lines at round coordinates, in canvas coordinates. */
export function drawGrid(
  context: CanvasRenderingContext2D,
  view: View,
  palette: Palette,
  width: number,
  height: number,
) {
  const step = gridStep(view.scale);
  const corners = [0, width].flatMap((px) => [0, height].map((py) => view.toMap({ px, py })));
  const xs = corners.map(({ x }) => x);
  const ys = corners.map(({ y }) => y);
  const [left, right] = [Math.min(...xs), Math.max(...xs)];
  const [bottom, top] = [Math.min(...ys), Math.max(...ys)];
  const line = (from: Point, to: Point) => {
    const [a, b] = [view.toPixel(from), view.toPixel(to)];
    context.moveTo(sharp(a.px), sharp(a.py));
    context.lineTo(sharp(b.px), sharp(b.py));
  };
  context.beginPath();
  for (let x = Math.ceil(left / step) * step; x <= right; x += step) {
    line({ x, y: bottom }, { x, y: top });
  }
  for (let y = Math.ceil(bottom / step) * step; y <= top; y += step) {
    line({ x: left, y }, { x: right, y });
  }
  context.strokeStyle = palette.grid;
  context.lineWidth = 1;
  context.stroke();
}

/** In the middle of a pixel, so that a line of one pixel is not two. */
function sharp(pixel: number): number {
  return Math.round(pixel) + 0.5;
}
