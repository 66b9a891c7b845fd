import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { beforeAll, beforeEach, describe, expect, it } from 'vitest';
import { chromium } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';
import { longTest, picture, visits } from './visits';

const SCENARIO = fileURLToPath(new URL('faulty.yaml', import.meta.url));

describe.skipIf(!chromium)('a robot that is gone', () => {
  const { open } = visits({ refusals: false });
  let rsal: Rsal;
  let page: Page;
  /** How often was asked what a robot can do. */
  let asked: number;

  beforeAll(async () => {
    rsal = await Rsal.run(SCENARIO, '--port', '0');
  });

  beforeEach(async () => {
    await rsal.post('restart', {});
    asked = 0;
    page = await open(rsal.url, { viewport: { width: 1400, height: 900 } });
    page.on('request', (request) => {
      asked += request.url().includes('/api/abilities') ? 1 : 0;
    });
  });

  const row = (robot: string) => page.locator(`tr[data-robot="${robot}"]`);
  const says = (robot: string) => row(robot).locator('.behavior').innerText();
  const isGone = (robot: string) =>
    eventually(async () => (await says(robot)).startsWith('gone'), `${robot} is gone`);

  it('is said to be so, and asked no more what it can do', async () => {
    await rsal.post('speed', { factor: '4' });
    await isGone('stays');
    await row('stays').click();
    await page.locator('.card .gone').waitFor();
    expect(await page.getByRole('button', { name: 'Drive by keys' }).isDisabled()).toBe(true);
    expect(await page.getByRole('button', { name: 'Send…', exact: true }).isDisabled()).toBe(true);
    expect(await page.locator('[data-agent] .gone').innerText()).toBe('its robot is gone');
    await page.waitForTimeout(1500); // while the details go on changing
    expect(asked).toBe(0);
  });

  longTest('is said for how long it has been so, and when its agent was heard last', async () => {
    await isGone('stays');
    const age = async (text: Promise<string>) => Number(/(\d+) s/.exec(await text)?.[1] ?? NaN);
    const agent = page.locator('[data-agent] .age');
    await agent.waitFor();
    const [robot, before] = [await age(says('stays')), await age(agent.innerText())];
    expect(before).toBeGreaterThanOrEqual(5);
    await eventually(async () => (await age(says('stays'))) > robot + 1, 'it is gone for longer');
    await eventually(async () => (await age(agent.innerText())) > before, 'nothing is heard of its agent');
    await picture(page, 'gone-for');
    await eventually(async () => !(await says('vanishes')).includes('gone'), 'the other one is there again');
  });

  longTest('can be told something again once it is back', async () => {
    await isGone('vanishes');
    await row('vanishes').click();
    await page.locator('.card .gone').waitFor();
    await page.locator('.card .gone').waitFor({ state: 'detached' });
    const send = page.getByRole('button', { name: 'Send…', exact: true });
    await eventually(async () => !(await send.isDisabled()), 'it can be sent');
    const sofar = asked;
    expect(sofar).toBeGreaterThan(0);
    await page.waitForTimeout(1500); // while the details go on changing
    expect(asked).toBe(sofar);
  });
});
