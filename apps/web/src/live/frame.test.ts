import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { BROKEN, decodeFrame, NOTHING, TOO_CLOSE, type Frame } from './frame';

/** Written by the server's FrameEncoderTest. */
function golden(): ArrayBuffer {
  const file = readFileSync(new URL('./fixtures/frame.bin', import.meta.url));
  return new Uint8Array(file).buffer;
}

describe('a frame', () => {
  const frame: Frame = decodeFrame(golden());
  const [full, bare, gone] = frame.robots;

  it('says which run and moment it shows', () => {
    expect(frame).toMatchObject({ run: 3, sequence: 17, paused: true, stopped: true, ended: true });
    expect(frame.time).toBeCloseTo(12.3);
    expect(frame.speed).toBe(Infinity);
    expect(frame.rate).toBe(42.5);
  });

  it('has each robot where it is', () => {
    expect(full?.pose?.x).toBeCloseTo(-12.345, 3);
    expect(full?.pose?.y).toBeCloseTo(6.789, 3);
    expect(full?.pose?.heading).toBeCloseTo(-2.5, 3);
    expect(full).toMatchObject({ isTruth: true, stalled: true, speed: 0.4, sideways: -0.1, turnRate: -0.25 });
  });

  it('has what a localizer believes', () => {
    expect(full?.estimate?.pose.heading).toBeCloseTo(3, 3);
    expect(full?.estimate).toMatchObject({ headingDeviation: 0.2, xx: 0.25, xy: 0.125, yy: 0.5 });
  });

  it('has goal, path and how the robot means to get on along that', () => {
    expect(full?.goal?.y).toBeCloseTo(-1.5, 3);
    expect(full?.goal?.heading).toBeCloseTo(0.75, 3);
    expect([...(full?.path ?? [])]).toEqual([-12300, 6800, 0, -1500]);
    expect([...(full?.localPath ?? [])]).toEqual([-12300, 6800, -12700, 6400, -12900, 5900]);
  });

  it('has the scan, with what is no distance', () => {
    expect(full?.scan?.baseFromLaser.y).toBeCloseTo(-0.05, 3);
    expect(full?.scan).toMatchObject({ angleMin: -1.5, angleIncrement: 0.5, rangeMax: 4 });
    expect(full?.scan?.unit).toBeCloseTo(0.001, 6);
    expect([...(full?.scan?.ranges ?? [])]).toEqual([1234, NOTHING, TOO_CLOSE, BROKEN, 4000]);
  });

  it('has sonars that reach farther than millimetres do', () => {
    const { sensors, unit, fieldOfView } = full!.cones!;
    expect(fieldOfView).toBe(0.5);
    expect(sensors[0]!.range * unit).toBeCloseTo(40, 2);
    expect(sensors[0]!.baseFromSensor.heading).toBeCloseTo(1, 3);
    expect(sensors[1]!.range).toBe(NOTHING);
  });

  it('has particles', () => {
    const { count, originX, originY, unit, values } = full!.particles!;
    expect(count).toBe(2);
    expect(originX + values[4]! * unit).toBeCloseTo(1.5, 3);
    expect(originY + values[5]! * unit).toBeCloseTo(2.25, 3);
    expect(values[7]).toBe(65535);
    expect(values[3]! / values[7]!).toBeCloseTo(1 / 3, 3);
  });

  it('has gripper and light', () => {
    expect(full?.gripper?.closed).toBeCloseTo(0.25, 4);
    expect(full?.gripper?.raised).toBeCloseTo(0.5, 4);
    expect(full).toMatchObject({ gripper: { holding: true }, lit: true });
    expect(bare).toMatchObject({ gripper: null, lit: false });
  });

  it('has the frame of odometry where the localizer has it', () => {
    expect(full?.odom?.x).toBeCloseTo(-10.302, 3);
    expect(full?.odom?.y).toBeCloseTo(7.804, 3);
    expect(full?.odom?.heading).toBeCloseTo(2.5, 3);
    expect(bare?.odom).toBeNull();
  });

  it('has where else a robot may be', () => {
    expect(full?.elsewhere).toHaveLength(2);
    expect(full?.elsewhere[0]).toMatchObject({ xx: 1, xy: 0.5, yy: 2 });
    expect(full?.elsewhere[0]?.pose.x).toBeCloseTo(4, 3);
    expect(full?.elsewhere[0]?.weight).toBeCloseTo(0.25, 4);
    expect(full?.elsewhere[1]?.pose.x).toBeCloseTo(5, 3);
    expect(bare?.elsewhere).toEqual([]);
  });

  it('has things that were moved, and how high they are', () => {
    expect(frame.things.map(({ number }) => number)).toEqual([4, 70000]);
    expect(frame.things[0]?.pose.x).toBeCloseTo(-1.5, 3);
    expect(frame.things[0]?.pose.y).toBeCloseTo(2.25, 3);
    expect(frame.things[0]?.pose.heading).toBeCloseTo(1, 3);
    expect(frame.things.map(({ height }) => height)).toEqual([0.125, 65.535]);
  });

  it('leaves out what is not known', () => {
    expect(bare).toMatchObject({
      pose: { x: 1, y: 2, heading: 0 },
      estimate: null,
      goal: null,
      path: null,
      localPath: null,
      scan: null,
      cones: null,
      particles: null,
    });
    expect(gone?.pose).toBeNull();
  });

  it('is refused when it is something else, or cut off', () => {
    expect(() => decodeFrame(new ArrayBuffer(64))).toThrow('no state frame');
    for (let length = 0; length < golden().byteLength; length++) {
      expect(() => decodeFrame(golden().slice(0, length)), `${length} bytes`).toThrow();
    }
  });
});
