import type { Palette } from '../palette';
import type { View } from '../view';

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
  const { x: left, y: top } = view.toMap({ px: 0, py: 0 });
  const { x: right, y: bottom } = view.toMap({ px: width, py: height });
  context.beginPath();
  for (let x = Math.ceil(left / step) * step; x <= right; x += step) {
    const px = Math.round(view.toPixel({ x, y: 0 }).px) + 0.5;
    context.moveTo(px, 0);
    context.lineTo(px, height);
  }
  for (let y = Math.ceil(bottom / step) * step; y <= top; y += step) {
    const py = Math.round(view.toPixel({ x: 0, y }).py) + 0.5;
    context.moveTo(0, py);
    context.lineTo(width, py);
  }
  context.strokeStyle = palette.grid;
  context.lineWidth = 1;
  context.stroke();
}
