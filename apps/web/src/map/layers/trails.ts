import { SPACING } from '../../live/trails';
import type { Layer, Scene } from '../scene';
import { bgrOf, Dots } from './dots';

/** More trails than this are drawn as dots, while these stand so near that they are lines [px]. */
const MANY = 60;
const DOT = 2;

const WEAKEST = 0.08;
const STRONGEST = 0.48;

/** How strong a trail is, of its newest point. */
const fading = (share: number) => (WEAKEST + (STRONGEST - WEAKEST) * share) / STRONGEST;

let dots: Dots | null = null; // made where there is a page

/** A trail fades in so many steps. */
const PIECES = 6;
/** Points nearer than this are left out [px]. */
const FINEST = 1.5;

/** Where robots have been, fading with time. */
export const drawTrails: Layer = (context, scene) => {
  if (scene.info.robots.length > MANY && SPACING * scene.view.scale < DOT) {
    drawDotted(context, scene);
  } else {
    drawLines(context, scene);
  }
};

function drawDotted(context: CanvasRenderingContext2D, { info, trails, poses, view }: Scene) {
  dots ??= new Dots();
  dots.begin(context, DOT / view.scale, STRONGEST);
  info.robots.forEach(({ color }, i) => {
    const trail = trails.of(i);
    if (trail && poses[i]) {
      const bgr = bgrOf(color);
      for (let at = 0; at < trail.x.length; at++) {
        dots!.set(trail.x[at]!, trail.y[at]!, bgr, fading(at / trail.x.length));
      }
    }
  });
  dots.draw(context);
}

/** Those of one color together, as single ones take long where robots are many. */
function drawLines(context: CanvasRenderingContext2D, { info, trails, poses, view }: Scene) {
  context.lineWidth = 2 / view.scale;
  context.lineCap = 'round';
  context.lineJoin = 'round';
  const near = FINEST / view.scale;
  const colors = new Map<string, number[]>();
  info.robots.forEach(({ color }, i) => (colors.get(color) ?? colors.set(color, []).get(color)!).push(i));
  for (const [color, robots] of colors) {
    context.strokeStyle = color;
    for (let piece = 0; piece < PIECES; piece++) {
      context.beginPath();
      for (const i of robots) {
        const trail = trails.of(i);
        const pose = poses[i];
        if (!trail || !pose || trail.x.length < 2) {
          continue;
        }
        const from = Math.floor((piece * trail.x.length) / PIECES);
        const to = Math.min(trail.x.length - 1, Math.floor(((piece + 1) * trail.x.length) / PIECES));
        let x = trail.x[from]!;
        let y = trail.y[from]!;
        context.moveTo(x, y);
        for (let at = from + 1; at <= to; at++) {
          const [nextX, nextY] = [trail.x[at]!, trail.y[at]!];
          if (!trail.driven[at]) {
            context.moveTo(nextX, nextY);
          } else if (at < to && Math.abs(nextX - x) + Math.abs(nextY - y) < near) {
            continue;
          } else {
            context.lineTo(nextX, nextY);
          }
          x = nextX;
          y = nextY;
        }
        if (piece === PIECES - 1) {
          context.lineTo(pose.x, pose.y);
        }
      }
      context.globalAlpha = STRONGEST * fading(piece / PIECES);
      context.stroke();
    }
  }
  context.globalAlpha = 1;
}
