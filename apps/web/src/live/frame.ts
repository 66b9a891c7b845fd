/**
 * Decodes state frames. The layout is in docs/reference/live-protocol.md; the server's FrameEncoder writes it.
 * Ranges and particles stay views into the frame, so that a frame is decoded in one pass over its robots.
 */

const MAGIC = 0x4c415352;
const HEADER_BYTES = 40;
const ROBOT_BYTES = 16;
const THINGS_AT = 36;
const TURN = 2 * Math.PI;

const PAUSED = 1;
const STOPPED = 1 << 1;
const ENDED = 1 << 2;
const PAST = 1 << 3;
/** Above them is how often this page has looked elsewhere. */
const LOOKS_AT = 16;

const PRESENT = 1;
const STALLED = 1 << 1;
const TRUTH = 1 << 2;
const ESTIMATE = 1 << 3;
const GOAL = 1 << 4;
const PATH = 1 << 5;
const SCAN = 1 << 6;
const RANGES = 1 << 7;
const PARTICLES = 1 << 8;
const GRIPPER = 1 << 9;
const LIT = 1 << 10;
const ODOM = 1 << 11;
const ELSEWHERE = 1 << 12;
const SIDEWAYS = 1 << 13;
const LOCAL_PATH = 1 << 14;

const HOLDING = 1;

/** What a range may be instead of a distance. */
export const TOO_CLOSE = 0;
export const BROKEN = 0xfffe;
export const NOTHING = 0xffff;

/** Metres and radians, heading in [-π, π). */
export interface Pose {
  x: number;
  y: number;
  heading: number;
}

/** A belief about a pose, with the covariance of its position [m²] and the deviation of its heading [rad]. */
export interface Estimate {
  pose: Pose;
  headingDeviation: number;
  xx: number;
  xy: number;
  yy: number;
}

/** Where else a robot may be, with its share of the belief, from 0 to 1. */
export interface Hypothesis {
  pose: Pose;
  weight: number;
  xx: number;
  xy: number;
  yy: number;
}

/** Ranges count `unit` metres, counter-clockwise from `angleMin` in the laser's frame. */
export interface Scan {
  baseFromLaser: Pose;
  angleMin: number;
  angleIncrement: number;
  rangeMax: number;
  unit: number;
  ranges: Uint16Array;
}

/** Cones of single-range sensors, `fieldOfView` radians wide; `range` counts `unit` metres. */
export interface Cones {
  fieldOfView: number;
  rangeMax: number;
  unit: number;
  sensors: { baseFromSensor: Pose; range: number }[];
}

/** Four numbers a particle: x and y (counting `unit` metres from the origin), 1/65536 turns, weight (of the heaviest's 65535ths). */
export interface Particles {
  originX: number;
  originY: number;
  unit: number;
  count: number;
  values: Uint16Array;
}

export interface Gripper {
  /** How far the paddles are: 0 open, 1 closed. */
  closed: number;
  /** Its lift: 0 down, 1 up. */
  raised: number;
  holding: boolean;
}

export interface RobotState {
  /** The truth where it is known, else what the robot believes; `null` while nobody knows. */
  pose: Pose | null;
  isTruth: boolean;
  stalled: boolean;
  /** Forward [m/s], as its wheels measure it. */
  speed: number;
  /** To the left [m/s]; of omnidirectional bases. */
  sideways: number;
  /** Counter-clockwise [rad/s]. */
  turnRate: number;
  estimate: Estimate | null;
  goal: Pose | null;
  /** x, y [mm] of one point after the other. */
  path: Int32Array | null;
  /** Likewise, how it means to get on along that way next, from where it takes itself to be. */
  localPath: Int32Array | null;
  scan: Scan | null;
  cones: Cones | null;
  particles: Particles | null;
  gripper: Gripper | null;
  /** Whether its light shines. */
  lit: boolean;
  /** Where its localizer, or the truth where nothing localizes it, has the frame of its odometry on the map (REP 105). */
  odom: Pose | null;
  /** Where else than at the estimate its localizer holds possible that it is, the most likely first. */
  elsewhere: Hypothesis[];
}

/** A thing that is elsewhere than the server told when it came. */
export interface MovedThing {
  number: number;
  pose: Pose;
  /** Of its underside above the floor [m]. */
  height: number;
}

export interface Frame {
  run: number;
  sequence: number;
  paused: boolean;
  /** Emergency stop. */
  stopped: boolean;
  ended: boolean;
  /** Of a moment that is looked back on. */
  past: boolean;
  /** How often this page has looked elsewhere than at what follows: frames with another number do not follow. */
  looks: number;
  /** Simulated seconds. */
  time: number;
  /** Times real time, as asked for; Infinity is as fast as it can. */
  speed: number;
  /** Times real time, as measured. */
  rate: number;
  /** In the order of the run's robots. */
  robots: RobotState[];
  things: MovedThing[];
}

