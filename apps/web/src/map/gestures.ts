import type { Pose } from '../live/frame';
import { wrap } from '../live/motion';
import type { Draft, Target } from './draft';
import type { Tape } from './scene';
import type { Pixel, Point, View } from './view';

/** What gestures see and do; the map, or a test. */
export interface Stage {
  view(): View;
  show(view: View): void;
  /** The same place, turned. */
  turn(view: View): void;
  /** Around which the map is turned. */
  middle(): Pixel;
  bodyAt(at: Pixel): Target | null;
  /** What has its handle for turning there. */
  handleAt(at: Pixel): Target | null;
  poseOf(target: Target): Pose | null;
  /** The robot that the next click sends somewhere. */
  aiming(): number | null;
  /** The robot that is selected. */
  selected(): number | null;
  mayAct(): boolean;
  /** Whether distances are measured now. */
  measuring(): boolean;
  tape(tape: Tape): void;
  select(target: Target | null): void;
  /** What can be done there. */
  menu(at: Pixel): void;
  draft(draft: Draft | null): void;
  /** The person let go of a draft: ask the server for it. */
  ask(draft: Draft): void;
}

/** What a button means: take hold of what is there, send the selected robot there if it is dragged, or turn the map. */
export type Wish = 'hold' | 'send' | 'turn';

type Gesture =
  | { kind: 'pan'; from: Pixel; moved: boolean }
  | { kind: 'rotate' }
  | { kind: 'measure'; from: Point }
  | { kind: 'body'; from: Pixel; target: Target; start: Pose; draft: Draft | null }
  | { kind: 'turn'; draft: Draft; moved: boolean }
  | { kind: 'aim'; from: Pixel; draft: Draft }
  | { kind: 'send'; from: Pixel; robot: number };

/** Farther than this is a drag, not a click [px]. */
const DRAG = 5;
const WHEEL = 0.0015;
/** Two fingers that turn less than this only zoom and move [rad]. */
const TWIST = 0.2;

/** Understands pointers: clicks, drags, pinches, twists. */
export class Gestures {
  private gesture: Gesture | null = null;
  private readonly pointers = new Map<number, Pixel>();
  private twisted = 0; // by the two fingers that are down [rad]

  constructor(private readonly stage: Stage) {}

  down(pointer: number, at: Pixel, wish: Wish = 'hold') {
    this.pointers.set(pointer, at);
    this.twisted = 0;
    if (this.pointers.size > 1) {
      this.cancel(); // a second finger: pinch
    } else {
      this.gesture = this.begin(at, wish);
    }
  }

  private begin(at: Pixel, wish: Wish): Gesture | null {
    const { stage } = this;
    if (wish === 'turn') {
      return { kind: 'rotate' };
    }
    if (wish === 'send') {
      const robot = stage.selected();
      return robot === null || !stage.mayAct() ? null : { kind: 'send', from: at, robot };
    }
    if (stage.measuring()) {
      const from = stage.view().toMap(at);
      stage.tape({ from, to: from });
      return { kind: 'measure', from };
    }
    const sent = stage.aiming();
    if (sent !== null && stage.mayAct()) {
      return this.aim(sent, at);
    }
    const turned = stage.handleAt(at);
    const held = turned ?? stage.bodyAt(at);
    const start = held === null ? null : stage.poseOf(held);
    if (held === null || start === null) {
      return { kind: 'pan', from: at, moved: false };
    }
    return turned === null
      ? { kind: 'body', from: at, target: held, start, draft: null }
      : { kind: 'turn', draft: { kind: 'place', target: held, pose: start }, moved: false };
  }

  private aim(robot: number, at: Pixel): Gesture {
    const { stage } = this;
    const target: Target = { robot };
    const draft: Draft = { kind: 'goal', target, pose: { ...stage.view().toMap(at), heading: 0 } };
    const from = stage.poseOf(target);
    if (from !== null) {
      draft.pose.heading = Math.atan2(draft.pose.y - from.y, draft.pose.x - from.x); // arrives as it came
    }
    stage.draft(draft);
    return { kind: 'aim', from: at, draft };
  }

  move(pointer: number, at: Pixel) {
    const before = this.pointers.get(pointer);
    if (!before) {
      return;
    }
    if (this.pointers.size === 2) {
      this.pinch(pointer, before, at);
    } else if (this.gesture) {
      this.drag(this.gesture, before, at);
    }
    this.pointers.set(pointer, at);
  }

