import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { chromium } from './chromium';
import { Rsal } from './rsal';
import { expectAccessible, longTest, picture, visits } from './visits';

const TEXT = `rsal: 1
scenario: own
title: My own
world: {map: office}
robots:
  one:
    model: pioneer2dx
    pose: {free: true}
`;

describe.skipIf(!chromium)('the editor of texts', () => {
  const { openRun } = visits();
  let folder: string;
  let file: string;
  let rsal: Rsal;

  beforeAll(async () => {
    folder = await mkdtemp(join(tmpdir(), 'rsal-editor-'));
    file = join(folder, 'own.yaml');
    await writeFile(file, TEXT);
    rsal = await Rsal.run(file, '--port', '0');
  });

  afterAll(async () => {
    await Rsal.endAll();
    await rm(folder, { recursive: true });
  });

  const opened = (colorScheme: 'light' | 'dark' = 'light', width = 1280) =>
    openRun(rsal.url, { viewport: { width, height: 800 }, colorScheme });

  const dialog = (page: Page) => page.getByRole('dialog', { name: /^Edit: / });
  const text = (page: Page) => dialog(page).getByRole('textbox', { name: 'Text of the scenario' });

  async function edit(page: Page) {
    await page.getByRole('button', { name: 'Restart…' }).click();
    await page.getByRole('button', { name: 'Edit…', exact: true }).click();
    await text(page).waitFor();
    await dialog(page).getByText('No errors.').waitFor();
  }

  it('is not loaded before it is opened', async () => {
    const page = await opened();
    const loaded: string[] = [];
    page.on('request', (request) => loaded.push(request.url()));
    const before = await page.evaluate(() =>
      performance.getEntriesByType('resource').map(({ name }) => name),
    );
    expect(before.some((name) => /\/editor-/.test(name))).toBe(false);
    await edit(page);
    expect(loaded.some((name) => /\/editor-/.test(name))).toBe(true);
  });

  longTest('offers to save what can be saved, and says why all else can not', async () => {
    const page = await opened();
    await page.keyboard.press('c');
    await page.getByRole('button', { name: /^Edit: My own/ }).click();
    await dialog(page).getByText('Ctrl-S: save').waitFor();
    await page.keyboard.press('Escape');
    await dialog(page).waitFor({ state: 'hidden' });
    await page.keyboard.press('c');
    await page.getByRole('button', { name: /^Edit: Hunters chase/ }).click();
    await dialog(page)
      .getByText(/^This scenario comes with RSAL/)
      .waitFor(); // as a sentence of its own
    expect(await dialog(page).innerText()).not.toContain('Ctrl-S:');
    await picture(page, 'editor-built');
  });

  it('underlines an error where it is, with its remedy', async () => {
    const page = await opened();
    const errors: string[] = [];
    page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
    await edit(page);
    await text(page).press('Control+End');
    await page.keyboard.type('    colr: 3');
    await dialog(page).locator('.error', { hasText: 'colr' }).waitFor();
    const list = dialog(page).getByRole('list', { name: 'Errors' });
    expect(await list.innerText()).toMatch(/colr[^]*color/);
    await picture(page, 'editor-error-light');
    await expectAccessible(page, 'dialog[open]');
    await list.getByRole('button', { name: 'Line 9' }).click();
    await dialog(page).locator('.error').hover();
    await dialog(page).locator('.meaning').waitFor();
    expect(errors).toEqual([]); // as the Content-Security-Policy would have it
  });

  it('completes keys and values, and runs what was written', async () => {
    const page = await opened('dark');
    await edit(page);
    await text(page).press('Control+End');
    await page.keyboard.type('    col');
    await dialog(page)
      .getByRole('option', { name: /^color/ })
      .waitFor();
    await picture(page, 'editor-completion-dark');
    await page.waitForTimeout(100); // which the completion ignores keys for, so that none is hit by chance
    await page.keyboard.press('Enter');
    await page.keyboard.type('"#00aa00"');
    await page.keyboard.press('Enter');
    await page.keyboard.type('count: 2');
    await dialog(page).getByText('No errors.').waitFor();
    expect(await text(page).innerText()).toContain('color: "#00aa00"');
    await page.keyboard.press('Control+Enter');
    await dialog(page).waitFor({ state: 'hidden' });
    await page.locator('tr[data-robot="one-2"]').waitFor();
    expect(await page.getByRole('banner').innerText()).toContain('edited');
    expect(await readFile(file, 'utf8')).toBe(TEXT);
  });

  it('keeps the keys of the page from the text, but for the emergency stop on F8', async () => {
    const page = await opened();
    await edit(page);
    // the run has another text than the file, which can be saved as it is
    expect(await dialog(page).getByRole('button', { name: 'Save' }).isEnabled()).toBe(true);
    await text(page).press('Control+End');
    await page.keyboard.type('# p 0 space ');
    await dialog(page).getByText('No errors.').waitFor();
    expect(await page.getByRole('button', { name: /Re-arm/ }).count()).toBe(0);
    await page.keyboard.press('F8');
    await page
      .getByText(/emergency stop/i)
      .first()
      .waitFor();
    await rsal.post('rearm');
  });

  it('asks before it loses what was typed, and saves it', async () => {
    const page = await opened('light', 480);
    await page.keyboard.press('c');
    await page.getByRole('button', { name: /^Edit: My own/ }).click();
    await dialog(page).getByText('No errors.').waitFor();
    await text(page).press('Control+End');
    const checked = page.waitForResponse('**/api/scenarios/check');
    await page.keyboard.type('# more');
    await checked; // until then Escape may mean what is offered
    await page.keyboard.press('Escape');
    await page.getByText('would be lost').waitFor();
    await picture(page, 'editor-asks-narrow');
    await page.keyboard.press('Escape');
    await page.keyboard.press('Escape');
    await page.keyboard.press('Escape');
    expect(await text(page).innerText()).toContain('# more');
    await page.keyboard.press('Control+s');
    await dialog(page).getByText('Saved.').waitFor();
    expect(await readFile(file, 'utf8')).toBe(`${TEXT}# more`);
    await page.keyboard.press('Escape');
    await dialog(page).waitFor({ state: 'hidden' });
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    expect(wide).toBeLessThanOrEqual(480);
  });
});
