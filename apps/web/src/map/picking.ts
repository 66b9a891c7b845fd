import type { RunInfo } from '../api/messages';
import type { MovedThing, Pose } from '../live/frame';
import type { Things } from '../live/things';
import type { Target } from './draft';
import { HANDLE_PIXELS, handleAhead, handleOf, heightOf, radius } from './layers/robots';
import { thingAt } from './layers/things';
import type { Pixel, View } from './view';

/** How near to a robot or handle a finger must be [px]. */
const TOUCH = 8;

/** What is on the map, where it was drawn last. */
export interface Shown {
  info: RunInfo | null;
  poses: readonly (Pose | null)[];
  things: Things;
  moved: Map<number, MovedThing>;
  view: View;
  /** The shorter side of the map [m]. */
  worldSide: number;
}

export function poseOf({ robot, thing }: Target, shown: Shown): Pose | null {
  return thing === undefined
    ? (shown.poses[robot] ?? null)
    : (shown.moved.get(thing)?.pose ?? shown.things.all.get(thing)?.pose ?? null);
}

/** The robot or thing at a pixel. */
export function bodyAt(at: Pixel, shown: Shown): Target | null {
  const { view } = shown;
  const robot = nearest(at, shown, (pose, i) => {
    const of = shown.info!.robots[i]!;
    const reach = radius(of.footprint, view.scale) * view.scale;
    return { ...pose, z: heightOf(of, view.scale) / 2, reach };
  });
  if (robot !== null) {
    return { robot };
  }
  const thing = thingAt(shown.things, shown.moved, at, view, TOUCH / 2 / view.scale, shown.worldSide);
  return thing === null ? null : { thing };
}

/** What has its handle for turning at a pixel: only what is selected has one. */
export function handleAt(at: Pixel, shown: Shown, robot: number | null, thing: number | null): Target | null {
  const { view } = shown;
  const pose = thing === null ? null : poseOf({ thing }, shown);
  if (pose && thing !== null) {
    const { reach } = shown.things.all.get(thing)!;
    const { px, py } = view.toPixel(handleAhead(pose, reach, view.scale));
    return Math.hypot(at.px - px, at.py - py) <= HANDLE_PIXELS + TOUCH ? { thing } : null;
  }
  const held = nearest(at, shown, (where, i) =>
    i === robot
      ? { ...handleOf(where, shown.info!.robots[i]!.footprint, view.scale), z: 0, reach: HANDLE_PIXELS }
      : null,
  );
  return held === null ? null : { robot: held };
}

/** The robot whose spot is under a pixel; of several, the one whose middle is nearest. */
function nearest(
  at: Pixel,
  { info, poses, view }: Shown,
  spot: (pose: Pose, robot: number) => { x: number; y: number; z: number; reach: number } | null,
): number | null {
  let best: number | null = null;
  let least = Infinity;
  info?.robots.forEach((_, i) => {
    const pose = poses[i];
    const place = pose && spot(pose, i);
    if (place) {
      const { px, py } = view.toPixel(place, place.z);
      const distance = Math.hypot(at.px - px, at.py - py);
      if (distance <= place.reach + TOUCH && distance < least) {
        best = i;
        least = distance;
      }
    }
  });
  return best;
}
