import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { beforeAll, beforeEach, describe, expect, it } from 'vitest';
import { chromium } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';
import { expectAccessible, longTest, picture, visits } from './visits';
import { colorAt, drag, onScreen, poseOf, type Place } from './world';

const HALL = fileURLToPath(new URL('driving.world', import.meta.url));

describe.skipIf(!chromium)('the view of the world', () => {
  const { close, openRun } = visits();
  let rsal: Rsal;
  let page: Page;

  beforeAll(async () => {
    rsal = await Rsal.run(HALL, '--port', '0');
  });

  beforeEach(async () => {
    await rsal.post('restart', {});
    page = await opened(1280, 800);
  });

  const opened = (width: number, height: number, colorScheme: 'light' | 'dark' = 'light') =>
    openRun(rsal.url, { viewport: { width, height }, colorScheme });

  const map = () => page.locator('#map');
  const numberOf = async (name: string) => Number(await map().getAttribute(`data-${name}`));

  const pose = (robot: string) => poseOf(page, robot);

  async function isAt(robot: string, { x, y }: Place): Promise<boolean> {
    const now = await pose(robot);
    return Math.hypot(now.x - x, now.y - y) < 0.15;
  }

  const WHITE = [255, 255, 255];

  longTest('is turned by keys and back, and all stays where it is drawn', async () => {
    await page.getByRole('button', { name: 'Grid' }).click();
    await page.getByRole('button', { name: 'Scans' }).click();
    const back = page.getByRole('button', { name: 'Reset the rotation' });
    expect(await back.isDisabled()).toBe(true);
    for (let press = 0; press < 3; press++) {
      await page.keyboard.press('Shift+ArrowLeft');
    }
    expect(await numberOf('turn')).toBeCloseTo(Math.PI / 4);
    // the pillar in the middle, to its corners, and the floor beside it
    for (const place of [
      { x: 0.4, y: 0.4 },
      { x: -0.4, y: 0.4 },
      { x: 0.4, y: -0.4 },
    ]) {
      expect(await colorAt(page, place)).not.toEqual(WHITE);
    }
    expect(await colorAt(page, { x: 0.8, y: 0 })).toEqual(WHITE);
    await page.keyboard.press('0');
    await picture(page, 'turned');
    expect(await numberOf('turn')).toBeCloseTo(Math.PI / 4);
    await drag(page, await pose('idle'), { x: -3, y: 2 });
    await eventually(() => isAt('idle', { x: -3, y: 2 }), 'it is where it was dragged');
    const at = await onScreen(page, await pose('idle'));
    await page.mouse.click(at.x, at.y);
    await page.locator('tr.card').waitFor();
    await expectAccessible(page);
    await back.click();
    expect(await numberOf('turn')).toBe(0);
  });

  longTest('is turned by dragging with Alt, around the robot that is followed, too', async () => {
    await page.locator('tr[data-robot="idle"]').click();
    await page.keyboard.press('f');
    const box = (await map().boundingBox())!;
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.keyboard.down('Alt');
    await page.mouse.move(x + 150, y);
    await page.mouse.down();
    await page.mouse.move(x + 140, y - 60);
    await page.mouse.move(x, y - 150);
    await page.mouse.up();
    await page.keyboard.up('Alt');
    expect(await numberOf('turn')).toBeCloseTo(Math.PI / 2);
    await eventually(async () => {
      const at = await onScreen(page, await pose('idle'));
      return Math.hypot(at.x - x, at.y - y) < 2;
    }, 'it is still in the middle');
    await page.keyboard.press('n');
    expect(await numberOf('turn')).toBe(0);
  });

  longTest('sends the selected robot by the right button, headed as it is dragged', async () => {
    const goal = page.locator('li', { hasText: 'operator' });
    const sent: unknown[] = [];
    page.on('request', (request) => {
      if (request.url().endsWith('/api/run/goal')) {
        sent.push(request.postDataJSON());
      }
    });
    await page.keyboard.press('Shift+ArrowLeft'); // on a turned map, as on any
    await page.locator('tr[data-robot="idle"]').click();
    const [start, end] = [await onScreen(page, { x: -3, y: -2 }), await onScreen(page, { x: -3, y: 1 })];
    await page.mouse.move(start.x, start.y);
    await page.mouse.down({ button: 'right' });
    await page.mouse.move(start.x, start.y - 20);
    await page.mouse.move(end.x, end.y);
    await page.getByText(/^-(3\.0|2\.9)\d, -(2\.0|1\.9)\d m, (89|90|91)°$/).waitFor();
    await picture(page, 'right-drag');
    await page.keyboard.press('Escape');
    await page.mouse.up({ button: 'right' });
    expect(sent).toEqual([]);
    expect(await page.getByRole('menu').count()).toBe(0);

    await drag(page, { x: -3, y: -2 }, { x: -3, y: 1 }, 'right');
    await eventually(() => Promise.resolve(sent.length === 1), 'it was sent');
    const told = sent[0] as { robot: string; x: number; y: number; heading: number };
    expect(told.robot).toBe('idle');
    expect(told.x).toBeCloseTo(-3, 1);
    expect(told.y).toBeCloseTo(-2, 1);
    expect(told.heading).toBeCloseTo(Math.PI / 2, 1);
    expect(await page.getByRole('menu').count()).toBe(0);
    await goal.first().waitFor();
    await eventually(async () => {
      const now = await pose('idle');
      return Math.hypot(now.x + 3, now.y + 2) < 0.5 && Math.abs(now.heading - Math.PI / 2) < 0.4;
    }, 'it has arrived, and looks where it was to look');

    const aside = await onScreen(page, { x: 3, y: -2 });
    await page.mouse.click(aside.x, aside.y, { button: 'right' }); // without a drag
    await page.getByRole('menuitem', { name: 'Add a box here' }).waitFor();
    await page.keyboard.press('Escape');
    expect(sent).toHaveLength(1);
  });

  longTest('says why the right button cannot send a robot', async () => {
    await page.locator('tr[data-robot="blind"]').click();
    await drag(page, { x: 3, y: -2 }, { x: 3, y: 0 }, 'right');
    await page.getByRole('alert').getByText(/./).first().waitFor();
    expect(await page.getByRole('menu').count()).toBe(0);
  });

  it('is looked at from an angle: heights are seen, and what is behind them shines through', async () => {
    for (const layer of ['Grid', 'Scans', 'Names', 'Trails']) {
      await page.getByRole('button', { name: layer }).click();
    }
    await rsal.post('pause');
    const button = page.getByRole('button', { name: 'Oblique view' });
    const behind = { x: 0, y: 1 }; // the pillar, 1 m each way, hides it: its top is seen there
    expect(await colorAt(page, behind)).toEqual(WHITE);
    await page.keyboard.press('v');
    expect(await button.getAttribute('aria-pressed')).toBe('true');
    expect(await numberOf('squeeze')).toBeLessThan(0.9);
    const top = await colorAt(page, { x: 0, y: 0.3 }, 1);
    const side = await colorAt(page, { x: 0, y: -0.5 }, 0.5);
    expect(top).not.toEqual(WHITE);
    expect(await colorAt(page, behind)).toEqual(top);
    expect(side[0]!).toBeLessThan(top[0]! - 10); // in less light
    expect(await colorAt(page, { x: 0, y: 1.6 })).toEqual(WHITE);
    expect(await colorAt(page, { x: 0, y: -0.7 })).toEqual(WHITE); // nothing stands before it
    await picture(page, 'oblique');

    const before = { x: -0.7, y: 1.2 };
    await drag(page, await pose('blind'), before); // from its foot to a foot
    await eventually(() => isAt('blind', before), 'it is where it was dragged');
    await rsal.post('place', { robot: 'blind', x: 0, y: 0.85, heading: 0 });
    await eventually(() => isAt('blind', { x: 0, y: 0.85 }), 'it is behind the pillar');
    await eventually(async () => {
      const [red, green, blue] = await colorAt(page, { x: 0.2, y: 0.7 }, 0.1);
      return red! > green! + 15 && red! > blue! + 15 && red! < 230;
    }, 'it is red behind gray');
    const hidden = await onScreen(page, { x: 0, y: 0.85 }, 0.15);
    await page.mouse.click(hidden.x, hidden.y);
    await page.locator('tr.card', { hasText: 'Drive by keys' }).waitFor();
    await picture(page, 'hidden');
    await page.keyboard.press('Escape');

    await page.keyboard.press('Shift+ArrowLeft');
    await page.keyboard.press('Shift+ArrowLeft');
    await page.keyboard.press('0');
    await picture(page, 'oblique-turned');
    await page.keyboard.press('n');
    await expectAccessible(page);
    await button.click();
    expect(await numberOf('rise')).toBe(0);
    await eventually(
      async () => (await colorAt(page, { x: 0, y: 1.6 })).join() === WHITE.join(),
      'it is flat',
    );
  });

  longTest('shows the frames of the selected robot, in any view', async () => {
    await rsal.post('pause');
    await page.locator('tr[data-robot="idle"]').click();
    const { x, y } = await pose('idle'); // it looks along the x axis of the map
    const axes = page.getByRole('button', { name: 'Frames' });
    expect(await axes.getAttribute('aria-pressed')).toBe('false');
    await axes.click();
    for (const key of ['Shift+ArrowLeft', 'v']) {
      await page.keyboard.press(key);
      for (const origin of [
        { x, y },
        { x: 0, y: 0 },
      ]) {
        await eventually(async () => {
          const along = await colorAt(page, { x: origin.x + 0.15, y: origin.y });
          const left = await colorAt(page, { x: origin.x, y: origin.y + 0.15 });
          return along[0]! > 1.2 * along[1]! && left[1]! > 1.2 * left[0]!;
        }, 'x is red, and y green');
      }
    }
    await picture(page, 'frames');
  });

  longTest('fits a narrow screen, at an angle and in the dark', async () => {
    await close();
    page = await opened(480, 900, 'dark');
    await page.keyboard.press('v');
    await picture(page, 'narrow');
    for (const name of ['Oblique view', 'Reset the rotation', 'Show all']) {
      const box = (await page.getByRole('button', { name }).boundingBox())!;
      expect(box.x >= 0 && box.x + box.width <= 480, name).toBe(true);
    }
    expect((await map().boundingBox())!.height).toBeGreaterThan(120);
    await expectAccessible(page);
  });
});
