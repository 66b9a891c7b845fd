import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { Locator, Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { chromium } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';
import { expectAccessible, longTest, picture, visits } from './visits';

const TEAM = fileURLToPath(new URL('talk.yaml', import.meta.url));
const SPEED = 'courier-1: base velocity.vx';
const DISTANCE = 'courier-1: laser ranges.least';

describe.skipIf(!chromium)('plots', () => {
  const { openRun } = visits();
  let page: Page;
  let rsal: Rsal;

  beforeAll(async () => {
    rsal = await Rsal.run(TEAM, '--port', '0');
    page = await openRun(rsal.url);
    await page.locator('tr[data-robot="courier-1"]').click();
    await page.getByText('Plots', { exact: true }).click();
    const numbers = page.getByLabel('Plot a number…');
    await numbers.locator(`option[value="${DISTANCE}"]`).waitFor({ state: 'attached' });
    await numbers.selectOption(SPEED);
    await numbers.selectOption(DISTANCE);
    await rsal.post('speed', { factor: '40' }); // until there is something to look at
    await ticks('−60 s'); // no more, though more will be known
    await eventually(
      async () => (await page.getByTestId('time').innerText()) > '1:02',
      'it has gone on for more than a minute',
    );
    await rsal.post('speed', { factor: '2' });
  });

  const plotOf = (key: string) => page.locator(`[data-plot="${key}"]`);
  const box = (key = SPEED) => plotOf(key).locator('.box svg');
  const ticks = (text: string | RegExp, key = SPEED) =>
    plotOf(key).locator('.ticks').getByText(text).first().waitFor();
  const span = () => page.getByLabel('Longest time that plots show');
  const pointAway = () => page.mouse.move(400, 300);

  async function wheel(plot: Locator, x: number, amount: number) {
    await plot.scrollIntoViewIfNeeded();
    await plot.hover({ position: { x: x - 3, y: 40 } });
    await plot.hover({ position: { x, y: 40 } });
    await page.mouse.wheel(0, amount);
  }

  it('show as much of the past as somebody wants', async () => {
    expect(await plotOf(SPEED).getByText('−2 min').count()).toBe(0);
    await span().selectOption('5 min');
    await ticks('−2 min');
    await ticks('−1 min', DISTANCE);
    await picture(page, 'plots-5-minutes');
    await expectAccessible(page);
    await span().selectOption('10 s');
    await ticks('−5 s');
    expect(await plotOf(SPEED).getByText('−10 s').count()).toBe(1);
    await span().selectOption('all');
    await ticks('−1 min');
    await span().selectOption('60 s');
    await ticks('−20 s');
  });

  longTest(
    'are looked at more closely by the wheel, all at the same time, and stand still then',
    async () => {
      await wheel(box(), 100, -500);
      await pointAway();
      await ticks(/^\d:\d\d\.\d$/, DISTANCE);
      expect(await plotOf(SPEED).getByText('now').count()).toBe(0);
      expect(await span().locator('option:checked').innerText()).toMatch(/^[\d.]+ s of it$/);
      const path = () => box().locator('path').getAttribute('d');
      const before = await path();
      await picture(page, 'plots-zoomed');
      await expectAccessible(page);
      const time = await page.getByTestId('time').innerText();
      await eventually(async () => (await page.getByTestId('time').innerText()) > time, 'the run goes on');
      expect(await path()).toBe(before);
      await box().dblclick();
      await pointAway();
      await plotOf(DISTANCE).getByText('now').waitFor();
      expect(await span().locator('option:checked').innerText()).toBe('60 s');
    },
  );

  longTest('leave the wheel to the panel that is scrolled by it', async () => {
    const scroller = page.locator('.panel', { hasText: 'Robots' }).locator('.body').first();
    await scroller.evaluate((node) => node.scrollTo({ top: 0 }));
    const at = (await scroller.boundingBox())!;
    await page.mouse.move(at.x + 60, at.y + at.height / 2);
    for (let i = 0; i < 12; i++) {
      await page.mouse.wheel(0, 120);
      await page.waitForTimeout(80); // as a hand turns it
    }
    await eventually(
      async () =>
        (await scroller.evaluate((node) => node.scrollHeight - node.scrollTop - node.clientHeight)) < 2,
      'it is scrolled to its end, over the plots',
    );
    expect(await page.evaluate(() => window.scrollY), 'the page ends where it is seen to').toBe(0);
    expect(await span().locator('option:checked').innerText()).toBe('60 s');
  });

  longTest('show what was dragged over, and where the pointer is in it', async () => {
    await box().scrollIntoViewIfNeeded();
    const at = (await box().boundingBox())!;
    await page.mouse.move(at.x + 0.25 * at.width, at.y + 30);
    await page.mouse.down();
    await page.mouse.move(at.x + 0.5 * at.width, at.y + 40, { steps: 4 });
    await picture(page, 'plots-dragged');
    await page.mouse.up();
    await ticks(/^\d:\d\d\.\d$/); // where the pointer is
    await eventually(async () => {
      const words = await span().locator('option:checked').innerText();
      return /^1[45](\.\d)? s of it$/.test(words);
    }, 'a quarter of a minute is shown');
    await pointAway();
    const end = () => plotOf(SPEED).locator('.now').innerText();
    const before = await end();
    await page.getByRole('button', { name: /^Show what was before/ }).click();
    await eventually(async () => (await end()) < before, 'it ends earlier');
    await page.getByRole('button', { name: /^Show what was after/ }).click();
    await eventually(async () => (await end()) === before, 'and as before');
    await page.getByRole('button', { name: /^Show the newest again/ }).click();
    await eventually(async () => (await end()) === 'now', 'it goes on');
  });

  it('do all of it by keys', async () => {
    const zoomIn = page.getByRole('button', { name: /^Show less of the time/ });
    await zoomIn.press('Enter');
    await zoomIn.press('Enter');
    await ticks('−5 s'); // of 15 s
    await page.getByRole('button', { name: /^Show what was before/ }).press('Enter');
    await ticks(/^\d:\d\d\.\d$/);
    const slider = plotOf(SPEED).getByRole('slider');
    await slider.press('ArrowLeft');
    expect(await slider.getAttribute('aria-valuetext')).toMatch(/^\d:\d\d\.\d: courier-1: base speed ahead /);
    await page.getByRole('button', { name: /^Show more of the time/ }).press('Enter');
    await page.getByRole('button', { name: /^Show the newest again/ }).press('Enter');
    await plotOf(SPEED).getByText('now').waitFor();
  });

  it('are saved as CSV', async () => {
    await page
      .getByLabel('Plot another number beside courier-1: base speed ahead')
      .selectOption(DISTANCE.replace('ranges.least', 'ranges.mean'));
    const saved = page.waitForEvent('download');
    await plotOf(SPEED)
      .getByRole('button', { name: /^Save all that is kept of courier-1: base speed/ })
      .click();
    const download = await saved;
    expect(download.suggestedFilename()).toBe('plot.csv');
    const rows = readFileSync(await download.path(), 'utf8')
      .trim()
      .split('\r\n');
    expect(rows[0]).toBe('time [s],courier-1: base speed ahead [m/s],"courier-1: laser distance, mean [m]"');
    const numbers = rows.slice(1).map((row) => row.split(',').map(Number));
    const seconds = numbers.at(-1)![0]! - numbers[0]![0]!;
    expect(seconds).toBeGreaterThan(30);
    // Ten times a second, or less often on a machine that is too busy to show each message.
    expect(numbers.length).toBeGreaterThan(seconds / 5);
    numbers.forEach((row, i) => {
      expect(row).toHaveLength(3);
      expect(row[0]).toBeGreaterThan(i === 0 ? -1 : numbers[i - 1]![0]!);
    });
    expect(Math.max(...numbers.map((row) => row[1]!))).toBeGreaterThan(0.1);
  });
});
