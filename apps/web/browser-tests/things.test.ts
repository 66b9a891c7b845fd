import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { beforeAll, beforeEach, describe, expect, it } from 'vitest';
import { chromium } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';
import { expectAccessible, longTest, picture, visits } from './visits';
import { colorAt, drag, onScreen, type Place } from './world';

const YARD = fileURLToPath(new URL('yard.world', import.meta.url));

describe.skipIf(!chromium)('a world of things', () => {
  const { openRun } = visits();
  let rsal: Rsal;
  let page: Page;

  beforeAll(async () => {
    rsal = await Rsal.run(YARD, '--port', '0');
  });

  beforeEach(async () => {
    await rsal.post('restart', {});
    page = await openRun(rsal.url);
    await page.getByText('Things 4').click();
    await thing('puck').waitFor();
  });

  const thing = (name: string) => page.locator(`li[data-thing="${name}"]`);
  const robot = (id: string) => page.locator(`tr[data-robot="${id}"]`);

  const isSelected = (id: string) =>
    eventually(
      async () => (await robot(id).getByRole('button').getAttribute('aria-expanded')) === 'true',
      `${id} is selected`,
    );

  async function place(of: ReturnType<typeof thing>): Promise<Place> {
    const [x, y] = await Promise.all(
      ['data-x', 'data-y'].map(async (name) => Number(await of.getAttribute(name))),
    );
    return { x: x!, y: y! };
  }

  async function isNear(of: ReturnType<typeof thing>, { x, y }: Place) {
    const now = await place(of);
    return Math.hypot(now.x - x, now.y - y) < 0.15;
  }

  const ORANGE = [255, 165, 0];

  it('is drawn in its colors, where all really is', async () => {
    await page.getByRole('button', { name: 'Scans' }).click();
    await page.getByRole('button', { name: 'Grid' }).click();
    expect(await colorAt(page, { x: 2, y: 2 })).toEqual(ORANGE);
    expect(await colorAt(page, { x: 3, y: -2 })).toEqual([0, 255, 0]);
    expect(await colorAt(page, { x: 1, y: 2 })).toEqual([255, 255, 255]);
    const [red, green, blue] = await colorAt(page, { x: -3, y: 2 }); // seen through
    expect(green! < red! && green! < blue! && green! > 100).toBe(true);
    await rsal.post('place', { robot: 'crate', x: -1, y: 3, heading: 0 });
    await eventually(
      async () => (await colorAt(page, { x: -1, y: 3 })).toString() === ORANGE.toString(),
      'it is there',
    );
    expect(await colorAt(page, { x: 2, y: 2 })).toEqual([255, 255, 255]);
    const late = await openRun(rsal.origin);
    await late.getByText('Things 4').click();
    await late.locator('li[data-thing="crate"][data-x="-1"]').waitFor();
  });

  it('has things that are dragged and turned like robots', async () => {
    await drag(page, { x: 2, y: 2 }, { x: 0, y: 3 });
    await eventually(() => isNear(thing('crate'), { x: 0, y: 3 }), 'the crate is there');
    await page.getByRole('searchbox', { name: 'Filter events' }).fill('crate');
    await page.locator('li', { hasText: 'placed at' }).first().waitFor();
    const { x, y } = await onScreen(page, await place(thing('crate')));
    await page.mouse.click(x, y);
    await thing('crate').getByRole('button', { name: 'Remove' }).waitFor();
    const before = Number(await thing('crate').getAttribute('data-heading'));
    const map = page.locator('#map');
    const scale = Number(await map.getAttribute('data-scale'));
    const ahead = Math.hypot(0.4, 0.4) + 18 / scale;
    await drag(page, { x: ahead * Math.cos(before), y: 3 + ahead * Math.sin(before) }, { x: -2, y: 3 });
    await eventually(
      async () =>
        Math.abs(Math.abs(Number(await thing('crate').getAttribute('data-heading'))) - Math.PI) < 0.1,
      'it looks the other way',
    );
  });

  longTest('says why a thing has no room, and leaves it where it is', async () => {
    await drag(page, { x: 2, y: 2 }, { x: 5.9, y: 2 });
    const alert = page.getByRole('alert');
    await alert.getByText("'crate' does not fit").waitFor();
    const [told, tools] = [(await alert.boundingBox())!, (await page.locator('.map .bar').boundingBox())!];
    expect(told.y + told.height, 'it hides no tools of the map').toBeLessThanOrEqual(tools.y);
    await picture(page, 'notice');
    expect(await isNear(thing('crate'), { x: 2, y: 2 })).toBe(true);
  });

  it('lets things be placed and removed with keys alone', async () => {
    await thing('crate').getByRole('button').first().press('Enter');
    const card = thing('crate');
    await card.getByLabel('x [m]').fill('1');
    await card.getByLabel('y [m]').fill('-3');
    await card.getByLabel('y [m]').press('Enter');
    await eventually(() => isNear(card, { x: 1, y: -3 }), 'the crate is there');
    await card.getByRole('button', { name: 'Remove' }).press('Enter');
    await card.waitFor({ state: 'detached' });
    await page.getByText('Things 3').waitFor();
  });

  longTest('takes boxes and balls, by mouse and by keys', async () => {
    const { x, y } = await onScreen(page, { x: 4, y: 1 });
    await page.mouse.click(x, y, { button: 'right' });
    await page.getByRole('menuitem', { name: 'Add a box here' }).click();
    await thing('box-1').getByRole('button', { name: 'Remove' }).waitFor(); // it is selected
    expect(await isNear(thing('box-1'), { x: 4, y: 1 })).toBe(true);
    expect(await page.getByRole('menu').count()).toBe(0);
    await page.mouse.click(x, y, { button: 'right' });
    await page.getByRole('menuitem', { name: 'Add a ball here' }).click();
    await page.getByRole('alert').getByText("'box-1' is in the way").waitFor();
    await page.locator('#map').focus();
    await page.keyboard.press('m');
    await page.keyboard.press('ArrowDown');
    await page.keyboard.press('Enter');
    await thing('ball-1').waitFor();
    await page.keyboard.press('m');
    await page.getByRole('menuitem', { name: 'Remove ball-1' }).waitFor();
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('Enter');
    await thing('ball-1').waitFor({ state: 'detached' });
    await page.keyboard.press('m');
    await page.keyboard.press('Escape');
    expect(await page.getByRole('menu').count()).toBe(0);
  });

  it('takes more robots, and lets them go', async () => {
    await page.keyboard.press('1');
    const { x, y } = await onScreen(page, { x: 4, y: 3 });
    await page.mouse.click(x, y, { button: 'right' });
    await page.getByRole('menuitem', { name: 'Add a copy of a here' }).click();
    await robot('cart-1').waitFor();
    await isSelected('cart-1');
    await eventually(async () => !(await isNear(robot('cart-1'), { x: 4, y: 3 })), 'it wanders, too');
    const late = await openRun(rsal.origin);
    await late.locator('tr[data-robot="cart-1"]').waitFor();
    await robot('a').getByRole('button').press('Enter');
    await page.getByText('Pose: send, place, copy, remove').click();
    await page.getByRole('button', { name: 'Remove' }).click();
    await robot('a').waitFor({ state: 'detached' });
    expect(await page.locator('tr[data-robot]').count()).toBe(2);
    const before = await place(robot('cart-1'));
    await eventually(async () => !(await isNear(robot('cart-1'), before)), 'the other goes on');
    await page.keyboard.press('2'); // the second that is there
    await page.getByRole('button', { name: 'Copy', exact: true }).press('Enter');
    await page.getByRole('alert').getByText('is in the way').waitFor();
    const answer = await fetch(`${rsal.origin}/api/run`);
    expect(((await answer.json()) as { robots: unknown[] }).robots).toHaveLength(3);
  });

  longTest('takes robots of models, also where there is none', async () => {
    for (const id of ['a', 'b']) {
      await rsal.post('remove', { name: id });
      await robot(id).waitFor({ state: 'detached' });
    }
    await page.locator('#map').focus();
    await page.keyboard.press('m');
    await page.getByRole('menuitem', { name: 'Add a Pioneer 2-DX here' }).click();
    await robot('pioneer2dx-1').waitFor();
    await isSelected('pioneer2dx-1');
    await eventually(() => isNear(robot('pioneer2dx-1'), { x: 0, y: 0 }), 'it is in the middle');
  });

  longTest('may only be watched without the token', async () => {
    const late = await openRun(rsal.origin);
    expect(await late.getByRole('button', { name: 'Add…' }).isDisabled()).toBe(true);
    await late.locator('#map').click({ button: 'right' });
    await late.keyboard.press('m');
    expect(await late.getByRole('menu').count()).toBe(0);
    await late.getByText('Things 4').click();
    await late.locator('li[data-thing="crate"]').getByRole('button').first().click();
    expect(await late.getByRole('button', { name: 'Remove' }).isDisabled()).toBe(true);
  });

  longTest('breaks no rule of accessibility', async () => {
    await thing('crate').getByRole('button').first().click();
    const check = (what: string) => expectAccessible(page, undefined, what);
    await check('with a thing selected');
    await page.locator('#map').focus();
    await page.keyboard.press('m');
    await page.getByRole('menu').waitFor();
    await check('with the menu');
  });
});
