import { describe, expect } from 'vitest';
import { chromium } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';
import { longTest, visits } from './visits';

describe.skipIf(!chromium)('a run that is replaced', () => {
  const { openRun } = visits({ refusals: false });

  longTest('is asked no more about the robot that was selected in it, its agent and its plots', async () => {
    const rsal = await Rsal.run('find-and-collect', '--port', '0');
    const page = await openRun(rsal.url);
    const restart = (collectors: string) => rsal.post('restart', { arguments: { collectors } });
    const robots = page.locator('tr[data-robot]');
    const asked: string[] = [];
    page.on('request', (request) => asked.push(request.url()));
    for (let i = 0; i < 4; i++) {
      await page.locator('tr[data-robot="collector-2"]').click();
      if (i === 0) {
        // they stay unfolded from then on
        await page.getByText('Plots', { exact: true }).click();
      }
      const numbers = page.getByLabel('Plot a number…');
      await numbers.locator('option', { hasText: 'speed ahead' }).first().waitFor({ state: 'attached' });
      await numbers.selectOption('collector-2: base velocity.vx');
      await page.getByText('collector-2: base speed ahead').waitFor();
      await page.locator('[data-agent="collect-2"]').getByText('Received messages').waitFor();
      await restart('1');
      await eventually(async () => (await robots.count()) === 2, 'there is one collector');
      asked.length = 0;
      await page.waitForTimeout(500);
      expect(asked.filter((url) => url.includes('lect-2') || url.includes('lector-2'))).toEqual([]);
      await restart('2');
      await eventually(async () => (await robots.count()) === 3, 'there are two');
    }
  });
});