/** @throws RangeError or Error when the bytes are no frame */
export function decodeFrame(bytes: ArrayBuffer): Frame {
  const view = new DataView(bytes);
  if (view.getUint32(0, true) !== MAGIC) {
    throw new Error('These bytes are no state frame.');
  }
  const flags = view.getUint32(12, true);
  const count = view.getUint32(32, true);
  const reader = new Reader(view, HEADER_BYTES + count * ROBOT_BYTES);
  const robots: RobotState[] = [];
  for (let i = 0; i < count; i++) {
    robots.push(robotAt(view, HEADER_BYTES + i * ROBOT_BYTES, reader));
  }
  const things: MovedThing[] = [];
  for (let left = view.getUint32(THINGS_AT, true); left > 0; left--) {
    things.push({ number: reader.uint32(), pose: reader.pose(), height: reader.uint16() / 1000 });
  }
  return {
    run: view.getUint32(4, true),
    sequence: view.getUint32(8, true),
    paused: (flags & PAUSED) !== 0,
    stopped: (flags & STOPPED) !== 0,
    ended: (flags & ENDED) !== 0,
    past: (flags & PAST) !== 0,
    looks: flags >>> LOOKS_AT,
    time: view.getFloat64(16, true),
    speed: view.getFloat32(24, true),
    rate: view.getFloat32(28, true),
    robots,
    things,
  };
}

function robotAt(view: DataView, offset: number, blocks: Reader): RobotState {
  const fixed = new Reader(view, offset);
  const pose = fixed.pose();
  const speed = fixed.int16() / 1000;
  const turnRate = fixed.int16() / 1000;
  const flags = fixed.uint16();
  const has = (flag: number) => (flags & flag) !== 0;
  return {
    pose: has(PRESENT) ? pose : null,
    isTruth: has(TRUTH),
    stalled: has(STALLED),
    speed,
    turnRate,
    // in the order in which the frame has them
    estimate: has(ESTIMATE) ? estimate(blocks) : null,
    goal: has(GOAL) ? aligned(blocks) : null,
    path: has(PATH) ? path(blocks) : null,
    scan: has(SCAN) ? scan(blocks) : null,
    cones: has(RANGES) ? cones(blocks) : null,
    particles: has(PARTICLES) ? particles(blocks) : null,
    gripper: has(GRIPPER) ? gripper(blocks) : null,
    lit: has(LIT),
    odom: has(ODOM) ? aligned(blocks) : null,
    elsewhere: has(ELSEWHERE) ? elsewhere(blocks) : [],
    sideways: has(SIDEWAYS) ? sideways(blocks) : 0,
    localPath: has(LOCAL_PATH) ? path(blocks) : null,
  };
}

function estimate(reader: Reader): Estimate {
  return {
    pose: reader.pose(),
    headingDeviation: reader.int16() / 1000,
    xx: reader.float32(),
    xy: reader.float32(),
    yy: reader.float32(),
  };
}

function elsewhere(reader: Reader): Hypothesis[] {
  const all = [];
  for (let left = reader.uint32(); left > 0; left--) {
    all.push({
      pose: reader.pose(),
      weight: reader.uint16() / 0xffff,
      xx: reader.float32(),
      xy: reader.float32(),
      yy: reader.float32(),
    });
  }
  return all;
}

function aligned(reader: Reader): Pose {
  const pose = reader.pose();
  reader.align();
  return pose;
}

function sideways(reader: Reader): number {
  const speed = reader.int16() / 1000;
  reader.align();
  return speed;
}

function path(reader: Reader): Int32Array {
  return reader.int32s(2 * reader.uint32());
}

function scan(reader: Reader): Scan {
  const baseFromLaser = aligned(reader);
  return {
    baseFromLaser,
    angleMin: reader.float32(),
    angleIncrement: reader.float32(),
    rangeMax: reader.float32(),
    unit: reader.float32(),
    ranges: reader.uint16s(reader.uint32()),
  };
}

function cones(reader: Reader): Cones {
  const fieldOfView = reader.float32();
  const rangeMax = reader.float32();
  const unit = reader.float32();
  const count = reader.uint32();
  const sensors = [];
  for (let i = 0; i < count; i++) {
    sensors.push({ baseFromSensor: reader.pose(), range: reader.uint16() });
  }
  return { fieldOfView, rangeMax, unit, sensors };
}

function particles(reader: Reader): Particles {
  const originX = reader.float32();
  const originY = reader.float32();
  const unit = reader.float32();
  const count = reader.uint32();
  return { originX, originY, unit, count, values: reader.uint16s(4 * count) };
}

function gripper(reader: Reader): Gripper {
  const closed = reader.uint16() / 0xffff;
  const rest = reader.uint16();
  return { closed, raised: (rest >> 1) / 0x7fff, holding: (rest & HOLDING) !== 0 };
}

/** Reads little-endian values one after the other; arrays are views, which every browser's byte order allows. */
class Reader {
  constructor(
    private readonly view: DataView,
    private offset: number,
  ) {}

  private skip(bytes: number): number {
    const at = this.offset;
    this.offset += bytes;
    return at;
  }

  uint16 = () => this.view.getUint16(this.skip(2), true);
  int16 = () => this.view.getInt16(this.skip(2), true);
  uint32 = () => this.view.getUint32(this.skip(4), true);
  int32 = () => this.view.getInt32(this.skip(4), true);
  float32 = () => this.view.getFloat32(this.skip(4), true);

  pose(): Pose {
    return { x: this.int32() / 1000, y: this.int32() / 1000, heading: (this.int16() / 0x10000) * TURN };
  }

  uint16s(count: number): Uint16Array {
    const values = new Uint16Array(this.view.buffer, this.skip(2 * count), count);
    this.align();
    return values;
  }

  int32s(count: number): Int32Array {
    return new Int32Array(this.view.buffer, this.skip(4 * count), count);
  }

  /** To the next multiple of 4. */
  align() {
    this.offset = (this.offset + 3) & ~3;
  }
}
