import { beforeEach, describe, expect, it } from 'vitest';
import type { Draft, Target } from './draft';
import { Gestures, type Stage } from './gestures';
import type { Tape } from './scene';
import { View, type Pixel } from './view';

const robot = { x: 1, y: 1, heading: 0.5 };
const onRobot = { px: 20, py: -20 };
const onHandle = { px: 40, py: -20 };
const onThing = { px: 60, py: -60 };
const thing = { x: 3, y: 3, heading: 1 };
const onFloor = { px: 200, py: -200 };

class FakeStage implements Stage {
  shown = new View(20, 0, 0);
  aimed: number | null = null;
  allowed = true;
  selects: (Target | null)[] = [];
  drafts: (Draft | null)[] = [];
  asked: Draft[] = [];
  menus: Pixel[] = [];

  view = () => this.shown;
  show = (view: View) => void (this.shown = view);
  turn = (view: View) => void (this.shown = view);
  middle = (): Pixel => ({ px: 200, py: 200 });
  bodyAt = (at: Pixel): Target | null =>
    at === onRobot ? { robot: 0 } : at === onThing ? { thing: 7 } : null;
  handleAt = (at: Pixel): Target | null => (at === onHandle ? { robot: 0 } : null);
  poseOf = (target: Target) => (target.thing === undefined ? robot : thing);
  aiming = () => this.aimed;
  sent: number | null = null;
  selected = () => this.sent;
  mayAct = () => this.allowed;
  isMeasuring = false;
  tapes: Tape[] = [];
  measuring = () => this.isMeasuring;
  tape = (tape: Tape) => void this.tapes.push(tape);
  select = (target: Target | null) => void this.selects.push(target);
  menu = (at: Pixel) => void this.menus.push(at);
  draft = (draft: Draft | null) => void this.drafts.push(draft);
  ask = (draft: Draft) => void this.asked.push(draft);
}

