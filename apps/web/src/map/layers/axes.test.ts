import { describe, expect, it } from 'vitest';
import type { RunInfo } from '../../api/messages';
import type { Frame, RobotState } from '../../live/frame';
import { axesOf } from './axes';

const info = { robots: [{ id: 'ann' }, { id: 'bob' }] } as RunInfo;
const pose = { x: 1, y: 2, heading: Math.PI / 2 };
const believed = { x: 1.1, y: 2, heading: 1.5 };

function frameOf(state: Partial<RobotState>): Frame {
  return { robots: [{}, { estimate: null, odom: null, ...state }] } as Frame;
}

describe('frames', () => {
  it('are the map alone while no robot is selected, or nobody knows where it is', () => {
    const names = (selected: number | null, known: typeof pose | null) =>
      axesOf({ info, frame: frameOf({}), poses: [null, known], mounts: [], selected }).map(
        ({ name }) => name,
      );
    expect(names(null, pose)).toEqual(['map']);
    expect(names(1, null)).toEqual(['map']);
    expect(names(1, pose)).toEqual(['map', 'bob/base_link']);
  });

  it('of a robot are those whose poses are known, devices where they are on the base', () => {
    const mounts = [{ device: 'laser', x: 0.2, y: 0, heading: 0.1 }];
    const estimate = { pose: believed } as RobotState['estimate'];
    const odom = { x: -3, y: 0, heading: 0.5 };
    const all = axesOf({
      info,
      frame: frameOf({ estimate, odom }),
      poses: [null, pose],
      mounts,
      selected: 1,
    });
    expect(all.map(({ name }) => name)).toEqual(['map', 'bob/base_link', 'laser', 'bob/odom', 'estimate']);
    expect(all[2]!.pose.x).toBeCloseTo(1);
    expect(all[2]!.pose.y).toBeCloseTo(2.2);
    expect(all[2]!.pose.heading).toBeCloseTo(Math.PI / 2 + 0.1);
    expect(all[3]!.pose).toEqual(odom);
    expect(all[4]!.pose).toEqual(believed);
  });

  it('of a device with several sensors are small, and named once', () => {
    const mount = (device: string, x: number) => ({ device, x, y: 0, heading: 0 });
    const mounts = [mount('sonar', 0), mount('sonar', 0.1), mount('laser', 0.2)];
    const all = axesOf({ info, frame: frameOf({}), poses: [null, pose], mounts, selected: 1 }).slice(2);
    expect(all.map(({ name, small }) => [name, small])).toEqual([
      ['sonar', true],
      ['', true],
      ['laser', false],
    ]);
  });
});
