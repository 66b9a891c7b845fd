import type { RealDetails } from '../../api/messages';
import { texts } from '../../texts';
import { placeLabels, type Box } from '../labels';
import type { Layer } from '../scene';
import { heightOf, radius } from './robots';

const HEIGHT = 17;
const PADDING = 5;
/** Names change while a robot is silent, as they count its seconds. */
const MOST_WIDTHS = 5000;
const font = (bold: boolean) => `${bold ? 650 : 500} 12px system-ui, sans-serif`;

/** A robot's name; of one that is real with a mark, and for how long it has been silent. */
export function nameOf(id: string, real: RealDetails | undefined): string {
  return [id, real && texts.robots.realMark(real.proxy), real?.silence && texts.robots.seconds(real.silence)]
    .filter(Boolean)
    .join(' ');
}

const widths = new Map<string, number>();

/** How wide a name is drawn [px]; measured once. */
function widthOf(context: CanvasRenderingContext2D, name: string, bold: boolean): number {
  const key = `${bold}${name}`;
  let width = widths.get(key);
  if (width === undefined) {
    if (widths.size >= MOST_WIDTHS) {
      widths.clear();
    }
    context.font = font(bold);
    width = context.measureText(name).width;
    widths.set(key, width);
  }
  return width;
}

/** Names of robots, each in a frame of its robot's color; in a crowd those for which there is room. */
export const drawNames: Layer = (context, { info, poses, real, view, palette, selected }) => {
  const named = info.robots.flatMap((robot, i) => {
    const { id, color, footprint } = robot;
    const pose = poses[i];
    return pose
      ? [
          {
            name: nameOf(id, real.get(i)),
            color,
            pose,
            height: heightOf(robot, view.scale),
            reach: radius(footprint, view.scale) * view.scale,
            bold: i === selected,
          },
        ]
      : [];
  });
  context.save();
  view.leave(context); // text stands upright and keeps its size
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  const boxes = placeLabels(
    named.map(({ name, pose, height, reach, bold }) => {
      const width = widthOf(context, name, bold) + 2 * PADDING;
      const { px, py } = view.toPixel(pose, height);
      return { x: px, y: py, reach, width, height: HEIGHT, first: bold };
    }),
  );
  named.forEach(({ name, color, bold }, i) => {
    const box = boxes[i];
    if (!box) {
      return;
    }
    drawFrame(context, box, color, palette.halo, bold);
    context.font = font(bold);
    context.fillStyle = palette.text;
    context.fillText(name, box.x + box.width / 2, box.y + box.height / 2 + 0.5);
  });
  context.restore();
};

function drawFrame(
  context: CanvasRenderingContext2D,
  { x, y, width, height }: Box,
  color: string,
  halo: string,
  bold: boolean,
) {
  context.beginPath();
  context.roundRect(x, y, width, height, 5);
  context.globalAlpha = 0.85;
  context.fillStyle = halo;
  context.fill();
  context.globalAlpha = 1;
  context.lineWidth = bold ? 2.5 : 1.5;
  context.strokeStyle = color;
  context.stroke();
}
