import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { chromium } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';
import { expectAccessible, longTest, picture, visits } from './visits';
import { drawnOn } from './world';

const CROWD = fileURLToPath(new URL('crowd.yaml', import.meta.url));
const ROBOTS = 120;

describe.skipIf(!chromium)('a crowd of robots', () => {
  const { openRun } = visits();
  let page: Page;

  beforeAll(async () => {
    const rsal = await Rsal.run(CROWD, '--port', '0');
    page = await openRun(rsal.url, { viewport: { width: 1400, height: 900 } });
    await eventually(async () => (await drawn('lying')) > 0, 'scans are drawn');
    await rsal.post('pause');
    await page.getByRole('button', { name: 'Resume' }).waitFor();
  });

  const row = (i: number) => page.locator(`tr[data-robot="robot-${i}"]`);
  const list = (name: string) => page.getByRole('region', { name });
  const scroll = (name: string, share: number) =>
    list(name).evaluate((node, to) => (node.scrollTop = to * node.scrollHeight), share);

  const drawn = (canvas: 'lying' | 'standing') => drawnOn(page, canvas);

  it('is listed as far as one looks, and further where one scrolls', async () => {
    expect(await page.locator('tr[data-robot]').count()).toBeLessThan(ROBOTS);
    expect(await row(ROBOTS).count()).toBe(0);
    await scroll('Robots', 1);
    await row(ROBOTS).waitFor();
    expect(await row(1).count()).toBe(0);

    expect(await page.locator('[data-agent]').count()).toBeLessThan(ROBOTS);
    await scroll('Agents', 1);
    await page.locator(`[data-agent="rover-${ROBOTS}"]`).waitFor();
    await scroll('Agents', 0);
    await page.locator('[data-agent="rover-1"]').waitFor();
  });

  longTest('shows who is chosen on the map in the list, wherever that is', async () => {
    await scroll('Robots', 1);
    await row(ROBOTS).waitFor();
    const [x, y] = await Promise.all(['data-x', 'data-y'].map((name) => row(ROBOTS).getAttribute(name)));
    await scroll('Robots', 0);
    await eventually(async () => (await row(ROBOTS).count()) === 0, 'the end of the list is gone');
    const map = page.locator('#map');
    const [scale, left, top] = await Promise.all(
      ['data-scale', 'data-origin-x', 'data-origin-y'].map(async (name) =>
        Number(await map.getAttribute(name)),
      ),
    );
    await map.click({ position: { x: left! + Number(x) * scale!, y: top! - Number(y) * scale! } });
    await page.locator('tr.selected').waitFor();
    expect(await page.locator('tr.selected').getAttribute('data-robot')).toBe(`robot-${ROBOTS}`);
    await eventually(
      async () =>
        row(ROBOTS).evaluate((node) => {
          const { top, bottom } = node.getBoundingClientRect();
          const seen = node.closest('[role=region]')!.getBoundingClientRect();
          return top >= seen.top && bottom <= seen.bottom;
        }),
      'its row is in sight',
    );
    await page.keyboard.press('Escape');
  });

  it('is drawn with what its lasers hit, and where it was', async () => {
    const layer = (name: string) => page.getByRole('button', { name, exact: true });
    expect(await drawn('standing')).toBeGreaterThan(ROBOTS * 100);
    const all = await drawn('lying');
    await layer('Scans').click();
    await eventually(async () => (await drawn('lying')) < all, 'scans are gone');
    const trails = await drawn('lying');
    expect(all - trails).toBeGreaterThan(2000);
    await layer('Trails').click();
    await eventually(async () => (await drawn('lying')) < Math.max(1, trails), 'trails are gone');
    expect(await drawn('lying')).toBe(0);
    await layer('Scans').click();
    await layer('Trails').click();
    await eventually(async () => (await drawn('lying')) === all, 'all is back');
    await picture(page, 'crowd');
  });

  longTest('has links of the one that is selected, as all would be too many', async () => {
    const hint = page.getByText('Too many robots');
    await page.getByRole('button', { name: 'Links', exact: true }).click();
    await hint.waitFor();
    await page.keyboard.press('1');
    await hint.waitFor({ state: 'detached' });
    await page.keyboard.press('Escape');
    await hint.waitFor();
    await page.getByRole('button', { name: 'Links', exact: true }).click();
    await hint.waitFor({ state: 'detached' });
  });

  longTest('leaves the page accessible', async () => {
    await expectAccessible(page);
  });
});
