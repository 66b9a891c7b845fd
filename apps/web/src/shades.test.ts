import { describe, expect, it } from 'vitest';
import { toOklab, withShades } from './shades';

const BLUE = '#0072b2';
const ORANGE = '#d55e00';

const shades = (color: string, count: number) =>
  withShades(Array.from({ length: count }, () => ({ color }))).map((robot) => robot.color);

/** Turns between two hues, at most half a one. */
function hueDistance(one: string, other: string): number {
  const [a, b] = [one, other].map((color) => {
    const [, x, y] = toOklab(color);
    return Math.atan2(y, x) / (2 * Math.PI);
  }) as [number, number];
  const distance = Math.abs(a - b) % 1;
  return Math.min(distance, 1 - distance);
}

describe.each([BLUE, ORANGE])('robots of the color %s', (color) => {
  it('differ in lightness, as the color-blind see it, too', () => {
    const lightness = shades(color, 8)
      .map((shade) => toOklab(shade)[0])
      .sort((a, b) => a - b);
    for (let i = 1; i < lightness.length; i++) {
      expect(lightness[i]! - lightness[i - 1]!).toBeGreaterThan(0.025);
    }
  });

  it('differ much while they are few', () => {
    const [darkest, middle, lightest] = shades(color, 3)
      .map((shade) => toOklab(shade)[0])
      .sort((a, b) => a - b);
    expect(middle! - darkest!).toBeGreaterThan(0.1);
    expect(lightest! - middle!).toBeGreaterThan(0.1);
  });

  it('keep the hue, by which their role is known', () => {
    for (const shade of shades(color, 8)) {
      expect(hueDistance(shade, color)).toBeLessThan(0.06);
    }
  });
});

it('the first of each role has the color of its role', () => {
  const robots = [{ color: ORANGE }, { color: BLUE }, { color: BLUE }];
  const shaded = withShades(robots);
  expect(shaded[0]!.color).toBe(ORANGE);
  expect(shaded[1]!.color).toBe(BLUE);
  expect(shaded[2]!.color).not.toBe(BLUE);
});
