import { fileURLToPath } from 'node:url';
import { AxeBuilder } from '@axe-core/playwright';
import { chromium as driver, type Browser, type Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { chromium, flags } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';

const CROWD = fileURLToPath(new URL('crowd.yaml', import.meta.url));
const ROBOTS = 120;
const PICTURES = process.env.PICTURES;

describe.skipIf(!chromium)('a crowd of robots', () => {
  let browser: Browser | undefined;
  let page: Page;

  beforeAll(async () => {
    const [rsal, started] = await Promise.all([
      Rsal.run(CROWD, '--port', '0'),
      driver.launch({ executablePath: chromium!, args: flags }),
    ]);
    browser = started;
    const context = await browser.newContext({ viewport: { width: 1400, height: 900 } });
    page = await context.newPage();
    await page.goto(rsal.url);
    await page.locator('tr[data-robot][data-x]').first().waitFor();
    await eventually(async () => (await drawn('lying')) > 0, 'scans are drawn');
    await rsal.post('pause');
    await page.getByRole('button', { name: 'Resume' }).waitFor();
  });

  afterAll(async () => {
    await browser?.close();
    await Rsal.endAll();
  });

  const row = (i: number) => page.locator(`tr[data-robot="robot-${i}"]`);
  const list = (name: string) => page.getByRole('region', { name });
  const scroll = (name: string, share: number) =>
    list(name).evaluate((node, to) => (node.scrollTop = to * node.scrollHeight), share);

  /** How many pixels of a canvas of the map have something on them. */
  const drawn = (canvas: 'lying' | 'standing') =>
    page
      .locator('#map canvas')
      .nth(canvas === 'lying' ? 1 : 2)
      .evaluate((node) => {
        const { width, height } = node as HTMLCanvasElement;
        const { data } = (node as HTMLCanvasElement).getContext('2d')!.getImageData(0, 0, width, height);
        return data.filter((value, at) => at % 4 === 3 && value > 0).length;
      });

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

  it('shows who is chosen on the map in the list, wherever that is', async () => {
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
    if (PICTURES) {
      await page.screenshot({ path: `${PICTURES}/crowd.png` });
    }
  });

  it('has links of the one that is selected, as all would be too many', async () => {
    const hint = page.getByText('So many robots');
    await page.getByRole('button', { name: 'Links', exact: true }).click();
    await hint.waitFor();
    await page.keyboard.press('1');
    await hint.waitFor({ state: 'detached' });
    await page.keyboard.press('Escape');
    await hint.waitFor();
    await page.getByRole('button', { name: 'Links', exact: true }).click();
    await hint.waitFor({ state: 'detached' });
  });

  it('leaves the page accessible', async () => {
    const { violations } = await new AxeBuilder({ page }).analyze();
    expect(violations.map(({ id, nodes }) => `${id}: ${nodes[0]?.html ?? ''}`)).toEqual([]);
  });
});
