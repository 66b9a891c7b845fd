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
  view.leave(context); // text stands upright
  const [start, end] = [view.toPixel(from), view.toPixel(to)];
  const across = Math.hypot(end.px - start.px, end.py - start.py);
  context.save();
  context.translate(start.px, start.py);
  context.rotate(Math.atan2(end.py - start.py, end.px - start.px));
  for (const [color, width] of [
    [palette.halo, 4],
    [palette.accent, 2],
  ] as const) {
    context.beginPath();
    context.moveTo(0, 0);
    context.lineTo(across, 0);
    for (const tick of [0, across]) {
      context.moveTo(tick, -TICK);
      context.lineTo(tick, TICK);
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
  context.translate(end.px, end.py - 18);
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
