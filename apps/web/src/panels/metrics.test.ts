import { describe, expect, it } from 'vitest';
import type { Ending, MetricInfo } from '../api/messages';
import { boundOf, measured, ofRobots, ofRun } from './metrics';

const metrics: MetricInfo[] = [
  { name: 'captureTime', unit: 's', min: null, max: null },
  { name: 'error', unit: 'm', min: null, max: 0.3 },
  { name: 'way', unit: 'm', min: 5, max: null },
  { name: 'collisions', unit: '', min: 1, max: 3 },
];

const ending = {
  metrics: {
    captureTime: null,
    'error.prey-1': 0.41234,
    'error.hunter-1': 0.1,
    'way.hunter-1': 12,
    collisions: 2278,
  },
  outOfBounds: ['error.prey-1', 'collisions'],
} as unknown as Ending;

describe('metrics', () => {
  it('of the whole run are apart from those of each robot', () => {
    expect(ofRun(ending, metrics)).toEqual(['captureTime', 'collisions']);
    expect(ofRobots(ending, metrics)).toEqual({
      names: ['error', 'way'],
      rows: [
        { robot: 'prey-1', of: ['error.prey-1', 'way.prey-1'] },
        { robot: 'hunter-1', of: ['error.hunter-1', 'way.hunter-1'] },
      ],
    });
  });

  it('have their unit; counts have all digits, others three', () => {
    expect(measured('error.prey-1', ending, metrics)).toBe('0.412 m');
    expect(measured('collisions', ending, metrics)).toBe('2278');
    expect(measured('captureTime', ending, metrics)).toBe('not measured');
    expect(measured('way.prey-1', ending, metrics)).toBe('');
  });

  it('have the bounds that the scenario gives', () => {
    expect(boundOf('error.prey-1', metrics)).toBe('at most 0.3 m');
    expect(boundOf('way.hunter-1', metrics)).toBe('at least 5 m');
    expect(boundOf('collisions', metrics)).toBe('1 to 3');
    expect(boundOf('captureTime', metrics)).toBe('');
  });
});