describe('a pointer', () => {
  let stage: FakeStage;
  let gestures: Gestures;

  beforeEach(() => {
    stage = new FakeStage();
    gestures = new Gestures(stage);
  });

  function drag(from: Pixel, to: Pixel) {
    gestures.down(1, from);
    gestures.move(1, to);
    gestures.up(1);
  }

  it('measures, even over robots, and moves nothing meanwhile', () => {
    stage.isMeasuring = true;
    drag(onRobot, { px: 80, py: -100 });
    expect(stage.tapes.at(-1)).toEqual({ from: { x: 1, y: 1 }, to: { x: 4, y: 5 } });
    expect(stage.selects).toEqual([]);
    expect(stage.asked).toEqual([]);
    expect(stage.shown.originX).toBe(0);
  });

  it('clicks a robot to select it, and the floor to let go', () => {
    drag(onRobot, { px: 22, py: -21 });
    drag(onFloor, { px: 201, py: -200 });
    expect(stage.selects).toEqual([{ robot: 0 }, null]);
    expect(stage.asked).toEqual([]);
  });

  it('drags the floor to move the map', () => {
    drag(onFloor, { px: 230, py: -190 });
    expect(stage.shown).toEqual(new View(20, 30, 10));
    expect(stage.selects).toEqual([]);
  });

  it('drags a robot to place it, heading as it was', () => {
    drag(onRobot, { px: 60, py: -40 });
    expect(stage.asked).toEqual([
      { kind: 'place', target: { robot: 0 }, pose: { x: 3, y: 2, heading: 0.5 } },
    ]);
    expect(stage.drafts.at(-1)).toBeNull();
  });

  it('clicks and drags things as it does robots', () => {
    drag(onThing, { px: 62, py: -60 });
    expect(stage.selects).toEqual([{ thing: 7 }]);
    drag(onThing, { px: 80, py: -60 });
    expect(stage.asked).toEqual([{ kind: 'place', target: { thing: 7 }, pose: { x: 4, y: 3, heading: 1 } }]);
  });

  it('drags a handle to turn a robot where it stands', () => {
    drag(onHandle, { px: 20, py: -60 });
    expect(stage.asked).toEqual([
      { kind: 'place', target: { robot: 0 }, pose: { x: 1, y: 1, heading: Math.PI / 2 } },
    ]);
  });

  it('moves no robot when it may only watch', () => {
    stage.allowed = false;
    stage.aimed = 0;
    drag(onRobot, { px: 60, py: -40 });
    expect(stage.asked).toEqual([]);
  });

  it('clicks where a robot is to go, arriving as it came', () => {
    stage.aimed = 0;
    drag({ px: 80, py: -80 }, { px: 81, py: -80 });
    expect(stage.asked).toEqual([
      { kind: 'goal', target: { robot: 0 }, pose: { x: 4, y: 4, heading: Math.PI / 4 } },
    ]);
  });

  it('drags from a goal to set its heading', () => {
    stage.aimed = 0;
    drag({ px: 80, py: -80 }, { px: 80, py: 0 });
    expect(stage.asked).toEqual([
      { kind: 'goal', target: { robot: 0 }, pose: { x: 4, y: 4, heading: -Math.PI / 2 } },
    ]);
  });

  it('sends the selected robot by the other button where it was pressed, headed as it is dragged', () => {
    const send = (from: Pixel, to: Pixel) => {
      gestures.down(1, from, 'send');
      gestures.move(1, to);
      gestures.up(1);
    };
    stage.sent = 0;
    send({ px: 80, py: -80 }, { px: 80, py: 0 });
    send(onThing, { px: 20, py: -60 }); // over a thing, too
    const goal = (x: number, heading: number) => ({
      kind: 'goal',
      target: { robot: 0 },
      pose: { x, y: x, heading },
    });
    expect(stage.asked).toEqual([goal(4, -Math.PI / 2), goal(3, Math.PI)]);
    expect(stage.selects).toEqual([]);
    expect(stage.menus).toEqual([]);
    expect(stage.shown.originX).toBe(0);
  });

  it('offers what can be done where the other button is clicked, and sends nobody', () => {
    stage.sent = 0;
    gestures.down(1, onFloor, 'send');
    gestures.move(1, { px: onFloor.px + 1, py: onFloor.py });
    gestures.up(1);
    expect(stage.asked).toEqual([]);
    expect(stage.menus).toEqual([onFloor]);
    expect(stage.drafts.every((draft) => draft === null)).toBe(true);
  });

  it('sends nobody when nobody is selected, or when it may only watch', () => {
    for (const [sent, allowed] of [
      [null, true],
      [0, false],
    ] as const) {
      stage.sent = sent;
      stage.allowed = allowed;
      gestures.down(1, onFloor, 'send');
      gestures.move(1, { px: 300, py: -300 });
      gestures.up(1);
    }
    expect(stage.asked).toEqual([]);
    expect(stage.drafts.every((draft) => draft === null)).toBe(true);
  });

  it('sends nobody when it was cancelled meanwhile', () => {
    stage.sent = 0;
    gestures.down(1, onFloor, 'send');
    gestures.move(1, { px: 300, py: -300 });
    gestures.cancel();
    gestures.move(1, { px: 350, py: -300 });
    gestures.up(1);
    expect(stage.asked).toEqual([]);
    expect(stage.drafts.at(-1)).toBeNull();
  });

  it('asks for nothing that was cancelled', () => {
    gestures.down(1, onRobot);
    gestures.move(1, { px: 60, py: -40 });
    gestures.cancel();
    gestures.up(1);
    expect(stage.asked).toEqual([]);
    expect(stage.drafts.at(-1)).toBeNull();
  });

  it('pinches with two fingers', () => {
    gestures.down(1, { px: 100, py: 100 });
    gestures.down(2, { px: 200, py: 100 });
    gestures.move(2, { px: 300, py: 100 });
    expect(stage.shown.scale).toBeCloseTo(40);
    gestures.up(2);
    gestures.up(1);
    expect(stage.selects).toEqual([]);
  });

  it('turns the map under it, around the middle', () => {
    const middle = stage.shown.toMap(stage.middle());
    const grabbed = stage.shown.toMap({ px: 300, py: 200 });
    gestures.down(1, { px: 300, py: 200 }, 'turn');
    gestures.move(1, { px: 280, py: 130 });
    gestures.move(1, { px: 200, py: 100 }); // from the right to above
    gestures.up(1);
    expect(stage.shown.turn).toBeCloseTo(Math.PI / 2);
    expect(stage.shown.toPixel(middle).px).toBeCloseTo(200);
    expect(stage.shown.toPixel(grabbed).px).toBeCloseTo(200);
    expect(stage.shown.toPixel(grabbed).py).toBeCloseTo(100);
    expect(stage.selects).toEqual([]);
  });

  it('turns with two fingers that twist enough', () => {
    gestures.down(1, { px: 100, py: 100 });
    gestures.down(2, { px: 200, py: 100 });
    gestures.move(2, { px: 200, py: 110 });
    expect(stage.shown.turn).toBe(0);
    gestures.move(2, { px: 190, py: 140 });
    const before = stage.shown.turn;
    gestures.move(2, { px: 100, py: 200 });
    expect(stage.shown.turn).toBeLessThan(before - 0.8);
    gestures.up(2);
    gestures.up(1);
    expect(stage.asked).toEqual([]);
  });

  it('places a robot where it is dragged on a turned map', () => {
    stage.shown = new View(20, 0, 0, { turn: Math.PI / 2, oblique: false }); // x is up, y to the left
    drag(onRobot, { px: onRobot.px + 40, py: onRobot.py });
    const { x, y, heading } = stage.asked[0]!.pose;
    expect([x, y, heading]).toEqual([1, -1, 0.5].map((value) => expect.closeTo(value) as number));
  });

  it('wheels to zoom where it is', () => {
    const before = stage.shown.toMap({ px: 50, py: 60 });
    gestures.wheel(-300, { px: 50, py: 60 });
    expect(stage.shown.scale).toBeGreaterThan(25);
    expect(stage.shown.toMap({ px: 50, py: 60 }).x).toBeCloseTo(before.x);
  });
});
