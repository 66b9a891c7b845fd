import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect } from 'vitest';
import { chromium } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';
import { longTest, picture, visits } from './visits';
import { poseOf, type Place } from './world';
import type { Mounts } from '../src/api/messages';
import { texts } from '../src/texts';

const SCENARIO = fileURLToPath(new URL('layers.yaml', import.meta.url));

type Rgb = [number, number, number];

/** What becomes of the picture by a layer: where, and in which colors. */
interface Shown {
  /** Where it must be seen. */
  at: Place[];
  /** Where it may be seen. */
  within: (place: Place) => boolean;
  /** Each pixel is what was there before, mixed with those of one of these groups; one or two in each; see {@link isMixed}. */
  colors: Rgb[][];
}

/** A pixel that is another one with a layer. */
interface Changed extends Place {
  without: Rgb;
  with: Rgb;
}

describe.skipIf(!chromium)('each layer of the map', () => {
  const { openRun } = visits();
  let rsal: Rsal;
  let page: Page;
  let expected: Record<keyof typeof texts.layers, Shown>;
  let floor: Rgb;

  beforeAll(async () => {
    rsal = await Rsal.run(SCENARIO, '--port', '0');
    page = await openRun(rsal.url, { viewport: { width: 1400, height: 900 } });
    await page.locator('tr[data-robot="rover"]').click();
    const goal = { x: -1, y: -2.2 };
    await rsal.post('goal', { robot: 'rover', ...goal, heading: Math.PI / 2 });
    await eventually(async () => (await poseOf(page, 'rover')).x > -3.5, 'it is on its way');
    await rsal.post('pause');
    await page.getByTestId('time').getByText('x').waitFor({ state: 'detached' });
    await settled();
    floor = (await inks()).free!;
    expected = await all(goal);
    await picture(page, 'layers');
  });

  /** Of this moment: of a robot on its way, one that stands in another room, and one at the right that draws its map. */
  async function all(goal: Place): Promise<typeof expected> {
    const [rover, mate, scribe] = await Promise.all(
      ['rover', 'mate', 'scribe'].map((robot) => poseOf(page, robot)),
    );
    const robots = [rover!, mate!, scribe!];
    const orange: Rgb = [0xd5, 0x5e, 0x00];
    const blue: Rgb = [0x00, 0x72, 0xb2];
    const green: Rgb = [0x00, 0x9e, 0x73];
    const red: Rgb = [0xcc, 0x00, 0x33];
    const ink = await inks();
    const mounted = (await mountsOf('rover')).map(({ x, y, heading }) => {
      const sensor = { ...aside(aside(rover!, x), y, Math.PI / 2), heading: rover!.heading + heading };
      return aside(sensor, 0.05);
    });
    const pairs = [
      [orange, blue],
      [orange, green],
      [blue, green],
    ];
    const moving = [[orange], [green]];
    const near = (places: Place[], reach: number) => (at: Place) =>
      places.some((place) => distance(place, at) < reach);
    /** From a robot, at most so far to its left or right; or on it. */
    const ahead = (robot: (typeof robots)[0], { x, y }: Place, reach: number, angle: number) => {
      const away = distance(robot, { x, y });
      const bearing = Math.atan2(y - robot.y, x - robot.x) - robot.heading;
      return (
        away < 0.4 || (away < reach && Math.abs(Math.atan2(Math.sin(bearing), Math.cos(bearing))) < angle)
      );
    };
    const onMap = ({ x, y }: Place) => Math.abs(x) < 6.1 && Math.abs(y) < 5.1;
    const wall = { x: -3, y: -4.97 };
    return {
      floor: { at: [wall, { x: -3, y: -0.5 }], within: onMap, colors: [[ink.free!], [ink.occupied!]] },
      grid: { at: [], within: () => true, colors: [[ink.text!]] },
      map: { at: [{ x: 3.5, y: -1 }], within: onMap, colors: [[ink.drawn!, ink['drawn-wall']!]] },
      costs: { at: [wall], within: onMap, colors: [[ink.dear!], [ink.blocked!]] },
      scans: {
        at: [aside(rover!, 0.8), aside(mate!, 0.8), aside(scribe!, 0.8)],
        within: onMap,
        colors: pairs,
      },
      cones: {
        at: robots.map((robot) => aside(robot, 0.8)),
        within: (at) => robots.some((robot) => ahead(robot, at, 5.2, 1.9)),
        colors: pairs,
      },
      blobs: {
        at: [{ x: (rover!.x - 1) / 2, y: (rover!.y - 3.6) / 2 }],
        within: (at) => ahead(rover!, at, 3.5, 0.9),
        colors: [[red, ink.accent!]],
      },
      particles: {
        at: [],
        within: near([rover!, mate!], 1),
        colors: [
          [orange, ink.text!],
          [blue, ink.text!],
        ],
      },
      trails: {
        at: [{ x: -4.4, y: -2.5 }],
        within: ({ x, y }) => (x > -5.1 && x < rover!.x + 0.1 && y > -3 && y < -2) || x > 0.6,
        colors: moving,
      },
      paths: {
        at: [],
        within: ({ x, y }) => (x > -5.1 && x < goal.x + 0.2 && y > -3 && y < -1.7) || x > 0.6,
        colors: moving,
      },
      motion: {
        at: [aside(rover!, 0.35)],
        within: (at) => ahead(rover!, at, 2.2, 0.8) || ahead(scribe!, at, 2.2, 1.6),
        colors: moving,
      },
      goals: { at: [goal], within: (at) => distance(goal, at) < 0.5 || at.x > 0.6, colors: moving },
      estimates: { at: [], within: near(robots, 1), colors: robotsWith(ink.text!) },
      links: {
        at: [{ x: (rover!.x + mate!.x) / 2, y: (rover!.y + mate!.y) / 2 }],
        within: (at) => distance(rover!, at) + distance(at, mate!) < distance(rover!, mate!) + 0.05,
        colors: [[ink.accent!]],
      },
      axes: {
        at: [{ x: 0.1, y: 0 }, aside(rover!, 0.2), ...mounted],
        within: near([{ x: 0, y: 0 }, { x: -5, y: -2.5 }, rover!], 1.5),
        colors: [[0xd6, 0x28, 0x28] as Rgb, [0x12, 0x88, 0x3f] as Rgb, ink.text!].map((color) => [
          color,
          ink.halo!,
        ]),
      },
      names: {
        at: [],
        within: near([...robots, { x: -1, y: -3.6 }], 1),
        colors: [ink.text!, orange, blue, green].map((color) => [color, ink.halo!]),
      },
    };

    function robotsWith(other: Rgb) {
      return [orange, blue, green].map((color) => [color, other]);
    }
  }

  const distance = (a: Place, b: Place) => Math.hypot(a.x - b.x, a.y - b.y);

  /** So far ahead of a robot, or to another side of it [m, rad]. */
  const aside = <P extends Place & { heading: number }>(pose: P, far: number, turn = 0): P => ({
    ...pose,
    x: pose.x + far * Math.cos(pose.heading + turn),
    y: pose.y + far * Math.sin(pose.heading + turn),
  });

  /** Where its laser, its camera and each of its sonars are. */
  async function mountsOf(robot: string) {
    const { mounts } = (await (await fetch(`${rsal.origin}/api/mounts?robot=${robot}`)).json()) as Mounts;
    expect(new Set(mounts.map(({ device }) => device))).toEqual(new Set(['sonar', 'laser', 'camera']));
    expect(mounts).toHaveLength(8 + 1 + 1);
    return mounts;
  }

  /** Of the map's palette, by name. */
  const inks = (): Promise<Record<string, Rgb>> =>
    page.locator('#map').evaluate((node) => {
      const context = new OffscreenCanvas(1, 1).getContext('2d')!;
      const names = 'free occupied drawn drawn-wall dear blocked text halo accent'.split(' ');
      return Object.fromEntries(
        names.map((name) => {
          context.fillStyle = getComputedStyle(node).getPropertyValue(`--map-${name}`).trim();
          context.fillRect(0, 0, 1, 1);
          return [name, [...context.getImageData(0, 0, 1, 1).data].slice(0, 3) as Rgb];
        }),
      );
    });

  /** Keeps the map's picture as it is now. */
  const keep = (name: string) =>
    page.locator('#map').evaluate((node, name) => {
      const layers = [...node.querySelectorAll('canvas')];
      const { width, height } = layers[0]!;
      const context = new OffscreenCanvas(width, height).getContext('2d')!;
      layers.forEach((layer) => context.drawImage(layer, 0, 0));
      Object.assign(globalThis, { [name]: context.getImageData(0, 0, width, height) });
    }, name);

  /** Where two of those pictures differ. */
  async function differences(without: string, shown: string): Promise<Changed[]> {
    const map = page.locator('#map');
    const [scale, originX, originY] = (await Promise.all(
      ['scale', 'origin-x', 'origin-y'].map(async (name) => Number(await map.getAttribute(`data-${name}`))),
    )) as [number, number, number];
    const told = await page.evaluate(
      (names) => {
        const [a, b] = names.map((name) => (globalThis as unknown as Record<string, ImageData>)[name]!);
        const all: number[][] = [];
        const [before, after] = [a!.data, b!.data];
        const differs = (at: number) => Math.abs(before[at]! - after[at]!) > 2;
        for (let at = 0; at < before.length; at += 4) {
          if (differs(at) || differs(at + 1) || differs(at + 2)) {
            const colors = [...before.subarray(at, at + 3), ...after.subarray(at, at + 3)];
            all.push([(at / 4) % a!.width, Math.floor(at / 4 / a!.width), ...colors]);
          }
        }
        return JSON.stringify(all);
      },
      [without, shown],
    );
    return (JSON.parse(told) as number[][]).map(([px, py, ...values]) => ({
      x: (px! + 0.5 - originX) / scale,
      y: (originY - py! - 0.5) / scale,
      without: values.slice(0, 3) as Rgb,
      with: values.slice(3) as Rgb,
    }));
  }

  /** Waits until nothing is drawn any more. */
  async function settled() {
    await keep('before');
    await eventually(async () => {
      await page.waitForTimeout(700); // longer than the pauses between questions
      await keep('after');
      const changes = await differences('before', 'after');
      await keep('before');
      return changes.length === 0;
    }, 'the map stays as it is');
  }

  /** Walls, what a robot maps, and what it measures come first. */
  const names = new Set([
    'floor',
    'map',
    'scans',
    ...Object.keys(texts.layers),
  ] as (keyof typeof texts.layers)[]);

  longTest.each([...names])('is drawn: %s', async (name) => {
    const { at, within, colors } = expected[name];
    const chip = page.getByRole('button', { name: texts.layers[name], exact: true });
    const isOn = (await chip.getAttribute('aria-pressed')) === 'true';
    await keep(isOn ? 'shown' : 'without');
    await chip.click();
    await eventually(async () => {
      await keep('now');
      return (await differences(isOn ? 'shown' : 'without', 'now')).length > 20;
    }, 'it is seen');
    await settled();
    await picture(page, `layer-${name}`);
    await keep(isOn ? 'without' : 'shown');
    const changed = await differences('without', 'shown');

    for (const place of at) {
      expect(
        changed.some((pixel) => distance(pixel, place) < 0.03),
        `it is seen at (${String(place.x)}, ${String(place.y)})`,
      ).toBe(true);
    }
    expect(changed.filter((place) => !within(place)).slice(0, 3), 'elsewhere nothing changes').toEqual([]);
    const some = changed.filter((_, i) => i % Math.ceil(changed.length / 3000) === 0);
    const odd = some.filter((pixel) => !colors.some((group) => isMixed(pixel, floor, group)));
    expect(odd.length / some.length, `such as ${JSON.stringify(odd.slice(0, 3))}`).toBeLessThan(0.03);

    await chip.click();
    await eventually(async () => {
      await keep('again');
      return (await differences(isOn ? 'shown' : 'without', 'again')).length === 0;
    }, 'all is as it was');
  });
});

/**
 * Whether some of one color is added to a pixel, and of a second if there is one: to what was there before, or to the
 * floor under the soft edge of what is drawn above it.
 */
function isMixed({ without, with: seen }: Changed, floor: Rgb, [first, second]: Rgb[]): boolean {
  const STEPS = 20;
  const NEAR = 12;
  for (const under of [without, floor]) {
    for (let one = 0; one <= STEPS; one++) {
      for (let two = 0; two <= (second ? STEPS - one : 0); two++) {
        const isNear = seen.every((value, i) => {
          const added = one * (first![i]! - under[i]!) + two * ((second?.[i] ?? 0) - under[i]!);
          return Math.abs(value - without[i]! - added / STEPS) < NEAR;
        });
        if (isNear) {
          return true;
        }
      }
    }
  }
  return false;
}
