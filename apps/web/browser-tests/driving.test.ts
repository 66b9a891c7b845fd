import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { beforeAll, beforeEach, describe, expect, it } from 'vitest';
import { chromium } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';
import { expectAccessible, longTest, looks, trials, visits } from './visits';
import { poseOf } from './world';

const WORLD = fileURLToPath(new URL('driving.world', import.meta.url));

describe.skipIf(!chromium)('robots of a world', () => {
  const { openRun } = visits();
  let rsal: Rsal;
  let page: Page;

  beforeAll(async () => {
    rsal = await Rsal.run(WORLD, '--port', '0');
  });

  beforeEach(async () => {
    await rsal.post('restart');
    page = await openRun(rsal.url);
  });

  const row = (robot: string, of = page) => of.locator(`tr[data-robot="${robot}"]`);

  async function select(robot: string, of = page) {
    const button = row(robot, of).getByRole('button');
    if ((await button.getAttribute('aria-expanded')) !== 'true') {
      await button.click();
    }
    await of.getByLabel('Behavior').waitFor();
    await eventually(() => of.getByLabel('Behavior').isEnabled(), 'what it can do is known');
  }

  const pose = (robot: string) => poseOf(page, robot);

  async function moved(robot: string, by = 0.2) {
    const before = await pose(robot);
    await eventually(async () => {
      const now = await pose(robot);
      return Math.hypot(now.x - before.x, now.y - before.y) > by;
    }, `${robot} moves`);
  }

  async function stands(robot: string) {
    let before = await pose(robot);
    await eventually(async () => {
      await page.waitForTimeout(400);
      const now = await pose(robot);
      const same = now.x === before.x && now.y === before.y && now.heading === before.heading;
      before = now;
      return same;
    }, `${robot} stands`);
  }

  async function take(robot: string) {
    await select(robot);
    await page.keyboard.press('k');
    await page.getByText(`You drive ${robot}`).waitFor();
  }

  async function happened(text: string | RegExp, of = page) {
    await of.locator('li', { hasText: text }).first().waitFor();
  }

  it('are driven by keys, for as long as these are pressed', async () => {
    await take('idle');
    const start = await pose('idle');
    await page.keyboard.down('w');
    await moved('idle');
    await page.keyboard.up('w');
    await stands('idle');
    expect((await pose('idle')).x).toBeGreaterThan(start.x);
    await row('idle').getByText('you, by keys').waitFor();
    const { heading } = await pose('idle');
    await page.keyboard.down('ArrowLeft');
    await eventually(async () => (await pose('idle')).heading > heading + 0.3, 'it turns left');
    await page.keyboard.up('ArrowLeft');
    await happened('driven by keys');
    await happened('(0.30, 0.00) m/s');
    await page.keyboard.press('Escape');
    await page.getByText('You drive idle').waitFor({ state: 'hidden' });
    await happened('no longer driven by keys');
    const map = page.locator('#map');
    const before = Number(await map.getAttribute('data-origin-x'));
    await page.keyboard.press('ArrowLeft'); // moves the map again
    expect(Number(await map.getAttribute('data-origin-x'))).toBeCloseTo(before + 60);
  });

  it('that have agents are taken over and given back', async () => {
    await take('roamer');
    await stands('roamer');
    await page.keyboard.press('k');
    await moved('roamer');
  });

  longTest('go sideways when they can', async () => {
    await take('glider');
    const start = await pose('glider');
    await page.keyboard.down('q');
    await eventually(async () => (await pose('glider')).x < start.x - 0.3, 'it has gone to its left');
    await page.keyboard.up('q');
    await stands('glider');
    expect((await pose('glider')).y).toBeCloseTo(start.y, 1);
  });

  it.each([
    ['Cmd goes down, which keeps keyups from us', async () => page.keyboard.down('Meta')],
    ['the page loses the focus', async () => page.evaluate(() => window.dispatchEvent(new Event('blur')))],
    [
      'the tab is hidden',
      async () =>
        page.evaluate(() => {
          Object.defineProperty(document, 'hidden', { get: () => true });
          document.dispatchEvent(new Event('visibilitychange'));
        }),
    ],
    ['nothing gets through any more', async () => page.route('**/api/run/drive', () => {})],
    ['the page is closed', async () => page.close()],
  ])('stop when %s', async (_, happens) => {
    const other = await openRun(rsal.url);
    await take('idle');
    await page.keyboard.down('w');
    await moved('idle');
    const there = await pose('idle');
    await happens();
    page = other;
    await stands('idle');
    expect((await pose('idle')).x).toBeLessThan(there.x + 3); // long before the wall
  });

  longTest('stand when they are taken again after a refusal, though a key was down then', async () => {
    await take('idle');
    await page.keyboard.down('w');
    await moved('idle');
    await page.route('**/api/run/drive', (route) =>
      route.fulfill({ status: 409, json: { message: 'Not now.', problems: [] } }),
    );
    await page.getByText('Not now.').waitFor();
    await page.getByText('You drive idle').waitFor({ state: 'hidden' });
    await page.keyboard.up('w');
    await page.unroute('**/api/run/drive');
    await stands('idle');
    const [told] = await Promise.all([page.waitForRequest('**/api/run/drive'), take('idle')]);
    expect(told.postDataJSON()).toMatchObject({ vx: 0, vy: 0, omega: 0 });
    await page.keyboard.down('w');
    await moved('idle');
    await page.keyboard.up('w');
  });

  it('stop in an emergency, and wait until all keys were released', async () => {
    await take('idle');
    await page.keyboard.down('w');
    await moved('idle');
    await page.keyboard.press('F8');
    await page.getByText('Press Arm to switch them on').waitFor();
    await stands('idle');
    await page.getByRole('button', { name: 'Arm', exact: true }).click();
    await page.getByText('Press Arm to switch them on').waitFor({ state: 'hidden' });
    await stands('idle');
    await page.keyboard.up('w');
    await page.keyboard.down('w');
    await moved('idle');
    await page.keyboard.up('w');
  });

  it('are driven by one page at a time, and all see it', async () => {
    const other = await openRun(rsal.url);
    await select('idle', other);
    await take('idle');
    await row('idle', other).getByText('keys', { exact: true }).waitFor();
    await other.getByText('Another person drives this robot.').waitFor();
    expect(await other.getByRole('button', { name: 'Drive by keys' }).isDisabled()).toBe(true);
    await page.getByRole('button', { name: 'Release' }).click();
    await other.getByText('Another person drives this robot.').waitFor({ state: 'hidden' });
  });

  longTest('are driven by a finger on the pad, as fast as the slider says', async () => {
    await take('idle');
    await page.getByLabel('Share of its full speed').fill('100');
    await page.waitForTimeout(300); // the map's bar may still wrap
    const pad = (await page.getByTestId('pad').boundingBox())!;
    const middle = { x: pad.x + pad.width / 2, y: pad.y + pad.height / 2 };
    await page.mouse.move(middle.x, middle.y);
    await page.mouse.down();
    await page.mouse.move(middle.x, pad.y + 2);
    await moved('idle');
    await happened('(0.60, 0.00) m/s');
    await page.mouse.up();
    await stands('idle');
  });

  longTest('are given behaviors', async () => {
    await select('idle');
    await page.getByLabel('Behavior').selectOption('wander');
    await moved('idle', 0.5);
    await happened('told to wander');
    expect(await page.getByLabel('Behavior').inputValue()).toBe('wander');
    await page.getByLabel('Behavior').selectOption('follow the wall');
    await happened('told to wall-follow');
    await page.getByLabel('Behavior').selectOption('none');
    await stands('idle');
    await select('roamer');
    await page.getByLabel('Behavior').selectOption('stand still');
    await stands('roamer');
    await page.getByLabel('Behavior').selectOption('controlled by its agent');
    await moved('roamer');
  });

  it.each(trials(['idle', 'roamer', 'glider']))('are sent somewhere: %s', async (robot) => {
    await select(robot);
    const map = page.locator('#map');
    const box = (await map.boundingBox())!;
    const [scale, originX, originY] = await Promise.all(
      ['data-scale', 'data-origin-x', 'data-origin-y'].map(async (name) =>
        Number(await map.getAttribute(name)),
      ),
    );
    await page.getByRole('button', { name: 'Send…' }).click();
    await page.mouse.click(box.x + originX!, box.y + originY! - 2 * scale!); // (0, 2)
    await happened('sent to (');
    await row(robot).getByText('navigator').waitFor();
    await rsal.post('speed', { factor: '8' });
    await happened(/is at \((-0|0)\.\d\d, [12]\.\d\d/);
    await rsal.post('speed', { factor: '1' });
  });

  longTest('say what they cannot do', async () => {
    await select('blind');
    await page.getByText('It cannot drive to goals. It has no sensor that measures ranges').waitFor();
    await page.getByText('It cannot run a behavior that moves it.').waitFor();
    expect(await page.getByRole('button', { name: 'Send…' }).isDisabled()).toBe(true);
    expect(await page.getByLabel('Behavior').locator('option').allInnerTexts()).toEqual([
      'none',
      'stand still',
    ]);
    await take('blind');
    await page.keyboard.down('w');
    await moved('blind');
    await page.keyboard.up('w');
  });

  longTest('cannot be driven by those who may only watch', async () => {
    const watching = await openRun(rsal.origin);
    await row('idle', watching).getByRole('button').click();
    expect(await watching.getByRole('button', { name: 'Drive by keys' }).isDisabled()).toBe(true);
    expect(await watching.getByLabel('Behavior').isDisabled()).toBe(true);
    await watching.keyboard.press('k');
    await watching.waitForTimeout(300);
    expect(await watching.getByText('You drive').count()).toBe(0);
  });

  longTest('drive in a hunt, too', async () => {
    const hunt = await Rsal.run('hunt-and-prey', '--port', '0', '--seed', '42');
    page = await openRun(hunt.url);
    await moved('hunter-1');
    await take('hunter-1');
    await stands('hunter-1');
    await page.keyboard.down('s');
    await moved('hunter-1');
    await page.keyboard.up('s');
    await page.keyboard.press('Escape');
    await moved('hunter-1', 0.5);
    await page.close();
    await hunt.end();
  });

  longTest.each(looks)(
    'break no rule of accessibility while they are driven, %s at %i × %i',
    async (colorScheme, width, height) => {
      page = await openRun(rsal.url, { colorScheme, viewport: { width, height } });
      for (const robot of ['glider', 'blind']) {
        await take(robot);
        await expectAccessible(page);
      }
    },
  );
});
