import { fileURLToPath } from 'node:url';
import type { Locator, Page } from 'playwright-core';
import { beforeAll, beforeEach, describe, expect, it } from 'vitest';
import { chromium } from './chromium';
import { eventually, settled } from './eventually';
import { Rsal } from './rsal';
import { expectAccessible, longTest, looks, trials, visits } from './visits';
import { drag, onScreen, poseOf, timeOn } from './world';

const SEED = '42';

const SIZES = trials([
  [1280, 720],
  [820, 1180],
] as const);

describe.skipIf(!chromium)('the page', () => {
  const { open, openRun } = visits();
  let rsal: Rsal;
  let page: Page;

  beforeAll(async () => {
    rsal = await Rsal.run('hunt-and-prey', '--port', '0', '--seed', SEED);
  });

  beforeEach(async () => {
    await rsal.post('restart', { configuration: 'virtual', arguments: {}, seed: SEED });
    await rsal.post('speed', { factor: '1' });
    page = await opened(rsal.url);
  });

  const opened = (url: string, options = {}) =>
    openRun(url, { viewport: { width: 1280, height: 720 }, ...options });

  const time = (of = page) => timeOn(of);
  const pose = (robot: string) => poseOf(page, robot);

  async function pause() {
    await page.getByRole('button', { name: 'Pause' }).click();
    await page.getByRole('button', { name: 'Resume' }).waitFor();
    await stands();
  }

  /** What was sent before the pause has been drawn. */
  const stands = () => settled(() => time(), 'time stands still');

  const picture = () => page.locator('#map').screenshot();

  it('shows robots that move', async () => {
    const before = await pose('prey-1');
    const seen = await picture();
    await eventually(async () => {
      const now = await pose('prey-1');
      return Math.hypot(now.x - before.x, now.y - before.y) > 0.3;
    }, 'the prey has moved');
    expect((await picture()).equals(seen)).toBe(false);
    expect(await page.locator('tr[data-robot]').count()).toBe(3);
    expect(await page.getByText('following the wall').count()).toBeGreaterThan(0);
  });

  longTest('opens a single line to the run, while it is still being loaded', async () => {
    const lines: string[] = [];
    page.on('websocket', (line) => lines.push(line.url()));
    await page.route('**/assets/*.js', async (route) => {
      await eventually(() => Promise.resolve(lines.length > 0), 'a line is open before there is any code');
      await route.continue();
    });
    await page.reload();
    await eventually(async () => (await time()) > 0, 'the run is shown');
    expect(lines).toHaveLength(1);
  });

  it('pauses, steps and goes on', async () => {
    await pause();
    const [paused, seen, before] = [await time(), await picture(), await pose('prey-1')];
    await page.waitForTimeout(1000);
    expect(await time()).toBe(paused);
    expect(await pose('prey-1')).toEqual(before);
    expect((await picture()).equals(seen)).toBe(true);

    await page.getByRole('button', { name: 'Step' }).click();
    await eventually(async () => (await time()) > paused, 'a step was made');
    await stands();
    expect(await time()).toBeCloseTo(paused + 0.1);

    await page.keyboard.press('p');
    await eventually(async () => (await time()) > paused + 0.5, 'time goes on');
  });

  longTest('goes as fast as it is told', async () => {
    const rate = async () =>
      Number.parseFloat((await page.getByTestId('rate').innerText()).replace(/^\D*/, ''));
    const speed = page.getByTestId('speed');
    await page.getByRole('slider', { name: 'Speed' }).fill('6'); // 10×
    await eventually(async () => (await speed.innerText()) === '10×', 'the speed is 10×');
    await eventually(async () => (await rate()) > 2, 'it runs faster than real time');
    for (let press = 0; press < 5; press++) {
      await page.keyboard.press('-'); // none waits until the run has told the one before
    }
    await eventually(async () => (await speed.innerText()) === '0.2×', 'the speed is 0.2×');
    await eventually(async () => (await rate()) < 0.5, 'it runs slower than real time');
    await page.keyboard.press('+');
    await eventually(async () => (await speed.innerText()) === '0.5×', 'the speed is 0.5×');
  });

  it('puts a robot where it is dragged', async () => {
    await pause();
    const before = await pose('prey-1');
    const error = page.locator('tr[data-robot="prey-1"] td').nth(2);
    expect(await error.innerText()).toMatch(/m$/);
    const target = { x: 10, y: -1.6 };
    await drag(page, before, target);
    await eventually(async () => {
      const now = await pose('prey-1');
      return Math.hypot(now.x - target.x, now.y - target.y) < 0.2;
    }, 'the prey is there');
    expect(await error.innerText()).toBe('–'); // it has not looked around yet
    expect((await pose('prey-1')).heading).toBeCloseTo(before.heading, 1);
    await page.getByRole('searchbox', { name: 'Filter events' }).fill('operator prey-1');
    await page.locator('li', { hasText: 'operator' }).first().waitFor();
    // its localizer was told, too
    await page.keyboard.press('Escape');
    await page.locator('#map').focus();
    await page.keyboard.press('p');
    await eventually(async () => {
      return Number.parseFloat(await error.innerText()) < 0.5 && (await time()) > 1;
    }, 'the prey knows where it is');
  });

  longTest('says why a robot cannot be put into a wall, and leaves it where it is', async () => {
    await pause();
    const before = await pose('prey-1');
    await drag(page, before, { x: 0, y: 7.75 });
    const notice = page.getByRole('alert');
    await notice.getByText(/./).first().waitFor();
    expect(await pose('prey-1')).toEqual(before);
    const dismiss = notice.getByRole('button', { name: 'Dismiss' });
    const [line, ground] = await dismiss.evaluate((button) => [
      getComputedStyle(button).color,
      getComputedStyle(button).backgroundColor,
    ]);
    expect(ground).toBe('rgba(0, 0, 0, 0)');
    expect(line).not.toBe(await notice.locator('p').evaluate((p) => getComputedStyle(p).backgroundColor));
    await dismiss.click();
    expect(await notice.getByText(/./).count()).toBe(0);
  });

  it('sends a robot to a place, with keys and a click', async () => {
    const start = await pose('hunter-1');
    await page.keyboard.press('2');
    await page.keyboard.press('g');
    await page.getByText('Click on the goal of hunter-1').waitFor();
    const target = { x: start.x > 0 ? -25 : 25, y: -1.6 };
    const { x, y } = await onScreen(page, target);
    await page.mouse.click(x, y);
    await page.getByText('Click on the goal of hunter-1').waitFor({ state: 'hidden' });
    await page.getByRole('searchbox', { name: 'Filter events' }).fill('operator hunter-1');
    await page.locator('li', { hasText: 'operator' }).first().waitFor();
    await rsal.post('speed', { factor: '10' });
    await eventually(async () => {
      const now = await pose('hunter-1');
      return Math.hypot(now.x - start.x, now.y - start.y) > 1;
    }, 'the hunter is on its way');
  });

  longTest('says when a robot cannot get where it is sent', async () => {
    await rsal.post('goal', { robot: 'hunter-1', x: -31, y: -7.55, heading: 0 }); // in a corner
    await page.getByRole('alert').getByText("hunter-1 can't get to (-31.00, -7.55, 0°): no path.").waitFor();
    const late = await opened(rsal.url);
    await late.locator('li', { hasText: 'unreached' }).first().waitFor();
    expect(await late.getByRole('alert').getByText(/./).count()).toBe(0);
  });

  longTest.each(SIZES)('shows all digits of a place at %i × %i', async (width, height) => {
    page = await opened(rsal.url, { viewport: { width, height } });
    await page.keyboard.press('1');
    await page.getByText('Pose: send, place, copy, remove').click();
    for (const name of ['x [m]', 'y [m]', 'heading [°]']) {
      const field = page.getByLabel(name);
      await field.fill('-123.45');
      expect(await field.evaluate((input) => input.scrollWidth <= input.clientWidth), name).toBe(true);
    }
  });

  longTest('places a robot by typed numbers', async () => {
    await pause();
    await page.keyboard.press('1');
    await page.getByText('Pose: send, place, copy, remove').click();
    await page.getByLabel('x [m]').fill('5');
    await page.getByLabel('y [m]').fill('-1.6');
    await page.getByLabel('heading [°]').fill('90');
    await page.getByRole('button', { name: 'Place', exact: true }).click();
    await eventually(async () => {
      const now = await pose('prey-1');
      return Math.abs(now.x - 5) < 0.1 && Math.abs(now.heading - Math.PI / 2) < 0.1;
    }, 'the prey is there');
  });

  it('stops all robots in an emergency, until they are armed', async () => {
    await eventually(async () => (await time()) > 1, 'the run goes on');
    await page.getByRole('button', { name: 'Emergency stop' }).click();
    await page.getByText('Press Arm to switch them on').waitFor();
    await eventually(async () => {
      const speeds = await page.locator('tr[data-robot] td:nth-of-type(2)').allInnerTexts();
      return speeds.every((speed) => Math.abs(Number.parseFloat(speed)) < 0.01);
    }, 'all robots stand');
    const stopped = await pose('prey-1');
    await page.getByRole('button', { name: 'Arm', exact: true }).click();
    await page.getByText('Press Arm to switch them on').waitFor({ state: 'hidden' });
    await eventually(async () => {
      const now = await pose('prey-1');
      return Math.hypot(now.x - stopped.x, now.y - stopped.y) > 0.2;
    }, 'the prey moves again');
  });

  longTest('stays stopped when the emergency stop is clicked twice', async () => {
    const [stop, emergencyStop] = ['Stop', 'Emergency stop'].map((name) =>
      page.getByRole('button', { name, exact: true }),
    ) as [Locator, Locator];
    const places = async () => [await stop.boundingBox(), await emergencyStop.boundingBox()];
    const before = await places();
    await emergencyStop.dblclick();
    await page.getByText('Press Arm to switch them on').waitFor();
    await page.getByRole('searchbox', { name: 'Filter events' }).fill('operator');
    await eventually(
      async () => (await page.locator('li', { hasText: 'emergency stop' }).count()) === 2,
      'both clicks have arrived',
    );
    expect(await page.locator('li', { hasText: 'motors on' }).count()).toBe(0);
    expect(await page.getByText('Press Arm to switch them on').count()).toBe(1);
    expect(await page.getByTestId('outcome').count()).toBe(0);
    expect(await places()).toEqual(before);
  });

  it('stops in an emergency by a key, whatever has the focus', async () => {
    const stopped = page.getByText('Press Arm to switch them on');
    await page.getByRole('searchbox', { name: 'Filter events' }).focus();
    await page.keyboard.press('F8');
    await stopped.waitFor();
    await page.getByRole('button', { name: 'Arm', exact: true }).press('Enter');
    await stopped.waitFor({ state: 'hidden' });
    await page.keyboard.press('r');
    await page.getByRole('dialog', { name: 'Restart' }).getByLabel('Seed').focus();
    await page.keyboard.press('F8');
    await eventually(async () => (await stopped.count()) === 1, 'no robot moves until they are armed');
  });

  it('stops by Space whatever was clicked before, and shows it', async () => {
    const stopped = page.getByText('Press Arm to switch them on');
    const stops = async (why: string) => {
      await page.keyboard.press('Space');
      await eventually(async () => (await stopped.count()) === 1, why);
      await page.keyboard.press('Escape');
      await page.getByRole('button', { name: 'Arm', exact: true }).click();
      await stopped.waitFor({ state: 'hidden' });
    };
    await page.getByRole('button', { name: 'hunter-1' }).click();
    await stops('after a robot was chosen');
    expect(await page.getByRole('button', { name: 'hunter-1' }).getAttribute('aria-expanded')).toBe('false');
    for (const key of ['c', 'x', '?']) {
      await page.keyboard.press(key);
      await page.locator('dialog[open]').waitFor();
      await stops(`beside the dialog of ${key}`);
    }
    for (const name of ['Scenarios…', 'Restart…', 'Keys']) {
      await page.getByRole('button', { name, exact: true }).click();
      await page.locator('dialog[open]').waitFor();
      await page.keyboard.press('Escape');
      await page.locator('dialog[open]').waitFor({ state: 'detached' });
      await stops(`after ${name} was clicked and closed`);
    }
    await page.keyboard.press('1');
    await page.getByText('Plots', { exact: true }).click();
    await stops('after something was opened by a click');
    const short = page.getByRole('combobox', { name: 'Filter events' });
    await short.click();
    await short.selectOption('agent');
    await stops('after a choice from a list');
    await short.click();
    expect(await short.evaluate((list) => list === document.activeElement)).toBe(true); // or browsers close it
    await page.keyboard.press('Escape');
    await stops('after a list was looked at');
    await page.keyboard.press(',');
    await page.locator('.timeline[data-past="true"]').waitFor();
    await stops('while one looks back');
  });

  it('can be stopped by a click while a dialog covers the page', async () => {
    const stopped = page.getByText('Press Arm to switch them on');
    for (const key of ['r', 'c', 'x', '?']) {
      await page.keyboard.press(key);
      const dialog = page.locator('dialog[open]');
      const button = dialog.getByRole('button', { name: 'Emergency stop' });
      await button.waitFor();
      expect(await button.evaluate((b) => b === document.activeElement)).toBe(false);
      const [above, covered] = [(await button.boundingBox())!, (await dialog.boundingBox())!];
      expect(above.y + above.height).toBeLessThan(covered.y);
      await button.click();
      await eventually(async () => (await stopped.count()) === 1, `beside the dialog of ${key}`);
      await page.keyboard.press('Escape');
      await page.getByRole('button', { name: 'Arm', exact: true }).click();
      await stopped.waitFor({ state: 'hidden' });
    }
  });

  longTest('keeps what is selected when Esc empties and leaves a filter', async () => {
    await page.locator('tr[data-robot="prey-1"]').click();
    const card = page.getByText('Pose: send, place, copy, remove');
    await card.waitFor();
    const filter = page.getByPlaceholder('Filter');
    await filter.fill('hunter');
    await page.keyboard.press('Escape');
    expect(await filter.inputValue()).toBe('');
    await page.keyboard.press('Escape');
    expect(await filter.evaluate((field) => field === document.activeElement)).toBe(false);
    expect(await card.count()).toBe(1);
    await page.keyboard.press('Escape');
    await card.waitFor({ state: 'detached' });
  });

  longTest('makes an enlarged panel small again by Esc, however it was enlarged', async () => {
    const enlarge = page.getByRole('button', { name: 'Enlarge' }).first();
    await enlarge.click();
    await page.locator('.panel.large').waitFor();
    await page.keyboard.press('Escape');
    await page.locator('.panel.large').waitFor({ state: 'detached' });
    await enlarge.press('Enter');
    await page.locator('.panel.large').waitFor();
    await page.keyboard.press('Escape');
    await page.locator('.panel.large').waitFor({ state: 'detached' });
    await page.setViewportSize({ width: 1024, height: 768 });
    await enlarge.click();
    await page.getByRole('button', { name: 'Emergency stop' }).click(); // not covered
    await page.getByRole('button', { name: 'Arm', exact: true }).click();
  });

  longTest('keeps the emergency stop in sight where the page is higher than the window', async () => {
    await page.setViewportSize({ width: 800, height: 600 });
    await page.mouse.move(400, 400);
    await page.evaluate(() => document.scrollingElement!.scrollTo(0, 10_000));
    const stop = (await page.getByRole('button', { name: 'Emergency stop' }).boundingBox())!;
    expect(stop.y).toBeGreaterThanOrEqual(0);
    expect(stop.y + stop.height).toBeLessThan(600);
  });

  it('shows everything to a viewer that comes late and may only watch', async () => {
    await eventually(async () => (await time()) > 2, 'the run goes on');
    const late = await opened(rsal.origin);
    await late.getByText('View only').waitFor();
    expect(await late.locator('tr[data-robot]').count()).toBe(3);
    await late.getByText('3 robots, 3 agents').waitFor(); // the first events are there, too
    await eventually(async () => Math.abs((await time(late)) - (await time())) < 1, 'both see the same time');
    for (const name of ['Pause', 'Restart…', 'Stop', 'Emergency stop']) {
      expect(await late.getByRole('button', { name, exact: true }).isDisabled(), name).toBe(true);
    }
    await late.keyboard.press('p');
    await late.getByRole('alert').getByText('You can only watch.').waitFor();
    await late.keyboard.press('Space');
    await late.keyboard.press('r');
    expect(await late.getByRole('dialog').count()).toBe(0);
    const before = await time();
    await eventually(async () => (await time()) > before + 0.5, 'the run still goes on');
  });

  it('keeps the token out of sight, for this tab only', async () => {
    expect(page.url()).toBe(`${rsal.origin}/`);
    await page.reload();
    await page.locator('tr[data-robot][data-x]').first().waitFor();
    expect(await page.getByText('View only').count()).toBe(0);
    expect(await page.evaluate(() => localStorage.length + document.cookie.length)).toBe(0);
  });

  it('runs again with another seed, configuration and arguments', async () => {
    await page.getByRole('button', { name: 'Restart…' }).click();
    const dialog = page.getByRole('dialog');
    await dialog.getByLabel('Configuration').selectOption('advanced');
    await eventually(
      async () => (await dialog.getByLabel('hunters', { exact: true }).inputValue()) === '4',
      'there are 4 hunters',
    );
    await dialog.getByLabel('prey', { exact: true }).fill('2');
    await dialog.getByLabel('Seed').fill('4711');
    await dialog.getByLabel('Speed', { exact: true }).selectOption('2×');
    await dialog.getByRole('button', { name: 'Restart' }).click();
    await dialog.waitFor({ state: 'hidden' });
    await page.getByText('hunt-and-prey:advanced').waitFor();
    await eventually(async () => (await page.getByTestId('speed').innerText()) === '2×', 'the speed is 2×');
    await page.getByText('4711').first().waitFor();
    await eventually(
      async () => (await page.locator('tr[data-robot][data-x]').count()) === 6,
      'there are 6 robots',
    );
  });

  longTest('shows the next run from its beginning to who looks back on the last', async () => {
    await eventually(async () => (await time()) > 3, 'there is something to look back on');
    await page.keyboard.press(',');
    const past = page.locator('.timeline[data-past="true"]');
    await past.waitFor();
    for (const name of ['Restart…', 'Stop']) {
      const button = page.getByRole('button', { name, exact: true });
      expect(await button.isDisabled(), name).toBe(true);
      expect(await button.getAttribute('title'), name).toContain('Return to the present');
    }
    const before = await time();
    await rsal.post('restart', { configuration: 'virtual', arguments: {}, seed: '8' });
    await past.waitFor({ state: 'detached' });
    await eventually(
      async () => (await page.getByRole('banner').innerText()).includes('seed 8') && (await time()) < before,
      'the next run is shown',
    );
    const now = await time();
    await eventually(async () => (await time()) > now, 'and goes on');
  });

  longTest('offers the present speed for the next run, unless nobody could watch it', async () => {
    const offered = async () => {
      await page.keyboard.press('r');
      const dialog = page.getByRole('dialog');
      const speed = await dialog
        .getByLabel('Speed', { exact: true })
        .evaluate((select: HTMLSelectElement) => select.selectedOptions[0]!.text);
      await page.keyboard.press('Escape');
      return speed;
    };
    await rsal.post('pause');
    for (const [factor, told, offer] of [
      ['3', '3×', '3×'],
      ['max', 'max', '1×'],
    ] as const) {
      await rsal.post('speed', { factor });
      await eventually(
        async () => (await page.getByTestId('speed').innerText()) === told,
        `it goes at ${told}`,
      );
      expect(await offered()).toBe(offer);
    }
  });

  it('names every invalid field of the form at once, and restarts nothing', async () => {
    await page.keyboard.press('r');
    const dialog = page.getByRole('dialog');
    const field = (name: string) => dialog.getByLabel(name, { exact: true });
    await field('Seed').fill('seven');
    await field('prey').fill('99');
    await field('catchDistance[m]').fill('far');
    await dialog.getByRole('button', { name: 'Restart' }).click();
    await dialog.getByRole('alert').waitFor();
    for (const [name, error] of [
      ['Seed', "'seed' must be a whole number, not 'seven'."],
      ['prey', "'prey' must be a whole number from 1 to 20, not '99'."],
      ['catchDistance[m]', "'catchDistance' must be a number from 0.8 to 3 [m], not 'far'."],
    ] as const) {
      expect(await field(name).getAttribute('aria-invalid'), name).toBe('true');
      const descriptions = (await field(name).getAttribute('aria-describedby'))!.split(' ');
      const texts = await Promise.all(descriptions.map((id) => page.locator(`#${id}`).innerText()));
      expect(texts.join(' ')).toContain(error);
    }
    expect(await field('hunters').getAttribute('aria-invalid')).toBe('false');
    expect(await field('Seed').evaluate((input) => input === document.activeElement)).toBe(true);
    await page.keyboard.press('Escape');
    await page.locator('header').getByText(`seed ${SEED}`).waitFor();
    expect(await page.getByTestId('outcome').count()).toBe(0);
  });

  longTest.each(SIZES)('shows the whole ending beside the map at %i × %i', async (width, height) => {
    await rsal.post('restart', { configuration: 'advanced', arguments: {} });
    page = await opened(rsal.url, { viewport: { width, height } });
    await rsal.post('stop');
    await page.getByTestId('outcome').waitFor();
    const map = (await page.locator('#map').boundingBox())!;
    const ending = page.getByRole('region', { name: 'Stopped' });
    const box = (await ending.boundingBox())!;
    expect(box.x >= map.x + map.width || box.y >= map.y + map.height).toBe(true);
    expect(box.x + box.width).toBeLessThanOrEqual(width);
    const hidden = ending.getByRole('group', { name: 'Metrics' });
    expect(await hidden.evaluate((body) => body.scrollHeight - body.clientHeight)).toBeLessThanOrEqual(0);
    await ending.getByRole('button', { name: 'Close' }).click();
    await eventually(
      async () => (await page.locator('#map').boundingBox())!.width === width,
      'the map has the room again',
    );
  });

  longTest('explains what is out of bounds', async () => {
    const bounded = await Rsal.run(fileURLToPath(new URL('bounded.yaml', import.meta.url)), '--port', '0');
    page = await open(bounded.url, { mayFail: true });
    await page.getByText(/^Out of bounds: way is [\d.]+ m; the scenario allows at least 1000 m\.$/).waitFor();
    await bounded.end();
    await page.close();
  });

  longTest('begins the chart with what there is: in this hunt nobody has conversations', async () => {
    await page.getByText('hunter-1 goes for prey-1').first().waitFor();
    await page.getByRole('button', { name: 'Chart', exact: true }).click();
    await page.locator('.arrow.all', { hasText: 'hunter-1 goes for prey-1' }).first().waitFor();
    const topic = page.getByLabel('Topic', { exact: true });
    await page.locator('.arrow.all', { hasText: 'prey-1 is at' }).first().waitFor({ state: 'detached' });
    await topic.selectOption('pose'); // which is too much at first
    await page.locator('.arrow.all', { hasText: 'prey-1 is at' }).nth(3).waitFor();
    await topic.selectOption('all topics');
    await page.locator('.arrow.all', { hasText: 'hunter-1 goes for prey-1' }).first().waitFor();
  });

  it('says how a run ended', async () => {
    await page.getByRole('button', { name: 'Stop', exact: true }).click();
    expect(await page.getByTestId('outcome').innerText()).toBe('Stopped');
    expect(await page.getByTestId('rate').innerText()).toBe('ended');
    expect(await page.getByRole('button', { name: 'Pause' }).isDisabled()).toBe(true);
    await page.keyboard.press('Space'); // nothing moves: there is nothing to refuse
    await page.getByText('This run has ended.').waitFor();
    await page.getByRole('region', { name: 'Stopped' }).getByRole('button', { name: 'Restart' }).click();
    await page.getByRole('dialog').getByRole('button', { name: 'Restart' }).click();
    await page.getByTestId('outcome').waitFor({ state: 'hidden' });
    await eventually(async () => (await time()) > 0, 'the next run goes on');
  });

  longTest('tells what goes wrong', async () => {
    await rsal.post('restart', { configuration: 'faulty', arguments: {}, seed: SEED });
    await rsal.post('speed', { factor: '20' });
    await page.getByPlaceholder('Filter').fill('in the way');
    const fault = page.locator('li', { hasText: 'gone and in the way' });
    await fault.waitFor();
    expect(await fault.locator('.kind').innerText()).toBe('fault');
    const robot = (await fault.locator('.subject').innerText()).trim();
    await page.locator(`tr[data-robot="${robot}"]`).getByText('faulty').waitFor();
  });

  it('moves, zooms and follows by keyboard', async () => {
    const map = page.locator('#map');
    const scale = async () => Number(await map.getAttribute('data-scale'));
    const whole = await scale();
    const room = await map.boundingBox();
    await page.keyboard.press('i');
    expect(await scale()).toBeGreaterThan(whole);
    const left = Number(await map.getAttribute('data-origin-x'));
    await page.keyboard.press('ArrowLeft');
    expect(Number(await map.getAttribute('data-origin-x'))).toBeCloseTo(left + 60);
    await page.waitForTimeout(300); // for what would take room, or give it back
    expect(await map.boundingBox()).toEqual(room);
    await page.keyboard.press('1');
    await page.keyboard.press('f');
    const box = (await map.boundingBox())!;
    await eventually(async () => {
      const { x, y } = await onScreen(page, await pose('prey-1'));
      return Math.hypot(x - box.x - box.width / 2, y - box.y - box.height / 2) < 20;
    }, 'the prey is in the middle');
    await page.keyboard.press('0');
    expect(await scale()).toBeCloseTo(whole);
    await page.keyboard.press('?');
    await page.getByRole('dialog', { name: 'Keys' }).waitFor();
    await page.keyboard.press('Escape');
    expect(await page.getByRole('dialog').count()).toBe(0);
  });

  longTest('hides and shows layers', async () => {
    await pause();
    const all = await picture();
    const scans = page.getByRole('button', { name: 'Scans' });
    await scans.click();
    expect(await scans.getAttribute('aria-pressed')).toBe('false');
    await eventually(async () => !(await picture()).equals(all), 'scans are gone');
    await scans.click();
    await eventually(async () => (await picture()).equals(all), 'scans are back');
  });

  longTest.each(looks)(
    'breaks no rule of accessibility: %s at %i × %i',
    async (colorScheme, width, height) => {
      page = await opened(rsal.url, { colorScheme, viewport: { width, height } });
      const check = (what: string) => expectAccessible(page, undefined, what);
      await check('as it comes');
      await page.keyboard.press('1');
      await check('with a robot selected');
      await page.keyboard.press('?');
      await check('with the keys');
      await page.keyboard.press('Escape');
      await page.keyboard.press('r');
      await check('with the form to run again');
      await page.getByRole('dialog', { name: 'Restart' }).getByLabel('Seed').fill('seven');
      await page.getByRole('dialog').getByRole('button', { name: 'Restart' }).click();
      await page.getByRole('dialog').getByRole('alert').waitFor();
      await check('with errors in the form');
      await page.keyboard.press('Escape');
      await rsal.post('estop');
      await page.getByText('Press Arm to switch them on').waitFor();
      await check('after an emergency stop');
      await rsal.post('stop');
      await page.getByTestId('outcome').waitFor();
      await check('at the end');
    },
  );

  longTest('keeps what was selected when it loses its connection for a moment', async () => {
    let lose = () => {};
    page = await open('about:blank', { mayFail: true, viewport: { width: 1280, height: 720 } });
    await page.routeWebSocket(/\/api\/live/, (socket) => {
      const server = socket.connectToServer();
      lose = () => {
        void socket.close({ code: 1011 });
        void server.close();
      };
    });
    await page.goto(rsal.url);
    await page.locator('tr[data-robot="hunter-1"][data-x]').click();
    await page.getByText('Pose: send, place, copy, remove').waitFor();
    lose();
    await page.getByText('Connection lost.').waitFor();
    await page.getByText('Connection lost.').waitFor({ state: 'hidden' });
    const before = await time();
    await eventually(async () => (await time()) > before, 'it goes on');
    await page.getByText('Pose: send, place, copy, remove').waitFor();
    await rsal.post('restart', { configuration: 'virtual', arguments: {}, seed: SEED });
    await page.getByText('Pose: send, place, copy, remove').waitFor({ state: 'detached' }); // of another run
  });

  longTest('has notices that are put away over a dialog, too', async () => {
    const before = await pose('prey-1');
    await drag(page, before, { x: 0, y: 7.75 }); // a wall
    const notice = page.locator('.notices p').first();
    await notice.waitFor();
    await page.keyboard.press('r');
    await page.getByRole('dialog', { name: 'Restart' }).waitFor();
    await notice.getByRole('button').click();
    await notice.waitFor({ state: 'detached' });
    await rsal.post('pause');
    await page.keyboard.press('Escape');
    await page.getByRole('button', { name: 'Resume' }).waitFor();
    await drag(page, await pose('prey-1'), { x: 0, y: 7.75 });
    await notice.waitFor();
  });

  it('says when the server is gone, and comes back with it', async () => {
    const first = await Rsal.run('hunt-and-prey', '--port', '0');
    page = await open(first.origin, { mayFail: true });
    await page.locator('tr[data-robot][data-x]').first().waitFor();
    await first.end();
    await page.getByText('Connection lost.').waitFor();
    let maps = 0;
    page.on('request', (request) => {
      maps += request.url().includes('/api/map/1') ? 1 : 0;
    });
    await Rsal.run('find-and-collect', '--port', first.port, '--seed', '7');
    await page.getByText('Connection lost.').waitFor({ state: 'hidden' });
    await page.locator('header').getByText('seed 7').waitFor();
    await page.locator('tr[data-robot][data-x]').first().waitFor();
    await eventually(() => Promise.resolve(maps > 0), 'its map is asked for, though it counts its runs anew');
  });
});
