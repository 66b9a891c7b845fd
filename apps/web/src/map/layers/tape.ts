import { degrees } from '../../format';
import type { Layer } from '../scene';

const TICK = 6; // px, to either side of its ends
const PADDING = 5;
const FONT = '600 12px system-ui, sans-serif';

/** A measuring tape: how far it is from one place to another, and in which direction. */
export const drawTape: Layer = (context, { tape, view, palette }) => {
  if (tape === null) {
    return;
  }
  const { from, to } = tape;
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  const direction = Math.atan2(to.y - from.y, to.x - from.x);
  context.save();
  context.scale(1 / view.scale, -1 / view.scale); // in pixels, so that text stands upright
  const [x, y] = [from.x * view.scale, -from.y * view.scale];
  context.translate(x, y);
  context.save();
  context.rotate(-direction);
  for (const [color, width] of [
    [palette.halo, 4],
    [palette.accent, 2],
  ] as const) {
    context.beginPath();
    context.moveTo(0, 0);
    context.lineTo(length * view.scale, 0);
    for (const end of [0, length * view.scale]) {
      context.moveTo(end, -TICK);
      context.lineTo(end, TICK);
    }
    context.strokeStyle = color;
    context.lineWidth = width;
    context.stroke();
  }
  context.restore();
  const text = `${length.toFixed(2)} m, ${degrees(direction)}`;
  context.font = FONT;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  const half = context.measureText(text).width / 2 + PADDING;
  context.translate((to.x - from.x) * view.scale, -(to.y - from.y) * view.scale - 18);
  context.beginPath();
  context.roundRect(-half, -10, 2 * half, 20, 5);
  context.fillStyle = palette.halo;
  context.fill();
  context.strokeStyle = palette.accent;
  context.lineWidth = 1.5;
  context.stroke();
  context.fillStyle = palette.text;
  context.fillText(text, 0, 0.5);
  context.restore();
};
