import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { chromium } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';
import { visits } from './visits';
import { texts } from '../src/texts';

const SCENARIO = fileURLToPath(new URL('camera.yaml', import.meta.url));

describe.skipIf(!chromium)('a robot with a camera', () => {
  const { openRun } = visits();
  let page: Page;

  beforeAll(async () => {
    const rsal = await Rsal.run(SCENARIO, '--port', '0');
    page = await openRun(rsal.url, { viewport: { width: 1400, height: 900 } });
    await page.locator('tr[data-robot="rover"]').click();
  });

  /** How many pixels have a color, of those of the image. */
  const count = (red: number, green: number, blue: number) =>
    page
      .getByRole('img', { name: texts.readings.image('camera') })
      .locator('canvas')
      .evaluate(
        (canvas, color) => {
          const { width, height } = canvas as HTMLCanvasElement;
          const { data } = (canvas as HTMLCanvasElement).getContext('2d')!.getImageData(0, 0, width, height);
          let found = 0;
          for (let i = 0; i < data.length; i += 4) {
            found += color.every((channel, j) => data[i + j] === channel) ? 1 : 0;
          }
          return found;
        },
        [red, green, blue],
      );

  it('shows what the camera sees', async () => {
    await eventually(async () => (await count(255, 0, 0)) > 20, 'the red can is there');
    expect(await count(0, 0xaa, 0), 'the green can').toBeGreaterThan(20);
    expect(await count(255, 0xcc, 0), 'the yellow box').toBeGreaterThan(20);
    expect(await count(0, 0x72, 0xb2), 'the other robot').toBeGreaterThan(20);
    expect(await count(0xb8, 0xb4, 0xaa), 'the floor').toBeGreaterThan(1000);
  });

  it('shows the numbers of devices that the page does not know', async () => {
    const imu = page.locator('dd[data-reading="imu"]');
    await imu.getByText('angular velocity').waitFor();
    await imu.getByText('m/s²').first().waitFor();
    await page.locator('dd[data-reading="gnss"]').getByText('latitude').waitFor();
  });
});