  private drag(gesture: Gesture, before: Pixel, at: Pixel) {
    const { stage } = this;
    switch (gesture.kind) {
      case 'pan':
        gesture.moved ||= distance(gesture.from, at) > DRAG;
        if (gesture.moved) {
          stage.show(stage.view().panned(at.px - before.px, at.py - before.py));
        }
        break;
      case 'rotate':
        stage.turn(
          stage.view().turned(angleAround(stage.view(), stage.middle(), before, at), stage.middle()),
        );
        break;
      case 'measure':
        stage.tape({ from: gesture.from, to: stage.view().toMap(at) });
        break;
      case 'body':
        if (stage.mayAct() && (gesture.draft !== null || distance(gesture.from, at) > DRAG)) {
          const from = stage.view().toMap(gesture.from);
          const to = stage.view().toMap(at);
          const { start } = gesture;
          const pose = { x: start.x + to.x - from.x, y: start.y + to.y - from.y, heading: start.heading };
          gesture.draft = { kind: 'place', target: gesture.target, pose };
          stage.draft(gesture.draft);
        }
        break;
      case 'turn':
        gesture.moved = true;
        gesture.draft = { ...gesture.draft, pose: facing(gesture.draft.pose, stage.view(), at) };
        stage.draft(gesture.draft);
        break;
      case 'send':
        if (distance(gesture.from, at) > DRAG) {
          const aim = this.aim(gesture.robot, gesture.from);
          this.gesture = aim;
          this.drag(aim, before, at);
        }
        break;
      case 'aim':
        if (distance(gesture.from, at) > DRAG) {
          gesture.draft = { ...gesture.draft, pose: facing(gesture.draft.pose, stage.view(), at) };
          stage.draft(gesture.draft);
        }
    }
  }

  private pinch(pointer: number, before: Pixel, at: Pixel) {
    const { stage } = this;
    const [, other] = [...this.pointers].find(([id]) => id !== pointer)!;
    const factor = distance(at, other) / Math.max(1, distance(before, other));
    const middle = { px: (at.px + other.px) / 2, py: (at.py + other.py) / 2 };
    const twist = angleAround(stage.view(), other, before, at);
    const isTurning = Math.abs(this.twisted) > TWIST;
    this.twisted += twist;
    const panned = stage.view().panned((at.px - before.px) / 2, (at.py - before.py) / 2);
    const zoomed = panned.zoomed(factor, middle);
    stage.show(isTurning ? zoomed.turned(twist, middle) : zoomed);
  }

  up(pointer: number) {
    this.pointers.delete(pointer);
    const { gesture, stage } = this;
    this.gesture = null;
    switch (gesture?.kind) {
      case 'pan':
        if (!gesture.moved) {
          stage.select(null);
        }
        break;
      case 'body':
        if (gesture.draft === null) {
          stage.select(gesture.target);
        } else {
          stage.ask(gesture.draft);
        }
        break;
      case 'turn':
        if (gesture.moved) {
          stage.ask(gesture.draft);
        }
        break;
      case 'send':
        stage.menu(gesture.from);
        break;
      case 'aim':
        stage.ask(gesture.draft);
    }
    stage.draft(null);
  }

  wheel(delta: number, at: Pixel) {
    this.stage.show(this.stage.view().zoomed(Math.exp(-delta * WHEEL), at));
  }

  /** Forgets what was begun; nothing is asked for. */
  cancel() {
    this.gesture = null;
    this.stage.draft(null);
  }
}

function facing(pose: Pose, view: View, at: Pixel): Pose {
  const to = view.toMap(at);
  return { ...pose, heading: Math.atan2(to.y - pose.y, to.x - pose.x) };
}

/** How far one turns counter-clockwise on the floor, around a pixel from one to another [rad]. */
function angleAround(view: View, middle: Pixel, from: Pixel, to: Pixel): number {
  const centre = view.toMap(middle);
  const [a, b] = [view.toMap(from), view.toMap(to)];
  return wrap(Math.atan2(b.y - centre.y, b.x - centre.x) - Math.atan2(a.y - centre.y, a.x - centre.x));
}

function distance(a: Pixel, b: Pixel): number {
  return Math.hypot(a.px - b.px, a.py - b.py);
}
