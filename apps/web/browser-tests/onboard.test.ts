import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { chromium } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';
import { expectAccessible, picture, visits } from './visits';

const WORLD = fileURLToPath(new URL('onboard.world', import.meta.url));

describe.skipIf(!chromium)('the view from a robot', () => {
  const { openRun } = visits();
  let page: Page;

  beforeAll(async () => {
    const rsal = await Rsal.run(WORLD, '--port', '0');
    page = await openRun(rsal.url);
  });

  const view = () => page.getByRole('region', { name: /^View from/ });

  /** How many pixels are mostly of a color. */
  const counts = () =>
    view()
      .locator('canvas')
      .evaluate((node) => {
        const { width, height } = node as HTMLCanvasElement;
        const { data } = (node as HTMLCanvasElement).getContext('2d')!.getImageData(0, 0, width, height);
        const seen = { red: 0, green: 0, blue: 0, orange: 0 };
        for (let at = 0; at < data.length; at += 4) {
          const [red, green, blue] = [data[at]!, data[at + 1]!, data[at + 2]!];
          seen.red += red > 120 && green < 60 && blue < 60 ? 1 : 0;
          seen.green += green > 70 && red < 40 && blue < 40 ? 1 : 0;
          seen.blue += blue > 120 && red < 60 && green < 60 ? 1 : 0;
          seen.orange += red > 150 && green > 80 && blue < 60 ? 1 : 0;
        }
        return seen;
      });

  it('begins with a sentence, until a robot is selected', async () => {
    await page.keyboard.press('e');
    await view().getByText('Select a robot').waitFor();
  });

  it('shows what is ahead, not what a wall hides, nor itself', async () => {
    await page.locator('tr[data-robot="watcher"]').first().click();
    await eventually(async () => (await counts()).red > 200, 'the red box is seen');
    const seen = await counts();
    expect(seen.blue).toBeGreaterThan(200);
    expect(seen.green).toBe(0);
    expect(seen.orange).toBe(0);
    await picture(page, 'onboard');
  });

  it('looks from whoever is selected', async () => {
    await page.locator('tr[data-robot="other"]').first().click();
    await eventually(async () => (await counts()).blue === 0, 'it does not see itself');
    expect((await counts()).red).toBeGreaterThan(200); // it looks left, past the box
    await page.locator('tr[data-robot="watcher"]').first().click();
    await eventually(async () => (await counts()).blue > 200, 'back again');
  });

  it('is enlarged, is accessible, and closes', async () => {
    const small = (await view().boundingBox())!;
    await view().getByRole('button', { name: 'Enlarge' }).click();
    await eventually(async () => (await view().boundingBox())!.width > 2 * small.width, 'it is large');
    await eventually(async () => (await counts()).red > 800, 'the picture, too');
    await picture(page, 'onboard-large');
    await expectAccessible(page);
    await page.keyboard.press('e');
    await view().waitFor({ state: 'detached' });
  });
});
