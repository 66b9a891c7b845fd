import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { chromium } from './chromium';
import { eventually, settled } from './eventually';
import { Rsal } from './rsal';
import { expectAccessible, longTest, picture, visits } from './visits';

const OWN = fileURLToPath(new URL('wander.yaml', import.meta.url));

describe.skipIf(!chromium)('a sweep', () => {
  const { open } = visits();
  let rsal: Rsal;
  let folder: string;

  beforeAll(async () => {
    folder = mkdtempSync(join(tmpdir(), 'rsal-sweeps-'));
    rsal = await Rsal.serve(OWN, '--port', '0', '--sweeps', folder);
  });

  afterAll(async () => {
    await Rsal.endAll();
    rmSync(folder, { recursive: true, force: true });
  });

  const opened = (url: string, colorScheme: 'light' | 'dark' = 'light') => open(url, { colorScheme });

  const form = (page: Page) => page.getByRole('dialog', { name: 'Sweep: Robots that wander' });
  const progress = (page: Page) => page.getByTestId('sweep-progress');
  const status = (page: Page) => page.locator('dialog[open] .status');

  async function choose(page: Page) {
    await page
      .locator(`[data-scenario="${OWN}"]`)
      .getByRole('button', { name: /^Sweep/ })
      .click();
    await form(page).getByLabel('guards').waitFor();
  }

  /** How many have ended, as the page says. */
  async function ended(page: Page): Promise<number> {
    return parseInt(await progress(page).innerText());
  }

  longTest('is told how large it is before it begins, and what is wrong with it', async () => {
    const page = await opened(rsal.url);
    await choose(page);
    await form(page).getByText('10 runs: 1 combination × 10 seeds').waitFor();
    await form(page)
      .getByText(/^Without real: in real time runs disturb each other/)
      .waitFor();
    expect(await form(page).getByLabel(/^real/).count()).toBe(0);
    await form(page).getByLabel('guards').fill('1,9');
    await form(page)
      .getByText(/must be.*not '9'/)
      .waitFor();
    expect(await form(page).getByRole('button', { name: 'Begin' }).isDisabled()).toBe(true);
    expect(await form(page).getByLabel('guards').getAttribute('aria-invalid')).toBe('true');
    await form(page).getByLabel('guards').fill('1:4');
    await form(page).getByLabel('lasting: A minute').check();
    await form(page).getByLabel('four-rooms').check();
    await form(page).getByLabel('Seeds').fill('101-105');
    await form(page).getByText('80 runs: 16 combinations × 5 seeds').waitFor();
    await picture(page, 'sweep-form-light');
    await expectAccessible(page, 'dialog[open]');
  });

  it('grows to its end, and is reported', async () => {
    const page = await opened(rsal.url, 'dark');
    await choose(page);
    await form(page).getByLabel('guards').fill('1,2');
    await form(page).getByLabel('Seeds').fill('15');
    await form(page).getByText('30 runs: 2 combinations × 15 seeds').waitFor();
    await picture(page, 'sweep-form-dark');
    await form(page).getByRole('button', { name: 'Begin' }).click();
    const seen = new Set<number>();
    await eventually(async () => {
      seen.add(await ended(page));
      return (await status(page).innerText()) === 'Ended';
    }, 'it ends');
    expect(seen.size).toBeGreaterThan(1);
    expect(await progress(page).innerText()).toBe('30 of 30 runs');
    const row = page.locator('[data-combination="guards=2"]');
    expect(await row.innerText()).toMatch(/100 %[^]*±[^]*n = 15/);
    await row.getByRole('img', { name: /^way: quartiles/ }).waitFor();
    await picture(page, 'sweep-dark');
    const table = page.getByRole('region', { name: 'Results so far' });
    expect(await table.evaluate((node) => node.scrollWidth - node.clientWidth), 'all columns are seen').toBe(
      0,
    );
    await expectAccessible(page, 'dialog[open]');

    await page.getByRole('button', { name: 'Runs of guards=2', exact: true }).click();
    await page.locator('[data-run]').nth(14).waitFor();
    await picture(page, 'sweep-runs');
    await expectAccessible(page, 'dialog[open]');
    const fifth = page.locator('[data-run]').nth(4);
    const seed = /\d+/.exec(await fifth.locator('span').first().innerText())![0];
    await fifth.getByRole('button', { name: 'Watch' }).click();
    await form(page).waitFor({ state: 'hidden' }); // keys are the dialog's until then
    await page.getByText(`seed ${seed}`).first().waitFor(); // of the run that is shown now
    await eventually(async () => (await page.locator('tr[data-robot]').count()) === 2, 'with two robots');
    await page.keyboard.press('x');
    await status(page).waitFor();

    const [report] = await Promise.all([
      page.context().waitForEvent('page'),
      page.getByRole('link', { name: 'Open the report' }).click(),
    ]);
    await report.getByRole('heading', { name: 'Robots that wander' }).waitFor();
    expect(await report.getByText('30 runs of 2 combinations with 15 seeds').count()).toBe(1);
    expect(await report.locator('h1').evaluate((h) => getComputedStyle(h).lineHeight)).toBe('35px'); // its style counts
    await picture(report, 'sweep-report');
  });

  longTest('is stopped without half a row, and gone on with by the command that it shows', async () => {
    const page = await opened(rsal.url);
    await choose(page);
    await form(page).getByLabel('brief: Five seconds').uncheck();
    await form(page).getByLabel('lasting: A minute').check();
    await form(page).getByLabel('guards').fill('1:4');
    await form(page).getByLabel('Seeds').fill('12');
    await form(page).getByText('48 runs').waitFor();
    await form(page).getByRole('button', { name: 'Begin' }).click();
    await eventually(async () => (await ended(page)) >= 5, 'it grows');
    await picture(page, 'sweep-light');
    await page.getByRole('dialog').getByRole('button', { name: 'Stop', exact: true }).click();
    await eventually(async () => (await status(page).innerText()) === 'Stopped', 'it stops');
    const stopped = await ended(page);
    expect(stopped).toBeLessThan(48);
    await expectAccessible(page, 'dialog[open]');
    const rows = () =>
      readFileSync(join(folder, 'wander-2', 'rows.jsonl'), 'utf8')
        .trimEnd()
        .split('\n');
    expect(rows().map((row) => (JSON.parse(row) as { outcome: string }).outcome)).toHaveLength(stopped);

    await page.getByRole('button', { name: 'Resume the sweep' }).click();
    await eventually(async () => (await ended(page)) > stopped, 'it goes on');
    await page.getByRole('dialog').getByRole('button', { name: 'Stop', exact: true }).click();
    await eventually(async () => (await status(page).innerText()) === 'Stopped', 'it stops again');
    const command = (await page.locator('dialog[open] .body > pre').innerText()).split(' ');
    expect(command[0]).toBe('rsal');
    await Rsal.headless(...command.slice(1));
    expect(rows()).toHaveLength(48);
  });

  longTest('of a server that is gone is gone on with', async () => {
    const left = join(folder, 'wander-9');
    cpSync(join(folder, 'wander-2'), left, { recursive: true });
    const rows = readFileSync(join(left, 'rows.jsonl'), 'utf8').split('\n').slice(0, 40);
    writeFileSync(join(left, 'rows.jsonl'), rows.join('\n') + '\n{"run": 41, "se');
    const page = await opened(rsal.url);
    await page.getByRole('button', { name: 'Newest sweep' }).click();
    const earlier = page.locator('[data-sweep="wander-9"]');
    await earlier.getByText('40 of 48 runs').waitFor();
    await picture(page, 'sweeps-before');
    await expectAccessible(page, 'dialog[open]');
    await earlier.getByRole('button', { name: 'Resume wander-9' }).click();
    await eventually(async () => (await status(page).innerText()) === 'Ended', 'it ends');
    expect(await progress(page).innerText()).toBe('48 of 48 runs');
    const all = readFileSync(join(left, 'rows.jsonl'), 'utf8').trimEnd().split('\n');
    expect(all.slice(0, 40)).toEqual(rows);
    expect(new Set(all.map((row) => (JSON.parse(row) as { run: number }).run)).size).toBe(48);
  });

  longTest('can be looked at by a key and without the token, and not be touched then', async () => {
    const page = await opened(rsal.url.split('#')[0]!, 'dark');
    await page.locator('tr[data-robot]').first().waitFor();
    await page.keyboard.press('x');
    await status(page).waitFor();
    await page.setViewportSize({ width: 480, height: 800 });
    await picture(page, 'sweep-narrow-dark');
    const wide = () => page.evaluate(() => document.documentElement.scrollWidth);
    expect(await settled(wide, 'all has its place')).toBeLessThanOrEqual(480);
    const dialog = page.getByRole('dialog', { name: 'Sweep: Robots that wander' });
    await dialog.getByRole('link', { name: 'Open the report', exact: true }).waitFor();
    const earlier = dialog.locator('[data-sweep="wander-1"]');
    expect(await earlier.innerText()).toContain('30 of 30 runs');
    await earlier.getByText('The same in a terminal').click();
    expect(await earlier.locator('pre').innerText()).toMatch(/^rsal sweep .*wander-1$/);
    await expectAccessible(page, 'dialog[open]');
    await earlier.scrollIntoViewIfNeeded();
    await picture(page, 'sweeps-earlier-narrow-dark');
    const [report] = await Promise.all([
      page.context().waitForEvent('page'),
      earlier.getByRole('link', { name: 'Open the report of wander-1' }).click(),
    ]);
    await report.getByText('30 runs of 2 combinations with 15 seeds').waitFor();
    await report.close();
    await dialog.getByRole('button', { name: 'Runs of guards=1', exact: true }).click();
    await dialog.locator('[data-run]').first().waitFor();
    const buttons = await dialog.getByRole('button').allInnerTexts();
    expect(buttons.filter((text) => !/^\d*$/.test(text))).toEqual([]); // one closes it, others list runs
    await page.keyboard.press('Escape');
    await page.keyboard.press('c');
    await page.getByRole('button', { name: 'Newest sweep' }).click();
    await dialog.waitFor();
  });
});
