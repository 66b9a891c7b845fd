import { fileURLToPath } from 'node:url';
import { AxeBuilder } from '@axe-core/playwright';
import { chromium as driver, type Browser, type Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { chromium, flags } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';

const WORLD = fileURLToPath(new URL('onboard.world', import.meta.url));
const PICTURES = process.env.PICTURES;

describe.skipIf(!chromium)('the view from a robot', () => {
  let browser: Browser | undefined;
  let page: Page;

  beforeAll(async () => {
    const [rsal, started] = await Promise.all([
      Rsal.run(WORLD, '--port', '0'),
      driver.launch({ executablePath: chromium!, args: flags }),
    ]);
    browser = started;
    const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
    page = await context.newPage();
    await page.goto(rsal.url);
    await page.locator('tr[data-robot][data-x]').first().waitFor();
  });

  afterAll(async () => {
    await browser?.close();
    await Rsal.endAll();
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

  const picture = async (name: string) => {
    if (PICTURES) {
      await page.screenshot({ path: `${PICTURES}/${name}.png` });
    }
  };

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
    await picture('onboard');
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
    await picture('onboard-large');
    const found = await new AxeBuilder({ page }).analyze();
    expect(found.violations.map(({ id, nodes }) => `${id}: ${nodes[0]?.html ?? ''}`)).toEqual([]);
    await page.keyboard.press('e');
    await view().waitFor({ state: 'detached' });
  });
});
