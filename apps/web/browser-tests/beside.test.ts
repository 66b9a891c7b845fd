import { setTimeout } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import type { SideBySide } from '../src/api/messages';
import { chromium } from './chromium';
import { eventually, settled } from './eventually';
import { Rsal } from './rsal';
import { expectNoViolation, longTest, picture, violations, visits } from './visits';
import { timeOn } from './world';

const OWN = fileURLToPath(new URL('beside.yaml', import.meta.url));

describe.skipIf(!chromium)('runs side by side', () => {
  const { open, close } = visits();
  let rsal: Rsal;

  beforeEach(async () => {
    rsal = await Rsal.run(OWN, '--port', '0');
  });

  afterEach(async () => {
    await close();
    await Rsal.endAll();
  });

  /** Begins runs beside the first, and shows them all. */
  async function beside(page: Page, ...wishes: object[]) {
    for (const wish of wishes) {
      await rsal.beside(wish);
    }
    await page.keyboard.press('b');
    await page.locator(`section[data-run="${1 + wishes.length}"]`).waitFor();
  }

  const section = (page: Page, run: number) => page.locator(`section[data-run="${run}"]`);
  const frame = (page: Page, run: number) => section(page, run).frameLocator('iframe');

  /** Simulated seconds on a frame's own clock. */
  const time = (page: Page, run: number) => timeOn(frame(page, run));

  async function goesOn(page: Page, run: number) {
    const before = await time(page, run);
    await eventually(async () => (await time(page, run)) > before + 0.3, `run ${run} goes on`);
  }

  const areStopped = (page: Page, ...runs: number[]) =>
    eventually(
      async () =>
        (
          await Promise.all(
            runs.map((run) =>
              frame(page, run)
                .getByText(/Motors are off/)
                .isVisible(),
            ),
          )
        ).every(Boolean),
      `robots of ${runs.join(', ')} stand`,
    );

  /** What the server answers to that question from now on comes a second late, and may no longer be true by then. */
  async function answerLate(page: Page, question: string) {
    await page.route(question, async (route) => {
      const response = await route.fetch();
      await setTimeout(1000);
      await route.fulfill({ response });
    });
  }

  /** In the frames, too; each of these has landmarks of its own, as the page of one run has. */
  async function expectAccessible(page: Page) {
    await expectNoViolation(violations(page).exclude('iframe'));
    await expectNoViolation(violations(page).disableRules('landmark-unique'));
  }

  it('are begun by a click, go on, stop together by the space key, and are closed', async () => {
    const page = await open(rsal.url);
    await page.locator('tr[data-robot="guard-1"]').waitFor();
    await page.keyboard.press('r');
    const form = page.getByRole('dialog', { name: 'Restart' });
    await form.getByLabel('Configuration').selectOption('three');
    await picture(page, 'beside-restart');
    await form.getByRole('button', { name: 'Start side by side', exact: true }).click();

    await frame(page, 1).locator('tr[data-robot="guard-1"]').waitFor();
    await frame(page, 2).locator('tr[data-robot="guard-3"]').waitFor();
    expect(await frame(page, 1).locator('tr[data-robot="guard-2"]').count()).toBe(0);
    expect(await section(page, 1).locator('.head').innerText()).toContain('one · seed 7');
    expect(await section(page, 2).locator('.head').innerText()).toContain('three · seed 7');
    await Promise.all([goesOn(page, 1), goesOn(page, 2)]);
    await picture(page, 'beside-light');
    await expectAccessible(page);

    await page.keyboard.press('Space');
    await areStopped(page, 1, 2);
    await eventually(
      async () => (await section(page, 2).locator('.state').innerText()).includes('motors off'),
      'it is said over its frame',
    );
    await picture(page, 'beside-stopped');
    await page.getByRole('button', { name: 'Arm all', exact: true }).click();
    await eventually(
      async () => !(await page.getByRole('button', { name: 'Arm all', exact: true }).isVisible()),
      'they are armed',
    );

    await page.getByRole('button', { name: 'Close run 2', exact: true }).click();
    await section(page, 2).waitFor({ state: 'detached' });
    await goesOn(page, 1);
    await page.getByRole('button', { name: 'One run', exact: true }).click();
    await page.getByRole('button', { name: 'Restart…' }).waitFor();
    await eventually(
      () => page.getByRole('button', { name: 'Emergency stop', exact: true }).isEnabled(),
      'the token is still there',
    );
  });

  it('stop together when a frame has the focus, also one whose run is over', async () => {
    const page = await open(rsal.url);
    await page.locator('tr[data-robot="guard-1"]').waitFor();
    await beside(page, { configuration: 'brief', speed: 'max' });
    await eventually(
      async () => (await section(page, 2).locator('.state').innerText()).startsWith('Success'),
      'it ends, and that is said over its frame',
    );
    await picture(page, 'beside-over');
    await frame(page, 2).locator('#map').click();
    await page.keyboard.press('Space');
    await areStopped(page, 1);
    await rsal.post('rearm');
    await frame(page, 1).locator('#map').click();
    await page.keyboard.press('F8');
    await areStopped(page, 1);
  });

  longTest('stop together from the page of one that is over, or was closed', async () => {
    await rsal.beside({ configuration: 'three' });
    await rsal.beside({ configuration: 'three' });
    const page = await open(rsal.url);
    await page.locator('tr[data-robot="guard-1"]').waitFor();
    await rsal.post('stop');
    await page.getByTestId('outcome').waitFor();
    const isStopped = async (run: number) => {
      const all = await (await fetch(`${rsal.origin}/api/beside`)).json();
      return (all as SideBySide).runs.find(({ number }) => number === run)!.stopped;
    };
    await page.getByRole('button', { name: 'Emergency stop', exact: true }).click();
    await eventually(() => isStopped(2), 'run 2 stands');

    await page.goto(rsal.url.replace('/#', '/beside/3/#'));
    await page.locator('tr[data-robot="guard-3"]').waitFor();
    await page.getByRole('button', { name: 'Arm', exact: true }).click();
    await eventually(async () => !(await isStopped(3)), 'run 3 goes on');
    await rsal.close(2);
    await rsal.beside({ configuration: 'three' });
    await rsal.close(3);
    await page.getByText('This run was closed.').waitFor();
    await page.keyboard.press('F8');
    await eventually(() => isStopped(4), 'run 4 stands');
  });

  longTest('are controlled by one person at a time, in all frames', async () => {
    await rsal.beside({ configuration: 'three' });
    const page = await open(rsal.url);
    await page.locator('tr[data-robot="guard-1"]').waitFor();
    await page.getByRole('button', { name: 'Take control', exact: true }).click();
    const form = page.getByRole('dialog', { name: 'Take control' });
    await form.getByLabel('Your name').fill('Ann');
    await form.getByRole('button', { name: 'Take control' }).click();
    await page.getByRole('button', { name: /^Give control back/ }).waitFor();
    await page.keyboard.press('b');
    await section(page, 2).waitFor();
    await page.getByRole('button', { name: /^Give control back/ }).waitFor(); // it went along

    const bob = await open(rsal.url.replace('/#', '/beside.html#'));
    await bob.getByRole('button', { name: 'Ann has control' }).waitFor();
    expect(await bob.getByRole('button', { name: 'Pause all' }).isDisabled()).toBe(true);
    expect(await bob.getByRole('button', { name: 'Emergency stop', exact: true }).isEnabled()).toBe(true);

    const frameAsks = '**/beside/2/api/control';
    await answerLate(page, frameAsks);
    await page.waitForRequest(frameAsks);
    await page.getByRole('button', { name: /^Give control back/ }).click();
    await eventually(
      () => bob.getByRole('button', { name: 'Pause all' }).isEnabled(),
      'others may act again',
    );
    await bob.waitForTimeout(5000); // in which each frame asks who has control
    expect(await bob.getByRole('button', { name: 'Pause all' }).isEnabled()).toBe(true);
    await page.unrouteAll({ behavior: 'ignoreErrors' });
  });

  longTest('are told together, and begin again with one seed', async () => {
    const page = await open(rsal.url, { colorScheme: 'dark' });
    await page.locator('tr[data-robot="guard-1"]').waitFor();
    await beside(page, { configuration: 'three' }, { configuration: 'rooms' });
    const bar = page.getByRole('group', { name: 'All runs' });
    await page.getByRole('button', { name: 'Add…', exact: true }).click();
    const form = page.getByRole('dialog', { name: 'Add a run' });
    await form.getByLabel('Copy the settings of').selectOption('2');
    await eventually(
      async () => (await form.getByLabel('Configuration').inputValue()) === 'three',
      'what that one has is offered',
    );
    await form.getByLabel('Seed').fill('x');
    await form.getByRole('button', { name: 'Start', exact: true }).click();
    await form.getByText(/whole number/).waitFor();
    await form.getByLabel('Seed').fill('8');
    await picture(page, 'beside-add');
    await expectAccessible(page);
    await form.getByRole('button', { name: 'Start', exact: true }).click();
    await frame(page, 4).locator('tr[data-robot="guard-3"]').waitFor();
    await picture(page, 'beside-dark-4');
    await eventually(
      () => page.getByRole('button', { name: 'Add…', exact: true }).isDisabled(),
      'there are no more than four',
    );

    await bar.getByRole('button', { name: 'Pause all' }).click();
    await bar.getByRole('button', { name: 'Resume all' }).waitFor();
    const times = () => Promise.all([1, 2, 3, 4].map((run) => time(page, run)));
    const before = await settled(times, 'time stands still in all');
    await bar.getByRole('button', { name: 'Step all' }).click();
    await eventually(
      async () => (await times()).every((now, i) => Math.abs(now - before[i]! - 0.1) < 0.01),
      'each has gone on for a step',
    );
    await bar.getByRole('button', { name: 'Resume all' }).click();
    await bar.getByLabel('Speed of all').selectOption('5');
    await eventually(
      async () =>
        (
          await Promise.all([1, 2, 3, 4].map((run) => frame(page, run).getByTestId('speed').innerText()))
        ).every((speed) => speed === '5×'),
      'all are faster',
    );
    await bar.getByLabel('Seed of all').fill('21');
    await bar.getByRole('button', { name: 'Restart all' }).click();
    await eventually(
      async () =>
        (await page
          .locator('.head')
          .getByText(/· seed 21/)
          .count()) === 4,
      'all begin again with that seed',
    );
  });

  longTest('have a page each, which says when its run was closed', async () => {
    await rsal.beside({ configuration: 'three' });
    const page = await open(rsal.url.replace('/#', '/beside/2/#'));
    await page.locator('tr[data-robot="guard-3"]').waitFor();
    await page.getByRole('button', { name: 'Pause', exact: true }).click();
    await eventually(async () => (await page.getByTestId('rate').innerText()) === 'paused', 'it is paused');
    await rsal.close(2);
    await page.getByText('This run was closed.').waitFor();
  });

  longTest('stand one below the other where there is little room', async () => {
    const page = await open(rsal.url, { viewport: { width: 480, height: 800 } });
    await page.locator('tr[data-robot="guard-1"]').waitFor();
    await beside(page, { configuration: 'three' });
    await frame(page, 2).locator('tr[data-robot="guard-3"]').waitFor();
    const [one, two] = [await section(page, 1).boundingBox(), await section(page, 2).boundingBox()];
    expect(two!.y).toBeGreaterThanOrEqual(one!.y + one!.height);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(480);
    await picture(page, 'beside-narrow');
  });

  longTest('can be looked at without the token, and are told nothing then', async () => {
    await rsal.beside({});
    const page = await open(`${rsal.origin}/beside.html`);
    await frame(page, 2).locator('tr[data-robot="guard-1"]').waitFor();
    for (const name of ['Pause all', 'Restart all', 'Add…', 'Emergency stop', 'Close run 2']) {
      expect(await page.getByRole('button', { name, exact: true }).isDisabled()).toBe(true);
    }
  });
});
