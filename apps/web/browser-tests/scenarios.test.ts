import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { chromium } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';
import { expectAccessible, longTest, picture, visits } from './visits';

const OWN = fileURLToPath(new URL('talk.yaml', import.meta.url));

describe.skipIf(!chromium)('the choice of a scenario', () => {
  const { open } = visits();
  let rsal: Rsal;

  beforeAll(async () => {
    rsal = await Rsal.serve(OWN, '--port', '0');
  });

  const opened = (url: string, colorScheme: 'light' | 'dark' = 'light', width = 1280) =>
    open(url, { viewport: { width, height: 800 }, colorScheme });

  const catalog = (page: Page) => page.getByRole('dialog', { name: 'Scenarios' });
  const card = (page: Page, id: string) => catalog(page).locator(`[data-scenario="${id}"]`);

  longTest('comes first, with a picture of each, while the first run waits', async () => {
    const page = await opened(rsal.url);
    await catalog(page).waitFor();
    await eventually(
      async () => (await catalog(page).locator('[data-scenario]').count()) > 5,
      'all scenarios are there',
    );
    expect(await catalog(page).locator('[data-scenario]').first().getAttribute('data-scenario')).toBe(OWN);
    await eventually(
      () =>
        card(page, 'hunt-and-prey')
          .locator('img')
          .evaluate((image: HTMLImageElement) => image.complete && image.naturalWidth > 300),
      'its picture is drawn',
    );
    await eventually(async () => (await page.getByTestId('rate').innerText()).includes('paused'), 'it waits');
    await picture(page, 'scenarios-light');
    await expectAccessible(page, 'dialog[open]');
  });

  it('runs another one, as it is asked', async () => {
    const page = await opened(rsal.url);
    await card(page, 'hunt-and-prey')
      .getByRole('button', { name: /^Choose/ })
      .click();
    const form = page.getByRole('dialog', { name: /^Run: Hunters/ });
    await form.getByLabel('hunters', { exact: true }).waitFor();
    expect(await form.getByLabel('Seed').inputValue()).toBe('42');
    await form.getByLabel('Configuration').selectOption('advanced');
    await eventually(
      async () => (await form.getByLabel('hunters', { exact: true }).inputValue()) === '4',
      'the configuration has its own arguments',
    );
    await form.getByLabel('hunters', { exact: true }).fill('40');
    await form.getByRole('button', { name: 'Run', exact: true }).click();
    await form
      .getByText(/hunters.*20/)
      .first()
      .waitFor();
    await form.getByLabel('hunters', { exact: true }).fill('3');
    await form.getByLabel('Seed').fill('5');
    await picture(page, 'scenarios-form');
    await form.getByRole('button', { name: 'Run', exact: true }).click();
    await page.locator('tr[data-robot="hunter-3"]').waitFor();
    expect(await page.getByRole('banner').innerText()).toContain('hunt-and-prey:advanced · seed 5');
    expect(await page.locator('tr[data-robot="hunter-4"]').count()).toBe(0);
    await eventually(async () => !(await page.getByTestId('rate').innerText()).includes('paused'), 'it runs');
  });

  longTest('is there by a key, and takes another host for the agents', async () => {
    const page = await opened(rsal.url.replace('&choose', ''), 'dark', 480);
    await page.locator('tr[data-robot]').first().waitFor();
    await page.keyboard.press('c');
    await card(page, OWN).waitFor();
    await picture(page, 'scenarios-narrow-dark');
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    expect(wide).toBeLessThanOrEqual(480);
    await card(page, OWN)
      .getByRole('button', { name: /^Choose/ })
      .click();
    const form = page.getByRole('dialog', { name: /^Run: A team/ });
    await form.getByLabel('Agent platform').selectOption('jason');
    await form.getByRole('button', { name: 'Run', exact: true }).click();
    await page.locator('tr[data-robot="courier-1"]').waitFor();
    await form.waitFor({ state: 'hidden' });
    await page.keyboard.press('r');
    const again = page.getByRole('dialog', { name: 'Restart' });
    expect(await again.getByLabel('Agent platform').inputValue()).toBe('jason');
    await page.keyboard.press('Escape');
  });

  longTest('can be looked at without the token, and changes nothing then', async () => {
    const page = await opened(rsal.url.split('#')[0]!);
    await page.getByRole('button', { name: 'Scenarios…' }).click();
    await card(page, 'patrol').waitFor();
    expect(
      await catalog(page)
        .getByRole('button', { name: /^Choose/ })
        .count(),
    ).toBe(0);
  });
});
