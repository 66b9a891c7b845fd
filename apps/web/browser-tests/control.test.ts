import { AxeBuilder } from '@axe-core/playwright';
import { chromium as driver, type Browser, type BrowserContext, type Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { chromium, flags } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';

const PICTURES = process.env.PICTURES;

describe.skipIf(!chromium)('control, of several who have the token', () => {
  let rsal: Rsal;
  let browser: Browser | undefined;
  const contexts: BrowserContext[] = [];
  let ann: Page;
  let bob: Page;

  beforeAll(async () => {
    [rsal, browser] = await Promise.all([
      Rsal.run('patrol', '--port', '0'),
      driver.launch({ executablePath: chromium!, args: flags }),
    ]);
    [ann, bob] = await Promise.all([open(), open()]);
  });

  afterAll(async () => {
    await browser?.close();
    await Rsal.endAll();
  });

  async function open(): Promise<Page> {
    const context = await browser!.newContext({ viewport: { width: 1280, height: 800 } });
    contexts.push(context);
    const page = await context.newPage();
    await page.goto(rsal.url);
    await page.locator('tr[data-robot][data-x]').first().waitFor();
    return page;
  }

  const pause = (page: Page) => page.getByRole('button', { name: /^(Pause|Resume)$/ });

  async function take(page: Page, name: string) {
    const dialog = page.getByRole('dialog', { name: 'Take control' });
    await dialog.getByLabel('Your name').fill(name);
    await dialog.getByRole('button', { name: /^Take/ }).click();
    await page.getByRole('button', { name: /^Give control back/ }).waitFor();
  }

  it('is taken by a click, and leaves the others to watch', async () => {
    expect(await pause(bob).isEnabled()).toBe(true);
    await ann.getByRole('button', { name: 'Take control', exact: true }).click();
    if (PICTURES) {
      await ann.screenshot({ path: `${PICTURES}/control-take.png` });
    }
    await take(ann, 'Ann');
    await bob.getByRole('button', { name: 'Ann has control' }).waitFor();
    expect(await pause(bob).isEnabled()).toBe(false);
    expect(await pause(ann).isEnabled()).toBe(true);
    if (PICTURES) {
      await bob.screenshot({ path: `${PICTURES}/control-others.png` });
    }
    const found = await new AxeBuilder({ page: bob }).analyze();
    expect(found.violations.map(({ id, nodes }) => `${id}: ${nodes[0]?.html ?? ''}`)).toEqual([]);
  });

  it('is kept for as long as its page is there', async () => {
    await ann.waitForTimeout(12_000);
    await bob.getByRole('button', { name: 'Ann has control' }).waitFor();
  });

  it('leaves the emergency stop to all', async () => {
    await bob.keyboard.press('F8');
    await ann.getByText('no robot moves until they are armed').waitFor();
    await ann
      .getByRole('button', { name: /^(Re-arm|Arm)/ })
      .first()
      .click();
  });

  it('is taken over, which whoever had it is told', async () => {
    await bob.getByRole('button', { name: 'Ann has control' }).click();
    await take(bob, 'Bob');
    await ann.getByText('Bob has taken control.').waitFor();
    await eventually(async () => !(await pause(ann).isEnabled()), 'Ann only watches');
  });

  it('is given back, also by closing the page', async () => {
    await bob.close();
    await eventually(() => pause(ann).isEnabled(), 'all may act again');
    await ann.getByRole('button', { name: 'Take control', exact: true }).waitFor();
  });
});
