import type { CarriedInfo, LightInfo, PieceInfo, RobotInfo } from '../../api/messages';
import type { Pose, RobotState } from '../../live/frame';
import type { Context } from '../context';
import type { Layer, Scene } from '../scene';
import type { Point, View } from '../view';
import { toOklab } from '../../shades';
import type { Palette } from '../palette';
import { drawBody } from './bodies';
import { carriedPieces, carrierOf, movedTo, withPaddles } from './carried';
import { enter } from './frames';
import { ROBOT_HEIGHT } from './heights';
import { MANY, Sprites } from './sprites';

/** A robot is drawn at least this long [px], so that it is seen on a large map. */
const LEAST_PIXELS = 18;
/** Of robots that nobody hears of. */
export const FADED = '#8a93a1';
/** Radius of a light, and of its shine [m]. */
const LAMP = 0.05;
const GLOW = 0.3;
/** Robots of at least this lightness (of OKLab) have dark arrows. */
const LIGHT = 0.72;
export const HANDLE_PIXELS = 5;
/** Many robots are drawn as sprites while they are no larger than so [px]. */
const SMALL = 24;
/** How wide the lines around a robot are [px]. */
const LINES = 4;

const sprites = new Sprites();

/** Robots as seen from above: outline and heading. */
export const drawRobots: Layer = (context, scene) => {
  const { info, frame, poses, selected } = scene;
  const draw = drawerOf(context, scene);
  info.robots.forEach((_, i) => {
    if (!poses[i]) {
      return;
    }
    draw(i);
    if (frame.robots[i]!.stalled || i === selected) {
      drawMarks(context, scene, i);
    }
  });
};

/**
 * What draws robots of a scene by their numbers: where they are many, and small, by copying pictures of them.
 *
 * @returns it tells whether it has copied one
 */
export function drawerOf(context: CanvasRenderingContext2D, scene: Scene): (i: number) => boolean {
  const { info, view, density, palette } = scene;
  const { a, b, c, d, e, f } = context.getTransform();
  if (info.robots.length <= MANY || !sprites.begin(view, density, palette)) {
    return (i) => {
      drawInState(context, scene, i);
      return false;
    };
  }
  return (i) => {
    const pose = scene.poses[i];
    const robot = info.robots[i]!;
    const reach = radius(robot.footprint, view.scale) * view.scale + LINES;
    const changes = robot.gripper !== null || robot.light !== null || scene.carried.has(i);
    if (!pose || reach > SMALL || changes || scene.faded.has(i)) {
      drawInState(context, scene, i); // something on it changes, or it is large enough to be looked at
      return false;
    }
    const room = reach + heightOf(robot, view.scale) * view.rise * view.scale;
    const sprite = sprites.of(robot, pose.heading, room, (at, heading, seen) =>
      drawRobot(at, { x: 0, y: 0, heading }, robot, seen, palette),
    );
    const left = Math.round(a * pose.x + c * pose.y + e - sprite.width / 2);
    const top = Math.round(b * pose.x + d * pose.y + f - sprite.height / 2);
    const { width, height } = context.canvas;
    if (left > -sprite.width && top > -sprite.height && left < width && top < height) {
      context.resetTransform();
      context.drawImage(sprite, left, top);
      context.setTransform(a, b, c, d, e, f);
    }
    return true;
  };
}

/** A robot, if it is there, as it is now. */
export function drawInState(context: CanvasRenderingContext2D, scene: Scene, i: number) {
  const { info, frame, poses, faded, carried, view, palette } = scene;
  const pose = poses[i];
  const robot = info.robots[i]!;
  if (!pose) {
    return;
  }
  if (faded.has(i)) {
    context.globalAlpha = 0.6;
    drawRobot(context, pose, { ...robot, color: FADED, pieces: [] }, view, palette);
    context.globalAlpha = 1;
  } else {
    drawRobot(context, pose, robot, view, palette, frame.robots[i], carried.get(i));
  }
}

/** Rings on the floor, around who is stalled or selected. */
export function drawMarks(context: CanvasRenderingContext2D, scene: Scene, i: number) {
  const { info, frame, poses, view, palette, selected } = scene;
  const pose = poses[i];
  const { color, footprint } = info.robots[i]!;
  if (!pose) {
    return;
  }
  if (frame.robots[i]!.stalled) {
    drawRing(context, pose, footprint, view.scale, palette.text, [4, 4]);
  }
  if (i === selected) {
    drawRing(context, pose, footprint, view.scale, color, []);
    drawHandle(context, handleOf(pose, footprint, view.scale), color, view.scale, palette.halo);
  }
}

/** How high a robot is drawn [m]. */
export function heightOf({ footprint, pieces }: RobotInfo, scale: number): number {
  return (pieces.at(-1)?.high ?? ROBOT_HEIGHT) * magnification(footprint, scale);
}

