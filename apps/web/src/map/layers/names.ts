import type { RealDetails } from '../../api/messages';
import { texts } from '../../texts';
import { placeLabels, type Box } from '../labels';
import type { Palette } from '../palette';
import type { Context } from '../context';
import type { Layer, Scene } from '../scene';
import { heightOf, radius } from './robots';
import { MANY, pictureOf } from './sprites';

const HEIGHT = 17;
const PADDING = 5;
/** How far a frame's line reaches around its box, and a bit [px]. */
const EDGE = 2;
/** Pictures that are kept, 10 MB at most on usual screens; names that say for how long a robot is silent become others. */
const MOST = 1000;

const font = (bold: boolean) => `${bold ? 650 : 500} 12px system-ui, sans-serif`;

/** A robot's name; of one that is real with a mark, and for how long it has been silent. */
export function nameOf(id: string, real: RealDetails | undefined): string {
  return [id, real && texts.robots.realMark(real.proxy), real?.silence && texts.robots.seconds(real.silence)]
    .filter(Boolean)
    .join(' ');
}

/** Of characters, and of names until these are too many. */
const widths = new Map<string, number>();
const MOST_WIDTHS = 5000;

/** How wide a name is drawn [px], without kerning: as all its characters, which are few and measured once. */
function widthOf(context: CanvasRenderingContext2D, name: string, bold: boolean): number {
  const key = `${bold} ${name}`;
  let width = widths.get(key);
  if (width === undefined) {
    if (widths.size > MOST_WIDTHS) {
      widths.clear();
    }
    context.font = font(bold);
    const characters = [...name];
    width =
      characters.length === 1
        ? context.measureText(name).width
        : characters.reduce((sum, one) => sum + widthOf(context, one, bold), 0);
    widths.set(key, width);
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
  const { info, poses, view, density, palette } = scene;
  context.save();
  view.leave(context); // text stands upright and keeps its size
  const plateOf = info.robots.length > MANY ? plates.begin(palette, density) : null;
  if (plateOf) {
    context.resetTransform();
  }
  for (const label of labelsOf(context, scene)) {
    const pose = poses[label.robot];
    if (pose) {
      const robot = info.robots[label.robot]!;
      const { px, py } = view.toPixel(pose, heightOf(robot, view.scale));
      const [x, y] = [px + label.box.x, py + label.box.y];
      if (plateOf) {
        const left = Math.round((x - EDGE) * density);
        context.drawImage(plateOf(label, robot.color), left, Math.round((y - EDGE) * density));
      } else {
        drawPlate(context, { ...label, box: { ...label.box, x, y } }, robot.color, palette);
      }
    }
  }
  context.restore();
};

/** Pictures of the names of many robots, drawn at whole pixels. */
class Plates {
  private readonly made = new Map<string, ImageBitmap>();
  private palette: Palette | null = null;
  private density = 1;

  /** @returns gives the picture of a name in its frame, `EDGE` around that included */
  begin(palette: Palette, density: number): (label: Label, color: string) => ImageBitmap {
    if (palette !== this.palette || density !== this.density || this.made.size > MOST) {
      this.made.forEach((picture) => picture.close());
      this.made.clear();
      [this.palette, this.density] = [palette, density];
    }
    return (label, color) => {
      const key = `${label.bold} ${color} ${label.name}`;
      let picture = this.made.get(key);
      if (!picture) {
        const box = { ...label.box, x: EDGE, y: EDGE };
        const size = (length: number) => Math.ceil((length + 2 * EDGE) * density);
        picture = pictureOf(size(box.width), size(box.height), density, (context) =>
          drawPlate(context, { ...label, box }, color, palette),
        );
        this.made.set(key, picture);
      }
      return picture;
    };
  }
}

const plates = new Plates();

function drawPlate(context: Context, { name, bold, box }: Label, color: string, palette: Palette) {
  const { x, y, width, height } = box;
  context.beginPath();
  context.roundRect(x, y, width, height, 5);
  context.globalAlpha = 0.85;
  context.fillStyle = palette.halo;
  context.fill();
  context.globalAlpha = 1;
  context.lineWidth = bold ? 2.5 : 1.5;
  context.strokeStyle = color;
  context.stroke();
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.font = font(bold);
  context.fillStyle = palette.text;
  context.fillText(name, x + width / 2, y + height / 2 + 0.5);
}
