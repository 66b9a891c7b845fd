import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { describe, expect } from 'vitest';
import { chromium } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';
import { longTest, visits } from './visits';

const OTHER = fileURLToPath(new URL('wander.yaml', import.meta.url));

describe.skipIf(!chromium)('a server that goes away', () => {
  const { openRun } = visits({ refusals: false });

  const layer = (page: Page, name: string) => page.getByRole('button', { name, exact: true });
  const gone = (page: Page) => page.getByText('Connection lost.');

  /** From now on: what is asked for, what of it fails or is refused, and what the page warns of. */
  function listen(page: Page) {
    const asked: string[] = [];
    const faults: string[] = [];
    page.on('request', (request) => asked.push(request.url()));
    page.on('requestfailed', (request) => faults.push(request.url()));
    page.on('response', (response) => {
      if (response.status() >= 400) {
        faults.push(`${response.status()} ${response.url()}`);
      }
    });
    page.on('console', (message) => {
      if (message.type() === 'warning') {
        faults.push(message.text());
      }
    });
    return { asked, faults };
  }

  longTest(
    'is left in peace until it is back, and what is there then is not asked for what was',
    async () => {
      const first = await Rsal.run('hunt-and-prey', '--port', '0');
      const page = await openRun(first.url, { mayFail: true, viewport: { width: 1400, height: 900 } });
      for (const name of ['Blobs', 'Links', 'Costs']) {
        await layer(page, name).click();
      }
      await page.locator('tr[data-robot="hunter-1"]').click();
      await page.locator('[data-reading]').first().waitFor();
      const before = listen(page);
      for (const polled of ['blobs', 'links', 'readings', 'agent']) {
        const isAsked = () => before.asked.some((url) => url.includes(`/api/${polled}?`));
        await eventually(() => Promise.resolve(isAsked()), `${polled} are asked for`);
      }
      expect(before.faults).toEqual([]);

      await first.end();
      await gone(page).waitFor();
      const { asked, faults } = listen(page);
      await page.waitForTimeout(2500);
      expect(asked).toEqual([]);

      const second = await Rsal.run(`${OTHER}:lasting`, '--port', first.port);
      await gone(page).waitFor({ state: 'hidden' });
      await page.locator('tr[data-robot="guard-1"][data-x]').waitFor();
      await eventually(() => Promise.resolve(asked.some((url) => url.includes('/api/links?'))), 'it goes on');
      await page.locator('tr[data-robot="guard-1"]').click();
      await page.locator('[data-reading]').first().waitFor();
      await page.getByText('has no cost map').waitFor({ state: 'attached' }); // another hint may have its place
      await page.waitForTimeout(1000);
      expect(asked.filter((url) => /hunter|prey/.test(url))).toEqual([]);
      expect(faults).toEqual([]);
      await second.end();
    },
  );

  longTest('may answer about a robot of a run that is not there any more', async () => {
    const rsal = await Rsal.run('hunt-and-prey', '--port', '0');
    const page = await openRun(rsal.url);
    const { faults } = listen(page);
    await layer(page, 'Costs').click();
    let answer = () => {};
    let asked = false;
    await page.route(/\/api\/abilities/, async (route) => {
      asked = true;
      await new Promise<void>((resolve) => (answer = resolve));
      await route.continue();
    });
    await page.locator('tr[data-robot="hunter-1"]').click();
    await eventually(() => Promise.resolve(asked), 'it is asked for');
    await rsal.post('restart', { configuration: 'virtual', arguments: {}, seed: '3' });
    await page.locator('tr.card').waitFor({ state: 'detached' });
    await page.locator('header').getByText('seed 3').waitFor();
    const answered = page.waitForResponse(/\/api\/abilities/);
    answer();
    await answered;
    await page.waitForTimeout(300);
    expect(faults).toEqual([]);
    await rsal.end();
  });
});
