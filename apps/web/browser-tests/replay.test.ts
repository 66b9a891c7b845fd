import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { AxeBuilder } from '@axe-core/playwright';
import { chromium as driver, type Browser, type BrowserContext, type Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, describe, expect, it } from 'vitest';
import { chromium, flags } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';

const PICTURES = process.env.PICTURES;

describe.skipIf(!chromium)('looking back', () => {
  const folder = mkdtempSync(join(tmpdir(), 'rsal-replay-'));
  const file = join(folder, 'hunt.mcap');
  let recorded: Rsal;
  let running: Rsal;
  let browser: Browser;
  let contexts: BrowserContext[] = [];
  let faults: string[] = [];
  let page: Page;

  beforeAll(async () => {
    await Rsal.headless(
      ...['run', 'hunt-and-prey', '--headless', '--speed', 'max', '--seed', '5', '--record', file],
    );
    [recorded, running, browser] = await Promise.all([
      Rsal.replay(file, '--port', '0'),
      Rsal.run('hunt-and-prey', '--port', '0', '--seed', '5'),
      driver.launch({ executablePath: chromium!, args: flags }),
    ]);
  }, 120_000);

  afterAll(async () => {
    await browser.close();
    await Rsal.endAll();
    rmSync(folder, { recursive: true });
  });

  afterEach(async () => {
    await Promise.all(contexts.map((context) => context.close()));
    contexts = [];
    expect(faults).toEqual([]);
  });

  async function open(url: string, options: Parameters<Browser['newContext']>[0] = {}) {
    faults = [];
    const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
    contexts.push(context);
    page = await context.newPage();
    page.on('pageerror', (error) => faults.push(error.message));
    page.on('console', (message) => {
      if (message.type() === 'error') {
        faults.push(message.text());
      }
    });
    await page.goto(url);
    await page.locator('tr[data-robot][data-x]').first().waitFor();
    await cursor().waitFor();
  }

  const cursor = () => page.getByRole('slider', { name: 'Time that is shown' });
  const button = (name: string) => page.getByRole('button', { name, exact: true });

  async function time(): Promise<number> {
    const text = await page.getByTestId('time').innerText();
    return text.split(':').reduce((sum, part) => 60 * sum + Number(part), 0);
  }

  const shows = (least: number, most: number) =>
    eventually(
      async () => (await time()) >= least && (await time()) <= most,
      `${String(least)} to ${String(most)} s are shown`,
    );

  async function pose(robot: string) {
    const row = page.locator(`tr[data-robot="${robot}"]`);
    return Promise.all(['data-x', 'data-y', 'data-heading'].map((name) => row.getAttribute(name)));
  }

  async function picture(name: string) {
    if (PICTURES) {
      await page.screenshot({ path: join(PICTURES, `${name}.png`) });
    }
  }

  it('plays a recording, which can only be looked at', async () => {
    await open(recorded.url);
    const begin = await time();
    await eventually(async () => (await time()) > begin + 1, 'it plays');
    expect(await page.locator('.view-only').innerText()).toContain('Recording');
    expect(await button('Emergency stop').count()).toBe(0);
    expect(await page.getByRole('button', { name: 'Restart' }).count()).toBe(0);
    expect(await button('Live').count()).toBe(0);
    await page.locator('tr[data-robot="hunter-1"]').click();
    await page.locator('div.card').waitFor();
    expect(await button('Drive by keys').isDisabled()).toBe(true);
    expect(await button('Send').isDisabled()).toBe(true);
    expect(await button('Motors off').isDisabled()).toBe(true);
    await expect(recorded.post('estop')).rejects.toThrow('This is a recording');
    await button('Pause').click();
    await button('Resume').waitFor();
    await page.waitForTimeout(400);
    const paused = await time();
    await page.waitForTimeout(700);
    expect(await time()).toBe(paused);
    await button('Step').click();
    await shows(paused + 0.05, paused + 0.15);
    await page.keyboard.press(',');
    await shows(paused - 0.05, paused + 0.05);
  });

  it('scrubs to and fro, and shows the same again', async () => {
    await open(recorded.url);
    await button('Pause').click();
    await button('Resume').waitFor();
    await cursor().fill('20');
    await shows(19.9, 20.1);
    await page.waitForTimeout(400);
    const there = await pose('hunter-1');
    const known = await page.locator('ol li').count();
    await cursor().focus();
    await page.keyboard.press('End');
    await page.getByTestId('outcome').waitFor();
    expect(await page.locator('ol li').count()).toBeGreaterThan(known);
    expect(await page.getByTestId('outcome').innerText()).toBe('Success');
    await picture('replay-end');
    await cursor().fill('20');
    await shows(19.9, 20.1);
    await eventually(
      async () => String(await pose('hunter-1')) === String(there),
      'it stands where it stood',
    );
    await page.getByTestId('outcome').waitFor({ state: 'detached' });
    await eventually(
      async () => (await page.locator('ol li').count()) === known,
      'what had not happened yet is not told',
    );
    await cursor().press('ArrowRight');
    await shows(20.05, 20.15);
  });

  it('marks what happened, in words, and goes there', async () => {
    await open(recorded.url);
    const caught = page.locator('.mark.caught').first();
    await caught.hover();
    expect(await page.locator('.words').innerText()).toContain('is caught by');
    expect(await caught.getAttribute('aria-label')).toContain('is caught by');
    await button('Pause').click();
    await button('Resume').waitFor();
    await caught.click();
    const when = /^(\d+):([\d.]+)/.exec((await caught.getAttribute('aria-label')) ?? '');
    const seconds = 60 * Number(when![1]) + Number(when![2]);
    await shows(seconds - 0.05, seconds + 0.05);
    await page.keyboard.press('[');
    await shows(0, 0.1);
    await page.keyboard.press(']');
    await shows(seconds - 0.05, seconds + 0.15);
    await page.locator('.mark[tabindex="0"]').focus();
    await page.keyboard.press('End');
    expect(
      await page
        .locator('.mark')
        .last()
        .evaluate((mark) => mark === document.activeElement),
    ).toBe(true);
  });

  it('has no accessibility violations, light or dark, wide or narrow', async () => {
    for (const [name, options] of Object.entries({
      light: {},
      dark: { colorScheme: 'dark' as const },
      narrow: { viewport: { width: 760, height: 1000 } },
    })) {
      await open(recorded.url, options);
      await cursor().fill('30');
      await shows(29.9, 34);
      await page.locator('.mark.caught').first().hover();
      await picture(`replay-${name}`);
      expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
      const box = (await page.locator('.timeline').boundingBox())!;
      expect(box.x + box.width).toBeLessThanOrEqual(options.viewport?.width ?? 1280);
    }
  });

  it('looks back in a run that goes on, and to the present again', async () => {
    await running.post('restart', { configuration: 'virtual', seed: '5' });
    await open(running.url);
    await eventually(async () => (await time()) > 4, 'it has run a while');
    await cursor().fill('2');
    await shows(1.9, 2.1);
    expect(await page.locator('.timeline').getAttribute('data-past')).toBe('true');
    await picture('live-back');
    await button('Resume').waitFor();
    expect(await button('Stop').isDisabled()).toBe(true);
    expect(await button('Emergency stop').isDisabled()).toBe(false);
    const now = async () =>
      ((await (await fetch(`${running.origin}/api/status`)).json()) as { time: number }).time;
    const before = await now();
    await eventually(async () => (await now()) > before + 0.5, 'the run goes on');
    expect(await time()).toBeLessThan(2.2);
    await button('Resume').click(); // plays what has been
    await eventually(async () => (await time()) > 2.5, 'it plays');
    await button('Live').click();
    await eventually(async () => (await time()) > before, 'the present is shown');
    expect(await page.locator('.timeline').getAttribute('data-past')).toBe('false');
    await page.keyboard.press(',');
    await eventually(
      async () => (await page.locator('.timeline').getAttribute('data-past')) === 'true',
      'it looks back',
    );
    await page.keyboard.press('l');
    await eventually(
      async () => (await page.locator('.timeline').getAttribute('data-past')) === 'false',
      'it is in the present again',
    );
  });
});
