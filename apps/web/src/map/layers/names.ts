import type { RealDetails } from '../../api/messages';
import { texts } from '../../texts';
import { placeLabels, type Box } from '../labels';
import type { Layer, Scene } from '../scene';
import { heightOf, radius } from './robots';

const HEIGHT = 17;
const PADDING = 5;
const font = (bold: boolean) => `${bold ? 650 : 500} 12px system-ui, sans-serif`;

/** A robot's name; of one that is real with a mark, and for how long it has been silent. */
export function nameOf(id: string, real: RealDetails | undefined): string {
  return [id, real && texts.robots.realMark(real.proxy), real?.silence && texts.robots.seconds(real.silence)]
    .filter(Boolean)
    .join(' ');
}

const widths = new Map<string, number>();

/** How wide a name is drawn [px], without kerning: as all its characters, which are few and measured once. */
function widthOf(context: CanvasRenderingContext2D, name: string, bold: boolean): number {
  let width = 0;
  for (const character of name) {
    const key = `${bold}${character}`;
    let one = widths.get(key);
    if (one === undefined) {
      context.font = font(bold);
      one = context.measureText(character).width;
      widths.set(key, one);
    }
    width += one;
  }
  return width;
}

/** A name, and where it stands to the middle of its robot [px]. */
interface Label {
  robot: number;
  name: string;
  bold: boolean;
  box: Box;
}

let placed: { scene: Scene; labels: Label[] } | null = null;

/** Between two frames names go along with their robots, at no cost. */
function labelsOf(context: CanvasRenderingContext2D, scene: Scene): Label[] {
  const before = placed?.scene;
  const same =
    before?.frame === scene.frame &&
    before.view === scene.view &&
    before.selected === scene.selected &&
    before.info === scene.info &&
    before.real === scene.real;
  if (!placed || !same) {
    placed = { scene, labels: place(context, scene) };
  }
  return placed.labels;
}

function place(context: CanvasRenderingContext2D, { info, poses, real, view, selected }: Scene): Label[] {
  const named = info.robots.flatMap((robot, i) => {
    const pose = poses[i];
    if (!pose) {
      return [];
    }
    const name = nameOf(robot.id, real.get(i));
    const bold = i === selected;
    const width = widthOf(context, name, bold) + 2 * PADDING;
    const { px, py } = view.toPixel(pose, heightOf(robot, view.scale));
    const reach = radius(robot.footprint, view.scale) * view.scale;
    return [{ robot: i, name, bold, x: px, y: py, reach, width, height: HEIGHT, first: bold }];
  });
  const boxes = placeLabels(named);
  return named.flatMap(({ robot, name, bold, x, y }, i) => {
    const box = boxes[i];
    return box ? [{ robot, name, bold, box: { ...box, x: box.x - x, y: box.y - y } }] : [];
  });
}

/** Where names of robots are written [px]. */
export function boxesOf(context: CanvasRenderingContext2D, scene: Scene): Box[] {
  const { info, poses, view } = scene;
  return labelsOf(context, scene).flatMap(({ robot, box }) => {
    const pose = poses[robot];
    if (!pose) {
      return [];
    }
    const { px, py } = view.toPixel(pose, heightOf(info.robots[robot]!, view.scale));
    return [{ ...box, x: px + box.x, y: py + box.y }];
  });
}

/** Names of robots, each in a frame of its robot's color; in a crowd those for which there is room. */
export const drawNames: Layer = (context, scene) => {
  const { info, poses, view, palette } = scene;
  context.save();
  view.leave(context); // text stands upright and keeps its size
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  for (const { robot, name, bold, box } of labelsOf(context, scene)) {
    const pose = poses[robot];
    if (pose) {
      const { px, py } = view.toPixel(pose, heightOf(info.robots[robot]!, view.scale));
      const [x, y] = [px + box.x, py + box.y];
      drawFrame(context, { ...box, x, y }, info.robots[robot]!.color, palette.halo, bold);
      context.font = font(bold);
      context.fillStyle = palette.text;
      context.fillText(name, x + box.width / 2, y + box.height / 2 + 0.5);
    }
  }
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
