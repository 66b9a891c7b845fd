import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect } from 'vitest';
import { chromium } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';
import { longTest, expectAccessible, picture, visits } from './visits';

const WANDER = fileURLToPath(new URL('wander.yaml', import.meta.url));

/** Beside a map that is about as high as it is wide. */
describe.skipIf(!chromium)('panels that lie one above the other', () => {
  const { openRun } = visits();
  let page: Page;

  beforeAll(async () => {
    const rsal = await Rsal.run(`${WANDER}:lasting`, '--set', 'floor=four-rooms', '--port', '0');
    page = await openRun(rsal.url, { viewport: { width: 1400, height: 1000 } });
  });

  const heights = () =>
    page
      .locator('.panels > .place')
      .evaluateAll((all) => all.map((one) => one.getBoundingClientRect().height));

  const become = (wanted: readonly number[], what: string) =>
    eventually(
      async () => (await heights()).every((height, i) => Math.abs(height - wanted[i]!) < 3),
      `${what}: ${wanted.join(', ')}`,
    );

  /** What they are when one gives another so much. */
  function given(from: readonly number[], at: number, pixels: number): number[] {
    return from.map((height, i) => (i === at ? height + pixels : i === at + 1 ? height - pixels : height));
  }

  async function dragged(border: { x: number; y: number; width: number; height: number }, pixels: number) {
    const [x, y] = [border.x + border.width / 2, border.y + border.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x, y + pixels, { steps: 3 });
    await page.mouse.up();
  }

  longTest.each([
    ['Border between robots and agents', 0],
    ['Border between agents and events', 1],
  ] as const)('share their height by the %s', async (name, at) => {
    const border = page.getByRole('separator', { name, exact: true });
    const before = await heights();
    const value = async () => Number(await border.getAttribute('aria-valuenow'));
    expect(await border.getAttribute('aria-orientation')).toBe('horizontal');
    await eventually(async () => (await value()) === Math.round(before[at]!), 'it tells where it is');

    const origin = await page.locator('#map').getAttribute('data-origin-x');
    await dragged((await border.boundingBox())!, -40);
    await become(given(before, at, -40), 'dragged up');
    await border.press('ArrowDown');
    await become(given(before, at, -16), 'a step down');
    await border.press('ArrowRight');
    await become(given(before, at, -16), 'no step aside');
    expect(await page.locator('#map').getAttribute('data-origin-x'), 'the map stays').toBe(origin);
    await border.press('ArrowUp');
    await become(given(before, at, -40), 'a step up');
    await picture(page, `borders-${String(at)}`);
    await expectAccessible(page);

    await page.reload();
    await page.locator('tr[data-robot][data-x]').first().waitFor();
    await become(given(before, at, -40), 'as it was left');

    await dragged((await border.boundingBox())!, -900);
    const least = Number(await border.getAttribute('aria-valuemin'));
    await become(given(before, at, least - before[at]!), 'no panel vanishes');
    await border.press('Home');
    await become(before, 'as it was at first');

    await dragged((await border.boundingBox())!, 30);
    await become(given(before, at, 30), 'dragged down');
    await border.dblclick();
    await become(before, 'as it was at first');
  });
});
