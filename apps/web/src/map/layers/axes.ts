import type { Pose } from '../../live/frame';
import { compose } from './frames';
import { overlap, type Box } from '../labels';
import type { Layer, Scene } from '../scene';
import { boxesOf } from './names';

/** An axis is at least this long [px], and as long as this on a large scale [m]. */
const LEAST_PIXELS = 26;
const LENGTH = 0.3;
/** Where several stand close together, they are shorter. */
const SMALL = 0.4;
/** x red, y green, as usual. */
const X = '#d62828';
const Y = '#12883f';
/** How high a name is, and what is left free beside it [px]. */
const HEIGHT = 13;
const GAP = 6;
const FONT = '600 11px system-ui, sans-serif';

/** A frame, by its name and its pose in the map frame. */
export interface Axes {
  name: string;
  pose: Pose;
  /** Whether it is one of several that stand close together. */
  small?: boolean;
}

const hiding = (box: Box, others: readonly Box[]) => others.find((other) => overlap(box, other) > 0);

/**
 * The frames that are known of a robot: the map's, its base's and its devices' as they are, its odometry's, and its base's
 * as it is believed to be. A device with several sensors has its name at the first of them.
 */
export function axesOf({
  info,
  frame,
  poses,
  mounts,
  selected,
}: Pick<Scene, 'info' | 'frame' | 'poses' | 'mounts' | 'selected'>): Axes[] {
  const all: Axes[] = [{ name: 'map', pose: { x: 0, y: 0, heading: 0 } }];
  const pose = selected === null ? null : (poses[selected] ?? null);
  if (selected === null || pose === null) {
    return all;
  }
  const { id } = info.robots[selected]!;
  const { estimate, odom } = frame.robots[selected]!;
  all.push({ name: `${id}/base_link`, pose });
  mounts.forEach((mount, i) => {
    const isNext = mount.device === mounts[i - 1]?.device;
    all.push({
      name: isNext ? '' : mount.device,
      pose: compose(pose, mount),
      small: isNext || mount.device === mounts[i + 1]?.device,
    });
  });
  if (odom) {
    all.push({ name: `${id}/odom`, pose: odom });
  }
  if (estimate) {
    all.push({ name: 'estimate', pose: estimate.pose });
  }
  return all;
}

/** Axes of frames, on the floor: x and y, with the frame's name at its origin, or below what is written there. */
export const drawAxes: Layer = (context, scene) => {
  const { view, palette } = scene;
  const whole = Math.max(LENGTH, LEAST_PIXELS / view.scale);
  context.save();
  view.leave(context);
  context.lineCap = 'round';
  context.textBaseline = 'top';
  const all = axesOf(scene);
  for (const { pose, small } of all) {
    const origin = view.toPixel(pose);
    const length = small ? SMALL * whole : whole;
    for (const [color, angle] of [
      [X, pose.heading],
      [Y, pose.heading + Math.PI / 2],
    ] as const) {
      const end = { x: pose.x + length * Math.cos(angle), y: pose.y + length * Math.sin(angle) };
      const { px, py } = view.toPixel(end);
      for (const [ink, width] of [
        [palette.halo, 4.5],
        [color, 2.5],
      ] as const) {
        context.beginPath();
        context.moveTo(origin.px, origin.py);
        context.lineTo(px, py);
        context.strokeStyle = ink;
        context.lineWidth = width;
        context.stroke();
      }
    }
  }
  const written: Box[] = boxesOf(context, scene);
  context.font = FONT;
  for (const { name, pose } of all.filter((axes) => axes.name !== '')) {
    const { px, py } = view.toPixel(pose);
    const width = context.measureText(name).width + GAP;
    const box = { x: px + 5, y: py + 4, width, height: HEIGHT };
    for (let under = hiding(box, written); under; under = hiding(box, written)) {
      box.y = under.y + under.height;
    }
    written.push(box);
    context.lineWidth = 3;
    context.strokeStyle = palette.halo;
    context.strokeText(name, box.x, box.y);
    context.fillStyle = palette.text;
    context.fillText(name, box.x, box.y);
  }
  context.restore();
};
