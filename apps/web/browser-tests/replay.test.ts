import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { Readings } from '../src/api/messages';
import { chromium } from './chromium';
import { eventually, settled } from './eventually';
import { Rsal } from './rsal';
import { expectAccessible, longTest, picture, visits } from './visits';
import { timeOn } from './world';

describe.skipIf(!chromium)('looking back', () => {
  const { openRun } = visits();
  const folder = mkdtempSync(join(tmpdir(), 'rsal-replay-'));
  const file = join(folder, 'hunt.mcap');
  let recorded: Rsal;
  let running: Rsal;
  let page: Page;

  beforeAll(async () => {
    await Rsal.headless(
      ...['run', 'hunt-and-prey', '--headless', '--speed', 'max', '--seed', '5', '--record', file],
    );
    [recorded, running] = await Promise.all([
      Rsal.replay(file, '--port', '0'),
      Rsal.run('hunt-and-prey', '--port', '0', '--seed', '5'),
    ]);
  }, 120_000);

  afterAll(async () => {
    await Rsal.endAll();
    rmSync(folder, { recursive: true });
  });

  async function look(url: string, options = {}) {
    page = await openRun(url, options);
    await cursor().waitFor();
  }

  /** The same, where it stands still at once. */
  async function lookPaused(url: string) {
    await look(url);
    await button('Pause').click();
    await button('Resume').waitFor();
  }

  const cursor = () => page.getByRole('slider', { name: 'Time that is shown' });
  const button = (name: string) => page.getByRole('button', { name, exact: true });

  const time = () => timeOn(page);

  /** How many events the page tells of. */
  const happened = async () =>
    Number(await page.locator('.panel', { hasText: 'Events' }).locator('.count').innerText());

  const shows = (least: number, most: number) =>
    eventually(
      async () => (await time()) >= least && (await time()) <= most,
      `${String(least)} to ${String(most)} s are shown`,
    );

  async function pose(robot: string) {
    const row = page.locator(`tr[data-robot="${robot}"]`);
    return Promise.all(['data-x', 'data-y', 'data-heading'].map((name) => row.getAttribute(name)));
  }

  it('plays a recording, which can only be looked at', async () => {
    await look(recorded.url);
    const begin = await time();
    await eventually(async () => (await time()) > begin + 1, 'it plays');
    expect(await page.locator('.view-only').innerText()).toContain('Recording');
    expect(await button('Emergency stop').count()).toBe(0);
    expect(await page.getByRole('button', { name: 'Restart' }).count()).toBe(0);
    expect(await button('Live').count()).toBe(0);
    await page.locator('tr[data-robot="hunter-1"]').click();
    await page.locator('div.card').waitFor();
    expect(await button('Drive by keys').isDisabled()).toBe(true);
    expect(await button('Send…').isDisabled()).toBe(true);
    expect(await button('Motors off').isDisabled()).toBe(true);
    await expect(recorded.post('estop')).rejects.toThrow('This is a recording');
    await button('Pause').click();
    await button('Resume').waitFor();
    const paused = await settled(time, 'time stands still');
    await button('Step').click();
    await shows(paused + 0.05, paused + 0.15);
    await page.keyboard.press(',');
    await shows(paused - 0.05, paused + 0.05);
  });

  longTest('shows what is left of a recording that was cut off, and says so', async () => {
    const whole = readFileSync(file);
    const left = join(folder, 'left.mcap');
    writeFileSync(left, whole.subarray(0, 0.6 * whole.length));
    const damaged = await Rsal.replay(left, '--port', '0');
    await look(damaged.url);
    await page.getByRole('alert').filter({ hasText: 'incomplete' }).waitFor();
    const begin = await time();
    await eventually(async () => (await time()) > begin + 1, 'it plays');
    await damaged.end();
  });

  it('scrubs to and fro, and shows the same again', async () => {
    await lookPaused(recorded.url);
    await cursor().fill('20');
    await shows(19.9, 20.1);
    await page.waitForTimeout(400);
    const there = await pose('hunter-1');
    const known = await happened();
    await cursor().focus();
    await page.keyboard.press('End');
    await page.getByTestId('outcome').waitFor();
    expect(await happened()).toBeGreaterThan(known);
    expect(await page.getByTestId('outcome').innerText()).toBe('Success');
    await picture(page, 'replay-end');
    await cursor().fill('20');
    await shows(19.9, 20.1);
    await eventually(
      async () => String(await pose('hunter-1')) === String(there),
      'it stands where it stood',
    );
    await page.getByTestId('outcome').waitFor({ state: 'detached' });
    await eventually(async () => (await happened()) === known, 'what had not happened yet is not told');
    await cursor().press('ArrowRight');
    await shows(20.05, 20.15);
  });

  it('marks what happened, in words, and goes there', async () => {
    await look(recorded.url);
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

  longTest('has no accessibility violations, light or dark, wide or narrow', async () => {
    for (const [name, options] of Object.entries({
      light: {},
      dark: { colorScheme: 'dark' as const },
      narrow: { viewport: { width: 760, height: 1000 } },
    })) {
      await look(recorded.url, options);
      await cursor().fill('30');
      await shows(29.9, 34);
      await page.locator('.mark.caught').first().hover();
      await picture(page, `replay-${name}`);
      await expectAccessible(page);
      const box = (await page.locator('.timeline').boundingBox())!;
      expect(box.x + box.width).toBeLessThanOrEqual(options.viewport?.width ?? 1280);
    }
  });

  it('informs whoever looks back that motors are off now, and arms them', async () => {
    await running.post('restart', { configuration: 'virtual', seed: '5' });
    await look(running.url);
    const second = Math.ceil(await time()) + 1; // while the page is open, as less is kept of what nobody watches
    await eventually(async () => (await time()) > second + 1, 'it has run a while');
    await cursor().fill(String(second));
    await shows(second - 0.5, second + 0.5);
    const shown = await time();
    await running.post('motors', { robot: 'hunter-1', on: false }); // by somebody else
    const banner = page.getByRole('status').filter({ hasText: 'In the present' });
    await banner.getByText('Motors of hunter-1 are off until they are switched on by its card.').waitFor();
    await running.post('estop');
    await banner.getByText('Motors are off. Press Arm to switch them on.').waitFor();
    expect(await time()).toBe(shown);
    await picture(page, 'live-back-stopped');
    await expectAccessible(page);
    await button('Arm').click();
    await button('Arm').waitFor({ state: 'detached' });
    await eventually(async () => (await time()) > second + 1, 'what moves is seen');
    await page.getByText('Press Arm to switch them on').waitFor({ state: 'hidden' });
    await page.getByText('Motors of hunter-1 are off until').waitFor();
    await running.post('motors', { robot: 'hunter-1', on: true });
  });

  longTest('tells what devices told and agents had in mind, as far as it was recorded', async () => {
    await lookPaused(recorded.url);
    await cursor().fill('20');
    await shows(19.9, 20.1);
    await page.locator('tr[data-robot="hunter-1"]').click();
    const laser = page.locator('[data-reading="laser"]');
    await laser.getByText('nearest').waitFor();
    const then = await laser.innerText();
    await page.locator('dd').getByText('not recorded').first().waitFor();
    const agent = page.locator('li[data-agent].open');
    await agent.getByText('History, newest first').click();
    await agent.locator('[data-change="BELIEVES"]').first().waitFor();
    await agent.getByText('Messages that were addressed to it').waitFor();
    await page.getByText('Plots', { exact: true }).click();
    await page.getByLabel('Plot a number…').selectOption({ label: 'speed ahead [m/s]' });
    await page.getByRole('button', { name: 'Resume' }).click();
    await eventually(async () => (await laser.innerText()) !== then, 'what it told goes on');
    await page.locator('figure path[d*="L"]').waitFor();
    await button('Pause').click();
    await picture(page, 'replay-readings');
    await expectAccessible(page, '.panels');
    await page.locator('tr[data-robot="hunter-1"] button').click(); // until now it was selected
    await page.locator('tr.card').waitFor({ state: 'detached' });
    await page.locator('figure path[d*="L"]').waitFor();
  });

  longTest(
    'begins a plot with what was before it was opened, wherever in the recording that is',
    async () => {
      await lookPaused(recorded.url);
      await cursor().fill('30');
      await shows(29.9, 30.1);
      await page.locator('tr[data-robot="hunter-1"]').click();
      await page.locator('[data-reading="navigator"]').getByText('goal').waitFor();
      await page.getByText('Plots', { exact: true }).click();
      await page.getByLabel('Plot a number…').selectOption({ label: 'speed ahead [m/s]' });
      const line = () =>
        page
          .locator('figure .lines path')
          .evaluateAll((paths) => paths.map((path) => path.getAttribute('d')).join(''));
      const points = async () => (await line()).match(/[ML][\d.-]+ [\d.-]+/g) ?? [];
      await eventually(async () => (await points()).length > 100, 'what was before is drawn');
      expect(parseFloat((await points())[0]!.slice(1))).toBeLessThan(5);
      await picture(page, 'replay-plot');
      await cursor().fill('10');
      await shows(9.9, 10.1);
      await cursor().fill('25');
      await shows(24.9, 25.1);
      await eventually(async () => (await points()).length > 100, 'it is there after jumps');
      expect((await line()).match(/M/g)).toHaveLength(1);
    },
  );

  longTest('stays where somebody jumps to who has just paused', async () => {
    await look(recorded.url);
    const begin = await time();
    await eventually(async () => (await time()) > begin + 0.5, 'it plays');
    await page.evaluate(() => {
      document.querySelector<HTMLButtonElement>('button[aria-label="Pause"]')!.click();
      const cursor = document.querySelector<HTMLInputElement>('.timeline input[type="range"]')!;
      cursor.value = '20';
      cursor.dispatchEvent(new Event('input', { bubbles: true }));
    });
    await button('Resume').waitFor();
    await shows(19.9, 20.1);
    await page.waitForTimeout(1000); // in which it would have gone on
    await shows(19.9, 20.1);
  });

  longTest(
    'asks where robots went before each moment that is jumped to, also while it is paused',
    async () => {
      await lookPaused(recorded.url);
      const asked: string[] = [];
      page.on('request', (request) => asked.push(request.url()));
      for (const seconds of [20, 40, 30]) {
        await cursor().fill(String(seconds));
        await shows(seconds - 0.1, seconds + 0.1);
        await eventually(
          () => Promise.resolve(asked.some((url) => url.endsWith(`/api/trails?time=${String(seconds)}`))),
          `of ${String(seconds)} s it is asked`,
        );
      }
      await picture(page, 'replay-trails');
    },
  );

  longTest(
    'tells of a run that goes on what devices had told and agents had in mind at each moment',
    async () => {
      await running.post('restart', { configuration: 'virtual', seed: '5' });
      await look(running.url);
      await eventually(async () => (await time()) > 8, 'it has run a while');
      await page.locator('tr[data-robot="hunter-1"]').click();
      const odometry = () => page.locator('[data-reading="base"]').innerText();
      const agent = page.locator('.inside').getByText('History, newest first');
      await page.locator('[data-reading="laser"]').getByText('nearest').waitFor();
      await agent.waitFor();
      const told: Record<number, string> = {};
      for (const seconds of [3, 7]) {
        await cursor().fill(String(seconds));
        await shows(seconds - 0.6, seconds + 0.6); // before a page is open, there are two moments a second
        const asked = `robot=hunter-1&time=${String(await time())}`;
        const answer = await fetch(`${running.origin}/api/readings?${asked}`);
        const { readings } = (await answer.json()) as Readings;
        const base = readings.find(({ device }) => device === 'base')!;
        const { value } = base.facts.find(({ name }) => name === 'odometry')!;
        await eventually(async () => (await odometry()).includes(value), 'the base told what it had');
        await page.locator('[data-reading="laser"]').getByText('nearest').waitFor();
        await agent.waitFor();
        told[seconds] = value;
      }
      expect(told[3]).not.toEqual(told[7]);
      await picture(page, 'live-back-card');
      await cursor().fill('3');
      await eventually(async () => (await odometry()).includes(told[3]!), 'it is as it was there');
    },
  );

  longTest('looks back in a run that goes on, and to the present again', async () => {
    await running.post('restart', { configuration: 'virtual', seed: '5' });
    await look(running.url);
    await eventually(async () => (await time()) > 4, 'it has run a while');
    await cursor().fill('2');
    await shows(1.4, 2.6);
    expect(await page.locator('.timeline').getAttribute('data-past')).toBe('true');
    await picture(page, 'live-back');
    await button('Resume').waitFor();
    expect(await button('Stop').isDisabled()).toBe(true);
    expect(await button('Emergency stop').isDisabled()).toBe(false);
    const now = async () =>
      ((await (await fetch(`${running.origin}/api/status`)).json()) as { time: number }).time;
    const before = await now();
    await eventually(async () => (await now()) > before + 0.5, 'the run goes on');
    expect(await time()).toBeLessThan(2.7);
    await button('Resume').click(); // plays what has been
    await eventually(async () => (await time()) > 2.8, 'it plays');
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
