import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { chromium } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';
import { expectAccessible, longTest, picture, visits } from './visits';

const TEAM = fileURLToPath(new URL('talk.yaml', import.meta.url));

describe.skipIf(!chromium)('what agents believe, want and talk about', () => {
  const { openRun } = visits();
  let rsal: Rsal;

  beforeAll(async () => {
    rsal = await Rsal.run(TEAM, '--port', '0');
  });

  const opened = (width: number, height: number, colorScheme: 'light' | 'dark') =>
    openRun(rsal.url, { viewport: { width, height }, colorScheme });

  const agent = (page: Page, name: string) => page.locator(`[data-agent="${name}"]`);
  const look = (page: Page, name: string) => agent(page, name).getByRole('button').first().click();

  const isAccessible = (page: Page) => expectAccessible(page, '.panels');

  it('is shown of the agent of the robot that is selected', async () => {
    const page = await opened(1400, 900, 'light');
    await page.locator('tr[data-robot="prey"]').first().click();
    const goals = agent(page, 'evade').getByRole('list', { name: 'Goals' });
    await goals.waitFor();
    expect(await goals.locator('[data-goal]').count()).toBeGreaterThan(1);
    await eventually(
      async () => (await goals.locator('[data-state="PURSUED"]').count()) === 1,
      'one goal is active',
    );
    expect(await goals.locator('[data-state="PURSUED"]').innerText()).toContain('active');
    expect(await page.locator('[data-agent]:has([data-goal])').count(), 'of one agent').toBe(1);
    const panel = (await page.getByRole('region', { name: 'Agents' }).boundingBox())!;
    const first = (await goals.locator('[data-goal]').first().boundingBox())!;
    expect(first.y + first.height).toBeLessThan(panel.y + panel.height);
    const beliefs = agent(page, 'evade').locator('dl').first();
    expect(await beliefs.locator('dt').count()).toBeGreaterThan(0);
    expect(await beliefs.innerText()).not.toMatch(/\d\.\d{4}/);
    await picture(page, 'mind-light');
    await isAccessible(page);
  });

  it('shows conversations, the newest first', async () => {
    const page = await opened(1400, 900, 'dark');
    await look(page, 'spread');
    const talks = agent(page, 'spread').getByRole('list', { name: 'Conversations' });
    await talks.getByText('request', { exact: true }).first().waitFor();
    expect(await talks.getByText(/→ nav-\d/).count()).toBeGreaterThan(0);
    expect(await talks.getByText(/go to/).count()).toBeGreaterThan(0);
    const seconds = (await talks.locator('.time').allInnerTexts()).map((text) =>
      text.split(':').reduce((sum, part) => 60 * sum + Number(part), 0),
    );
    expect(seconds).toEqual(seconds.toSorted((one, other) => other - one));
    await picture(page, 'talks-dark');
    await isAccessible(page);
    await look(page, 'spread');
    await eventually(async () => (await talks.count()) === 0, 'it is closed again');
  });

  longTest('has a mailbox of what reached it, the newest first', async () => {
    const page = await opened(1400, 900, 'light');
    await look(page, 'nav-1');
    const inside = agent(page, 'nav-1');
    await inside.getByText('Received messages').click();
    const mailbox = inside.getByRole('list', { name: 'Received messages' });
    await mailbox.getByText(/go to/).first().waitFor();
    expect(await mailbox.getByText('← spread').count()).toBeGreaterThan(0);
    expect(await mailbox.getByText('for all').count()).toBeGreaterThan(0);
    await mailbox.scrollIntoViewIfNeeded();
    await picture(page, 'mailbox-light');
    await isAccessible(page);
  });

  longTest('has a history of what it did, believed and wanted, step by step', async () => {
    const page = await opened(1400, 900, 'light');
    await look(page, 'evade');
    const inside = agent(page, 'evade');
    await inside.getByText('History, newest first').click();
    const history = inside.getByRole('list', { name: 'History, newest first' });
    await history.locator('[data-change="DOES"]').first().waitFor();
    await history.locator('[data-change="BELIEVES"]').first().waitFor();
    await history.scrollIntoViewIfNeeded();
    await picture(page, 'history-light');
    await isAccessible(page);
  });

  longTest('tells by topic what was said, heard and lost, and why', async () => {
    const page = await opened(1000, 900, 'light');
    await page.getByRole('button', { name: 'By topic' }).click();
    const pose = page.locator('[data-topic="pose"]');
    await pose.waitFor();
    await eventually(async () => (await pose.innerText()).includes('by chance'), 'some were lost');
    await picture(page, 'topics-narrow');
    await isAccessible(page);
    await page.getByRole('button', { name: 'By topic' }).click();
    await pose.waitFor({ state: 'detached' });
  });

  longTest('fits into a narrow window', async () => {
    const page = await opened(480, 900, 'dark');
    await page.locator('tr[data-robot="prey"]').first().click();
    await page.locator('[data-goal]').first().waitFor();
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    expect(wide).toBeLessThanOrEqual(480);
    await agent(page, 'evade').scrollIntoViewIfNeeded();
    await picture(page, 'mind-narrow-dark');
  });

  longTest('asks nothing of agents that nobody looks at', async () => {
    const page = await opened(1400, 900, 'light');
    const asked: string[] = [];
    page.on('request', (request) => asked.push(new URL(request.url()).pathname));
    await page.waitForTimeout(1500);
    expect(asked.filter((path) => path === '/api/agent' || path === '/api/topics')).toEqual([]);
    await look(page, 'spread');
    await eventually(async () => Promise.resolve(asked.includes('/api/agent')), 'it asks');
  });

  it('takes words from the operator, and says so in the events', async () => {
    const page = await opened(1400, 900, 'light');
    await look(page, 'evade');
    await agent(page, 'evade').getByRole('button', { name: 'Message…' }).click();
    const words = page.getByLabel('words', { exact: true });
    await page.getByRole('button', { name: 'Send message' }).click();
    expect(await words.evaluate((field) => field.matches(':invalid'))).toBe(true); // an empty text is none
    await page.getByLabel('Topic', { exact: true }).selectOption('pose');
    await page.getByLabel('mapFromBase').fill('1 2');
    const robot = page.getByLabel('robot', { exact: true });
    const names = page.locator(`datalist[id="${await robot.getAttribute('list')}"] option`);
    expect(await names.evaluateAll((all) => all.map((one) => one.getAttribute('value')))).toEqual(
      expect.arrayContaining(['courier-1', 'courier', 'spread']),
    );
    await robot.fill('courier-1');
    await page.getByLabel('role', { exact: true }).fill('courier');
    await page.getByRole('button', { name: 'Send message' }).click();
    await page.getByText("Field 'mapFromBase' takes x, y [m] and heading [°]").waitFor();
    await picture(page, 'say-light');
    await isAccessible(page);
    await page.getByLabel('mapFromBase').fill('1 2 90');
    await page.getByRole('button', { name: 'Send message' }).click();
    await page.getByText('is told on pose: courier-1 is at (1.00, 2.00, 90°)').first().waitFor();
  });

  it('are stopped, started again, and joined by others like them', async () => {
    const page = await opened(1400, 900, 'dark');
    await look(page, 'spread');
    const spread = agent(page, 'spread');
    await spread.getByRole('button', { name: 'Stop it' }).click();
    await spread.getByRole('button', { name: 'Start it again' }).click();
    await spread.getByRole('button', { name: 'Stop it' }).waitFor();
    await page.getByRole('searchbox', { name: 'Filter events' }).fill('started'); // others come all the time
    await page.getByText('started again').first().waitFor();
    await look(page, 'nav-1');
    await agent(page, 'nav-1').getByRole('button', { name: 'Start a copy' }).click();
    await agent(page, 'nav-1').getByLabel('For robot').selectOption('prey');
    await picture(page, 'another-dark');
    await isAccessible(page);
    await page.getByRole('button', { name: 'Start', exact: true }).click();
    await agent(page, 'nav-3').getByRole('button', { name: 'Stop it' }).click();
    await agent(page, 'nav-3').getByRole('button', { name: 'Start it again' }).waitFor();
    await page.getByText('started, like nav-1, for prey').first().waitFor();
  });

  longTest('are started of any type, as the form says', async () => {
    const page = await opened(1400, 900, 'light');
    await page.getByRole('button', { name: 'New…' }).click();
    const form = page.getByRole('dialog', { name: 'A new agent' });
    await form.getByLabel('Type').selectOption('wander');
    await form.getByLabel('For robot').selectOption('prey');
    await form.getByText(/^prey already has evade.* may send conflicting commands/).waitFor();
    await form.getByRole('textbox', { name: 'period' }).fill('often');
    await form.getByRole('button', { name: 'Start' }).click();
    await form.getByText("'period' must be").waitFor();
    await form.getByRole('textbox', { name: 'period' }).fill('7');
    await picture(page, 'new-agent');
    await isAccessible(page);
    await form.getByRole('button', { name: 'Start' }).click();
    const started = agent(page, 'wander-1');
    await started.waitFor();
    await started.getByText('Arguments (').click();
    expect(await started.locator('[data-argument="period"]').innerText()).toContain('7 s');
    await page.getByText('started, as wander, for prey').first().waitFor();
  });

  longTest('are left alone by who may only watch', async () => {
    const page = await openRun(rsal.origin);
    await look(page, 'evade');
    await agent(page, 'evade')
      .getByText(/^Arguments/)
      .waitFor();
    expect(await agent(page, 'evade').getByRole('button', { name: 'Stop it' }).count()).toBe(0);
  });

  longTest('shows the arguments of an agent, and which are not the default', async () => {
    const page = await opened(1400, 900, 'light');
    await look(page, 'evade');
    const inside = agent(page, 'evade');
    const hunter = inside.locator('[data-argument="hunter"]');
    await inside.getByText(/^Arguments \(\d+\)$/).waitFor();
    expect(await hunter.isVisible()).toBe(false); // closed until somebody wants to know
    await inside.getByText(/^Arguments/).click();
    expect(await hunter.innerText()).toMatch(/hunter\s+courier\s+default: nothing/);
    const distance = await inside.locator('[data-argument="fleeDistance"]').innerText();
    expect(distance).toMatch(/fleeDistance\s+6 m\s+It flees from hunters nearer than this\./);
    expect(distance).not.toContain('default');
    await page.waitForTimeout(1000); // it is asked for again meanwhile
    expect(await hunter.isVisible()).toBe(true);
    await inside.getByText(/^Arguments/).scrollIntoViewIfNeeded();
    await picture(page, 'arguments-light');
    await isAccessible(page);
  });

  longTest('stays known when the run is over, with what devices told last', async () => {
    await rsal.post('stop');
    const page = await opened(1400, 900, 'light');
    await page.getByTestId('outcome').waitFor();
    await page.locator('tr[data-robot="prey"]').first().click();
    await agent(page, 'evade').getByRole('list', { name: 'Goals' }).waitFor();
    await page.locator('[data-reading="laser"]').getByText('nearest').waitFor();
    await look(page, 'spread');
    await agent(page, 'spread').getByRole('list', { name: 'Conversations' }).locator('li').first().waitFor();
    await page.getByRole('button', { name: 'By topic' }).click();
    await page.locator('[data-topic="pose"]').waitFor();
    await picture(page, 'over');
  });
});