export function drawRobot(
  context: Context,
  pose: Pose,
  { footprint, pieces, color, gripper, light }: RobotInfo,
  view: View,
  { halo, edge }: Palette,
  state?: RobotState,
  carried?: readonly CarriedInfo[],
) {
  const { scale } = view;
  const grown = magnification(footprint, scale);
  const body = piecesOf({ footprint, pieces });
  const shape = withPaddles(carriedPieces(body, carried), gripper, state?.gripper, carried);
  if (view.oblique) {
    drawBody(context, pose, shape, { color, line: edge, lineWidth: 1 }, view, grown);
  } else {
    drawBody(context, pose, shape, { color, line: edge, lineWidth: 1.75 }, view, grown); // seen on floors of its color
    drawBody(context, pose, shape, { color, line: halo, lineWidth: 1 }, view, grown);
  }
  context.save();
  enter(context, view.raised(pose, body.at(-1)!.high * grown));
  context.scale(grown, grown);
  const side = Math.max(...footprint.map(([, y]) => Math.abs(y!)));
  const front = Math.min(Math.max(...footprint.map(([x]) => x!)), 1.5 * side); // arms reach far out of a footprint
  context.beginPath(); // an arrow head
  context.moveTo(0.8 * front, 0);
  context.lineTo(-0.35 * front, 0.55 * front);
  context.lineTo(-0.1 * front, 0);
  context.lineTo(-0.35 * front, -0.55 * front);
  context.closePath();
  context.fillStyle = toOklab(body.at(-1)!.color ?? color)[0] > LIGHT ? '#10151d' : '#ffffff';
  context.fill();
  if (light) {
    const load = carrierOf(light.name, carried);
    const [x, y] = load ? (movedTo([light.x, light.y], load) as [number, number]) : [light.x, light.y];
    drawLight(context, { ...light, x, y }, state?.lit === true, edge, 1 / (scale * grown));
  }
  context.restore();
}

/** In the robot's frame: a lamp, and what it shines on. */
function drawLight(context: Context, { x, y, color }: LightInfo, lit: boolean, edge: string, pixel: number) {
  context.fillStyle = color;
  if (lit) {
    context.beginPath();
    context.arc(x, y, GLOW, 0, 2 * Math.PI);
    context.globalAlpha *= 0.3;
    context.fill();
    context.globalAlpha /= 0.3;
  }
  context.beginPath();
  context.arc(x, y, LAMP, 0, 2 * Math.PI);
  if (lit) {
    context.fill();
  }
  context.strokeStyle = lit ? edge : color;
  context.lineWidth = 1.5 * pixel;
  context.stroke();
}

const plains = new WeakMap<number[][], PieceInfo>();

/** What a robot's body is made of, in its own frame: its footprint when nothing else is told. */
export function piecesOf({
  footprint,
  pieces,
}: Pick<RobotInfo, 'footprint' | 'pieces'>): readonly PieceInfo[] {
  return pieces.length > 0 ? pieces : [plain(footprint)];
}

/** A body that is its footprint. */
function plain(footprint: number[][]): PieceInfo {
  const piece = plains.get(footprint) ?? {
    color: null,
    corners: footprint,
    radius: 0,
    low: 0,
    high: ROBOT_HEIGHT,
  };
  plains.set(footprint, piece);
  return piece;
}

function drawRing(
  context: CanvasRenderingContext2D,
  pose: Pose,
  footprint: number[][],
  scale: number,
  color: string,
  dash: number[],
) {
  context.beginPath();
  context.arc(pose.x, pose.y, radius(footprint, scale) + 5 / scale, 0, 2 * Math.PI);
  context.strokeStyle = color;
  context.lineWidth = 2 / scale;
  context.setLineDash(dash.map((length) => length / scale));
  context.stroke();
  context.setLineDash([]);
}

export function drawHandle(
  context: CanvasRenderingContext2D,
  { x, y }: Point,
  color: string,
  scale: number,
  halo: string,
) {
  context.beginPath();
  context.arc(x, y, HANDLE_PIXELS / scale, 0, 2 * Math.PI);
  context.fillStyle = halo;
  context.fill();
  context.lineWidth = 2 / scale;
  context.strokeStyle = color;
  context.stroke();
}

/** Where the handle is that turns a robot, in front of it. */
export function handleOf(pose: Pose, footprint: number[][], scale: number): Point {
  return handleAhead(pose, radius(footprint, scale), scale);
}

/** The same of something that reaches so far [m]. */
export function handleAhead(pose: Pose, reach: number, scale: number): Point {
  const ahead = reach + 18 / scale;
  return { x: pose.x + ahead * Math.cos(pose.heading), y: pose.y + ahead * Math.sin(pose.heading) };
}

/** Radius in which a robot is drawn [m]. */
export function radius(footprint: number[][], scale: number): number {
  return size(footprint) * magnification(footprint, scale);
}

const sizes = new WeakMap<number[][], number>();

/** Radius of a robot [m]. */
export function size(footprint: number[][]): number {
  let known = sizes.get(footprint);
  if (known === undefined) {
    known = Math.max(...footprint.map(([x, y]) => Math.hypot(x!, y!)));
    sizes.set(footprint, known);
  }
  return known;
}

function magnification(footprint: number[][], scale: number): number {
  return Math.max(1, LEAST_PIXELS / (2 * size(footprint) * scale));
}
