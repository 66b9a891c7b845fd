import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { chromium } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';
import { expectAccessible, longTest, picture, visits } from './visits';

describe.skipIf(!chromium)('control, of several who have the token', () => {
  const { openRun } = visits();
  let rsal: Rsal;
  let ann: Page;
  let bob: Page;

  beforeAll(async () => {
    rsal = await Rsal.run('patrol', '--port', '0');
    [ann, bob] = await Promise.all([openRun(rsal.url), openRun(rsal.url)]);
  });

  const pause = (page: Page) => page.getByRole('button', { name: /^(Pause|Resume)$/ });

  async function take(page: Page, name: string) {
    const dialog = page.getByRole('dialog', { name: 'Take control' });
    await dialog.getByLabel('Your name').fill(name);
    await dialog.getByRole('button', { name: /^Take/ }).click();
    await page.getByRole('button', { name: /^Give control back/ }).waitFor();
  }

  it('is taken by a click, and leaves the others to watch', async () => {
    expect(await pause(bob).isEnabled()).toBe(true);
    const stop = bob.getByRole('button', { name: 'Emergency stop', exact: true });
    const before = await stop.boundingBox();
    await ann.getByRole('button', { name: 'Take control', exact: true }).click();
    await picture(ann, 'control-take');
    await take(ann, 'Ann');
    await bob.getByRole('button', { name: 'Ann has control' }).waitFor();
    expect(await stop.boundingBox(), 'it is where it was').toEqual(before);
    expect(await pause(bob).isEnabled()).toBe(false);
    expect(await pause(ann).isEnabled()).toBe(true);
    await picture(bob, 'control-others');
    await expectAccessible(bob);
  });

  longTest('is kept for as long as its page is there', async () => {
    await ann.waitForTimeout(12_000);
    await bob.getByRole('button', { name: 'Ann has control' }).waitFor();
  });

  it('leaves the emergency stop to all', async () => {
    await bob.keyboard.press('F8');
    await ann.getByText('Press Arm to switch them on').waitFor();
    await ann
      .getByRole('button', { name: /^(Re-arm|Arm)/ })
      .first()
      .click();
  });

  it('leaves it to all to stop one robot, but not to have it go on', async () => {
    await bob.locator('tr[data-robot]').first().click();
    await bob.getByRole('button', { name: 'Motors off', exact: true }).click();
    await ann
      .locator('.banner')
      .getByText(/^Motors of .+ are off until they are switched on by its card\.$/)
      .waitFor();
    const on = bob.getByRole('button', { name: 'Motors on', exact: true });
    await on.waitFor();
    expect(await on.isDisabled()).toBe(true);
    await ann.locator('tr[data-robot]').first().click();
    await ann.getByRole('button', { name: 'Motors on', exact: true }).click();
    await bob.getByRole('button', { name: 'Motors off', exact: true }).waitFor();
  });

  it('is taken over, of which whoever had it is informed', async () => {
    await bob.getByRole('button', { name: 'Ann has control' }).click();
    await take(bob, 'Bob');
    await ann.getByText('Bob has taken control.').waitFor();
    await eventually(async () => !(await pause(ann).isEnabled()), 'Ann only watches');
  });

  longTest(
    'stays with the first of two tabs when it is duplicated, which takes along all that it keeps',
    async () => {
      const kept = await bob.evaluate(() => Object.entries(sessionStorage) as [string, string][]);
      const twin = await bob.context().newPage();
      await twin.addInitScript((all) => {
        if (sessionStorage.length === 0) {
          all.forEach(([name, value]) => sessionStorage.setItem(name, value));
        }
      }, kept);
      await twin.goto(rsal.origin);
      await twin.getByRole('button', { name: 'Bob has control' }).waitFor();
      await twin.waitForTimeout(3000); // in which both ask again
      await twin.close();
      await bob.getByRole('button', { name: /^Give control back/ }).waitFor();
      await ann.getByRole('button', { name: 'Bob has control' }).waitFor();
    },
  );

  longTest('is given back, also by closing the page', async () => {
    await ann.keyboard.press('p');
    const why = ann.getByText('Bob has control: all you may do is to watch');
    await why.waitFor();
    await bob.close();
    await why.waitFor({ state: 'detached', timeout: 6000 }); // sooner than it goes by itself
    await eventually(() => pause(ann).isEnabled(), 'all may act again');
    await ann.getByRole('button', { name: 'Take control', exact: true }).waitFor();
  });
});
