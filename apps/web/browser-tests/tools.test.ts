import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { chromium } from './chromium';
import { eventually, settled } from './eventually';
import { Rsal } from './rsal';
import { expectAccessible, longTest, picture, trials, visits } from './visits';

const TEAM = fileURLToPath(new URL('talk.yaml', import.meta.url));

describe.skipIf(!chromium)('what people work with', () => {
  const { openRun } = visits();
  let page: Page;

  beforeAll(async () => {
    const rsal = await Rsal.run(TEAM, '--port', '0');
    page = await openRun(rsal.url, { viewport: { width: 1400, height: 900 } });
  });

  const told = (text: string) =>
    eventually(
      async () => (await page.locator('.banner').innerText()).includes(text),
      `the banner says ${text}`,
    );

  it('a chart shows who said what to whom, one after the other, and one conversation alone', async () => {
    const panel = page.locator('.panel', { hasText: 'Events' });
    await panel.getByRole('button', { name: 'Chart' }).click();
    await panel.getByLabel('Topic', { exact: true }).selectOption({ label: 'conversations' });
    const arrows = panel.locator('.arrow');
    await arrows.nth(3).waitFor();
    const places = () =>
      page
        .locator('.panels .place')
        .evaluateAll((all) => all.map((one) => JSON.stringify(one.getBoundingClientRect())));
    const [panels, before] = [(await page.locator('.panels').boundingBox())!, await places()];
    await panel.getByRole('button', { name: 'Enlarge' }).click();
    const box = (await panel.boundingBox())!;
    expect(box.width).toBeGreaterThan(1200);
    expect((await page.locator('.panels').boundingBox())!, 'nothing moves below it').toEqual(panels);
    expect(await places()).toEqual(before);
    const timeline = (await page.getByRole('region', { name: 'Timeline' }).boundingBox())!;
    expect(box.y + box.height).toBeLessThan(timeline.y);
    expect(await page.getByRole('button', { name: 'Emergency stop' }).isVisible()).toBe(true);
    expect(await arrows.first().innerText()).toMatch(/^(cfp|request|inform|agree|query)/);
    await picture(page, 'chart');
    await expectAccessible(page);
    const all = await arrows.count();
    await arrows.first().click();
    await eventually(async () => (await arrows.count()) < all, 'other conversations are left out');
    await panel.getByRole('button', { name: '✕' }).click();
    await eventually(async () => (await arrows.count()) >= all, 'they are back');
    await panel.getByLabel('Protocol', { exact: true }).selectOption({ index: 1 });
    await eventually(async () => (await arrows.count()) > 0, 'there are some');
    expect(await panel.locator('.arrow[disabled]').count(), 'all of conversations').toBe(0);
    await picture(page, 'chart-protocol');
    await panel.getByLabel('Topic', { exact: true }).selectOption({ label: 'hello' });
    await panel.getByText('No such messages yet. Change the selection above.').waitFor();
    await panel.getByLabel('Protocol', { exact: true }).selectOption({ label: 'all protocols' });
    await arrows.first().waitFor();
    await panel.getByLabel('Topic', { exact: true }).selectOption({ label: 'all topics' });
    await eventually(
      async () => (await panel.locator('.arrow.all').count()) > 0,
      'what is for all is there, too',
    );
    await panel.getByLabel('Agent', { exact: true }).selectOption({ label: 'evade' });
    await eventually(async () => (await panel.locator('.agents .agent').count()) === 1, 'it speaks to all');
    const widths = await panel
      .locator('.agents')
      .evaluate((node) => [node.clientWidth, node.parentElement!.clientWidth]);
    expect(widths[0], 'the header is as wide as the chart').toBe(widths[1]);
    await panel.getByLabel('Agent', { exact: true }).selectOption({ label: 'all agents' });
    await panel.locator('[role=region] [tabindex="0"]').press('Escape');
    await eventually(async () => (await panel.boundingBox())!.width < 700, 'it is small again');
    await panel.getByRole('button', { name: 'Chart' }).click();
  });

  longTest('numbers of any device are plotted', async () => {
    await page.locator('tr[data-robot="courier-1"]').click();
    await page.getByText('Plots', { exact: true }).click();
    const numbers = page.getByLabel('Plot a number…');
    await eventually(
      async () => (await numbers.locator('option', { hasText: 'distance, least [m]' }).count()) > 0,
      'there are numbers of the laser',
    );
    await numbers.selectOption('courier-1: laser ranges.least');
    const plot = page.locator('[data-plot="courier-1: laser ranges.least"]');
    await eventually(
      async () => ((await plot.locator('.box path').getAttribute('d')) ?? '').includes('L'),
      'a line is drawn',
    );
    await page
      .getByLabel('Plot another number beside courier-1: laser distance, least')
      .selectOption('courier-1: base velocity.vx');
    await eventually(
      async () => ((await plot.locator('.box path').nth(1).getAttribute('d')) ?? '').includes('L'),
      'and another line',
    );
    await numbers.selectOption('courier-1: base velocity.omega');
    expect(await page.locator('[data-plot]').count()).toBe(2);
    await plot.scrollIntoViewIfNeeded();
    await picture(page, 'plots');
    await expectAccessible(page);

    const value = plot.locator('[data-value="courier-1: laser ranges.least"]');
    expect(await value.innerText()).toMatch(/^\d\.\d\d+ m$/);
    const turn = page.locator('[data-plot="courier-1: base velocity.omega"]');
    expect(await turn.locator('[data-value]').innerText()).toMatch(/ °\/s$/);
    await page.getByLabel('Plot another number beside courier-1: base turn').selectOption({ label: 'prey' });
    await turn.getByText('prey: base turn').waitFor();
    await eventually(
      async () => ((await turn.locator('.box path').nth(1).getAttribute('d')) ?? '').includes('L'),
      'a line of another robot is drawn',
    );
    await turn.locator('.box svg').hover({ position: { x: 100, y: 20 } });
    await turn.getByText(/^−\d+\.\d s$/).waitFor();
    await picture(page, 'plots-pointed');
    await page.mouse.move(400, 300);
    await turn.getByText('now').waitFor();
    const slider = turn.getByRole('slider');
    await slider.press('ArrowLeft');
    expect(await slider.getAttribute('aria-valuetext')).toMatch(
      /^(?:0\.[25]|1\.0) s before now: courier-1: base turn -?[\d.]+ °\/s, prey/,
    );
    await expectAccessible(page);
    await turn.getByRole('button', { name: 'Remove the plot of prey: base turn' }).click();
    await eventually(async () => (await turn.locator('.box path').count()) === 1, 'it is plotted no more');

    await plot.getByRole('button', { name: 'Remove the plot of courier-1: base speed ahead' }).click();
    expect(await plot.locator('.box path').count()).toBe(1);
    await plot.getByRole('button', { name: 'Remove the plot of courier-1: laser distance, least' }).click();
    expect(await plot.count()).toBe(0);
  });

  longTest('plots go on whichever robot is selected, and show what was when one looks back', async () => {
    await page.locator('tr[data-robot="courier-1"] button').click(); // until now it was selected
    expect(await page.locator('tr.card').count()).toBe(0);
    await page.locator('tr[data-robot="courier-2"]').click();
    const numbers = page.getByLabel('Plot a number…');
    await numbers.locator('option', { hasText: 'speed ahead' }).first().waitFor({ state: 'attached' });
    await numbers.selectOption('courier-2: base velocity.vx');
    const plot = page.locator('[data-plot="courier-2: base velocity.vx"]');
    await plot.getByText('−20 s').waitFor(); // it begins with what was before anybody asked
    await page.getByLabel('Plot another number beside courier-2: base speed ahead').selectOption('prey');
    const colors = () =>
      plot.locator('.box path').evaluateAll((all) => all.map((path) => path.getAttribute('stroke')));
    await eventually(async () => (await colors()).length === 2, 'there are two lines');
    const color = (robot: string) =>
      page
        .locator(`tr[data-robot="${robot}"] .color`)
        .evaluate((node) => (node as HTMLElement).style.backgroundColor);
    const asStyle = (colors: (string | null)[]) =>
      page.evaluate(
        (all) => all.map((one) => Object.assign(document.createElement('b').style, { color: one }).color),
        colors,
      );
    expect(await asStyle(await colors())).toEqual([await color('courier-2'), await color('prey')]);

    await page.locator('tr[data-robot="prey"]').click();
    await plot.getByText('courier-2: base speed ahead').waitFor();
    const path = () => plot.locator('.box path').first().getAttribute('d');
    const before = await path();
    await eventually(async () => (await path()) !== before, 'it grows');
    await page.locator('tr[data-robot="prey"] button').click();
    expect(await page.locator('tr.card').count()).toBe(0);
    await plot.getByText('now').waitFor();
    await picture(page, 'plots-none-selected');
    await expectAccessible(page);

    const cursor = page.getByRole('slider', { name: 'Time that is shown' });
    await cursor.fill('12');
    await page.mouse.move(400, 300); // where the pointer is in a plot, that has no ticks
    await plot.getByText(/^0:1[12]\.\d$/).waitFor();
    expect(await plot.getByText('now').count()).toBe(0);
    await plot
      .getByText(/^−(10|30|60) s$/)
      .first()
      .waitFor(); // whatever it has by now
    const then = await path();
    expect(then).toContain('L');
    await picture(page, 'plots-past');
    await page.getByRole('button', { name: 'Live' }).click();
    await plot.getByText('now').waitFor();
    await page.getByRole('button', { name: /^Remove the plot of prey: / }).click();
    await page.getByRole('button', { name: /^Remove the plot of courier-2: / }).click();
    expect(await plot.count()).toBe(0);
    await page.locator('tr[data-robot="courier-1"]').click();
  });

  it('distances are measured on the map', async () => {
    await page.keyboard.press('Escape');
    await page.keyboard.press('t');
    await page.getByText('Drag on the map to measure').waitFor();
    const map = (await page.locator('#map').boundingBox())!;
    await page.mouse.move(map.x + 200, map.y + 100);
    await page.mouse.down();
    await page.mouse.move(map.x + 500, map.y + 60, { steps: 3 });
    await page.mouse.up();
    await page.getByText('Drag on the map to measure').waitFor({ state: 'detached' });
    await picture(page, 'measure');
    await page.keyboard.press('t');
  });

  it('motors of one robot are switched off and on, and the space key stops all of them', async () => {
    await page.locator('tr[data-robot="courier-1"]').click();
    await page.getByRole('button', { name: 'Motors off', exact: true }).click();
    await told('Motors of courier-1 are off until they are switched on by its card.');
    expect(await page.locator('tr[data-robot]', { hasText: 'motors are off' }).count()).toBe(1);
    await page.keyboard.press(' ');
    await told('courier-1 was switched off separately, and stays off.');
    const hides = async () => {
      const [said, map] = [page.locator('.banner'), page.locator('#map')];
      const [{ y, height }, { y: top }] = [(await said.boundingBox())!, (await map.boundingBox())!];
      return y + height - top;
    };
    expect(await hides(), 'of the map it hides nothing').toBeLessThanOrEqual(0);
    await page.setViewportSize({ width: 1280, height: 800 });
    expect(await settled(hides, 'all has its place')).toBeLessThanOrEqual(0);
    await page.setViewportSize({ width: 820, height: 1180 });
    expect(await settled(hides, 'all has its place')).toBeLessThanOrEqual(0);
    await page.setViewportSize({ width: 1400, height: 900 });
    await picture(page, 'motors-switched-off');
    await expectAccessible(page);
    await page.getByRole('button', { name: 'Arm', exact: true }).click();
    await told('Motors of courier-1 are off until they are switched on by its card.');
    expect(await page.locator('tr[data-robot]', { hasText: 'motors are off' }).count()).toBe(1);
    expect(await page.getByRole('button', { name: /^Arm/ }).count(), 'it is armed alone').toBe(0);
    await page.getByRole('button', { name: 'Motors on', exact: true }).click(); // which leaves it without the focus
    await eventually(async () => !(await page.locator('.banner').innerText()).includes('off'), 'all are on');
    const map = await page.locator('#map').boundingBox();
    await page.keyboard.press(' ');
    await told('Press Arm to switch them on');
    expect(await page.locator('#map').boundingBox(), 'nothing moves under the pointer').toEqual(map);
    await page.getByRole('button', { name: 'Motors on', exact: true }).click();
    await told('Motors of courier-2, prey are off.');
    await picture(page, 'motors');
    await page.getByRole('button', { name: 'Arm all' }).click();
    await eventually(async () => !(await page.locator('.banner').innerText()).includes('off'), 'all are on');
  });

  it('the map has the room of all panels when somebody wants it', async () => {
    const before = (await page.locator('#map').boundingBox())!;
    await page.getByRole('button', { name: 'Hide the panels' }).click();
    const panels = page.locator('.panels');
    await eventually(async () => !(await panels.isVisible()), 'panels are hidden');
    const map = (await page.locator('#map').boundingBox())!;
    expect(map.width * map.height).toBeGreaterThan(1.3 * before.width * before.height);
    expect(await page.getByRole('slider', { name: 'Time' }).isVisible()).toBe(true);
    await picture(page, 'alone');
    await page.keyboard.press('Escape');
    await eventually(() => panels.isVisible(), 'they are back');
    await page.keyboard.press('h');
    await eventually(async () => !(await panels.isVisible()), 'hidden by a key');
    await page.keyboard.press('h');
    await eventually(() => panels.isVisible(), 'and back by it');
    expect(await page.locator('#map').boundingBox()).toEqual(before);
  });

  longTest('has one hint at a time on the map, which fits in there', async () => {
    await page.locator('tr[data-robot="courier-1"] button[aria-expanded="true"]').click();
    await page.setViewportSize({ width: 700, height: 700 });
    const layer = (name: string) => page.getByRole('button', { name, exact: true });
    await layer('Blobs').click();
    await layer('Costs').click();
    const hints = page.locator('.hints p');
    await eventually(async () => (await hints.count()) === 2, 'both layers want a robot');
    const shown = async () =>
      (await Promise.all((await hints.all()).map((hint) => hint.isVisible()))).filter(Boolean);
    expect(await shown()).toHaveLength(1);
    await picture(page, 'one-hint');
    await page.keyboard.press('t');
    const doing = page.getByText('Drag on the map to measure');
    await doing.waitFor();
    expect(await shown()).toHaveLength(0);
    const [map, box] = [(await page.locator('#map').boundingBox())!, (await doing.boundingBox())!];
    expect(box.x).toBeGreaterThanOrEqual(map.x);
    expect(box.x + box.width).toBeLessThanOrEqual(map.x + map.width);
    await page.keyboard.press('t');
    await layer('Blobs').click();
    await layer('Costs').click();
    await page.setViewportSize({ width: 1400, height: 900 });
  });

  longTest(
    'the border between the map and the panels is moved by a pointer and by keys, and stays there',
    async () => {
      const border = page.getByRole('separator', { name: 'Border between the map and the panels' });
      const height = async () => (await page.locator('.view').boundingBox())!.height;
      const before = await height();
      const { x, y } = (await border.boundingBox())!;
      await page.mouse.move(x + 300, y + 4);
      await page.mouse.down();
      await page.mouse.move(x + 300, y - 76, { steps: 3 });
      await page.mouse.up();
      await eventually(async () => Math.abs((await height()) - before + 80) < 3, 'the map is lower');
      await border.press('ArrowDown');
      await eventually(async () => Math.abs((await height()) - before + 56) < 3, 'a step higher');
      await picture(page, 'border');
      await expectAccessible(page);
      await page.reload();
      await page.locator('tr[data-robot][data-x]').first().waitFor();
      expect(Math.abs((await height()) - before + 56)).toBeLessThan(3);
      await border.press('Home');
      await eventually(async () => (await height()) === before, 'it is as it was');
    },
  );

  describe.each(
    trials([
      ['side by side', 1280, 800, 'Border between robots and agents', true, 'ArrowRight'],
      ['in a corner', 1024, 768, 'Border between robots and agents', true, 'ArrowRight'],
      ['in a corner', 820, 1180, 'Border between events and what is above them', false, 'ArrowDown'],
    ] as const),
  )('panels that lie %s at %i × %i', (_, width, height, name, upright, key) => {
    it('share their room as somebody wants it, by a pointer, a finger and keys', async () => {
      await page.setViewportSize({ width, height });
      const border = page.getByRole('separator', { name, exact: true });
      await border.scrollIntoViewIfNeeded();
      const panel = page.locator('.panels > .place').first();
      const size = async () => (await panel.boundingBox())![upright ? 'width' : 'height'];
      const becomes = (wanted: number, what: string) =>
        eventually(async () => Math.abs((await size()) - wanted) < 3, what);
      const before = await size();
      const value = async () => Number(await border.getAttribute('aria-valuenow'));
      await eventually(async () => (await value()) === Math.round(before), 'it tells where it is');
      const { x, y, width: w, height: h } = (await border.boundingBox())!;
      const middle = upright ? [x + w / 2, y + 30] : [x + 200, y + h / 2];
      const by = (pixels: number) =>
        upright ? ([middle[0]! + pixels, middle[1]!] as const) : ([middle[0]!, middle[1]! + pixels] as const);
      await page.mouse.move(...by(0));
      await page.mouse.down();
      await page.mouse.move(...by(-40), { steps: 3 });
      await page.mouse.up();
      await becomes(before - 40, 'smaller by what it was dragged');
      await border.press(key);
      await becomes(before - 16, 'larger by a step');
      await eventually(async () => (await value()) === Math.round(await size()), 'it tells where it is then');
      await picture(page, `panels-${String(width)}`);
      await expectAccessible(page);
      await page.reload();
      await page.locator('tr[data-robot][data-x]').first().waitFor();
      await becomes(before - 16, 'as it was left');
      await border.scrollIntoViewIfNeeded();
      const now = (await border.boundingBox())!;
      const touched = upright ? [now.x + w / 2, now.y + 30] : [now.x + 200, now.y + h / 2];
      await border.evaluate(
        (node, [fromX, fromY, toX, toY]) => {
          const touch = (type: string, clientX: number, clientY: number) =>
            node.dispatchEvent(
              new PointerEvent(type, { pointerType: 'touch', pointerId: 1, clientX, clientY, bubbles: true }),
            );
          node.setPointerCapture = () => {}; // no finger is there to be held
          touch('pointerdown', fromX!, fromY!);
          touch('pointermove', toX!, toY!);
          touch('pointerup', toX!, toY!);
          Reflect.deleteProperty(node, 'setPointerCapture'); // a pointer is held again
        },
        upright
          ? [touched[0]!, touched[1]!, touched[0]! + 30, touched[1]!]
          : [touched[0]!, touched[1]!, touched[0]!, touched[1]! + 30],
      );
      await becomes(before + 14, 'larger by what a finger dragged');
      await border.dblclick({ position: upright ? { x: w / 2, y: 30 } : { x: 200, y: h / 2 } });
      await becomes(before, 'as it was at first');
      await page.setViewportSize({ width: 1400, height: 900 });
    });
  });

  longTest('the list of robots is as wide as its panel, also while motors are off', async () => {
    await page.getByRole('button', { name: 'Emergency stop', exact: true }).first().click();
    await told('Press Arm to switch them on');
    await page.locator('tr[data-robot] .off').first().waitFor();
    for (const [width, height] of [
      [820, 1180],
      [1180, 820],
      [1024, 768],
    ] as const) {
      await page.setViewportSize({ width, height });
      const list = page.getByRole('region', { name: /^Robots/ });
      const wide = () => list.evaluate((node) => node.scrollWidth - node.clientWidth);
      await picture(page, `motors-off-${String(width)}`);
      expect(await settled(wide, 'the list has its width'), `${String(width)} px`).toBeLessThanOrEqual(0);
    }
    await page.setViewportSize({ width: 1400, height: 900 });
    await page.locator('.banner').getByRole('button').click();
    await page.locator('tr[data-robot] .off').first().waitFor({ state: 'detached' });
  });

  longTest('a plot of a run that is over ends there, and tells what was before', async () => {
    const plot = page.locator('[data-plot="courier-1: base odomFromBase.x"]');
    if ((await page.locator('tr.card').count()) === 0) {
      await page.locator('tr[data-robot="courier-1"]').click();
    }
    const plots = page.locator('.card details', { has: page.getByText('Plots', { exact: true }) });
    if ((await plots.getAttribute('open')) === null) {
      await plots.locator('summary').click(); // the page was loaded anew
    }
    const numbers = page.getByLabel('Plot a number…');
    await numbers.locator('option', { hasText: 'odometry x' }).first().waitFor({ state: 'attached' });
    expect(await numbers.locator('option', { hasText: /range|mounted|field of view/ }).count()).toBe(0);
    await numbers.selectOption('courier-1: base odomFromBase.x');
    await plot.getByText('now').waitFor();
    await page.getByRole('button', { name: 'Stop', exact: true }).click();
    await plot.getByText('end').waitFor();
    expect(await plot.getByText('now').count()).toBe(0);
    await page.getByRole('slider', { name: 'Time that is shown' }).fill('12');
    await plot.getByText(/^0:1[12]\.\d$/).waitFor();
    expect(await plot.locator('.box path').getAttribute('d')).toContain('L');
  });
});
