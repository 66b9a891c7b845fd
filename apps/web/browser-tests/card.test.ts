import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { beforeAll, beforeEach, describe, expect, it } from 'vitest';
import { chromium } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';
import { visits } from './visits';

const WORLD = fileURLToPath(new URL('picker.world', import.meta.url));

describe.skipIf(!chromium)('the card of a robot', () => {
  const { open: visit } = visits();
  let rsal: Rsal;
  let page: Page;

  beforeAll(async () => {
    rsal = await Rsal.run(WORLD, '--port', '0');
  });

  beforeEach(async () => {
    await rsal.post('restart', {});
    page = await visit(rsal.url, { viewport: { width: 1400, height: 900 } });
  });

  async function open(robot: string) {
    await page.locator(`tr[data-robot="${robot}"][data-x]`).click();
    await page.getByText('Pose: send, place, copy, remove').click();
    await page.getByLabel('x [m]').waitFor();
  }

  const told = (device: string) => page.locator(`[data-reading="${device}"]`).innerText();
  const x = async () => Number(await page.getByLabel('x [m]').inputValue());
  const truth = async (robot: string) =>
    Number(await page.locator(`tr[data-robot="${robot}"]`).getAttribute('data-x'));

  it('shows what its devices see, feel and have, and goes on', async () => {
    await open('picker');
    await eventually(async () => /paddles\s+open/.test(await told('gripper')), 'the gripper tells');
    expect(await told('battery')).toMatch(/level\s+\d+\.\d %/);
    expect(await told('blob-finder')).toMatch(/1\.\d\d m, ahead/);
    expect(await told('fiducial-finder')).toMatch(/marker 7\s+\d\.\d\d m, ahead/);
    await rsal.post('remove', { name: 'can' });
    await eventually(async () => (await told('fiducial-finder')) === 'nothing', 'the marker is gone');
    await eventually(async () => (await told('blob-finder')) === 'nothing', 'the blob is gone');
  });

  it('can be seen with all of its buttons', async () => {
    await open('picker');
    const panel = (await page.getByRole('region', { name: 'Robots' }).boundingBox())!;
    const last = (await page.getByRole('button', { name: 'Remove', exact: true }).boundingBox())!;
    expect(last.y + last.height).toBeLessThan(panel.y + panel.height);
  });

  it('has the numbers of where it is until somebody types others', async () => {
    await open('roamer');
    const before = await truth('roamer');
    await eventually(async () => Math.abs((await truth('roamer')) - before) > 0.5, 'it moves');
    await eventually(async () => Math.abs((await x()) - (await truth('roamer'))) < 0.4, 'its numbers follow');
    await page.getByLabel('x [m]').fill('-1.5');
    await page.getByLabel('y [m]').fill('2');
    await page.getByLabel('y [m]').blur();
    const driven = await truth('roamer');
    await eventually(async () => Math.abs((await truth('roamer')) - driven) > 0.1, 'it goes on');
    expect(await x()).toBe(-1.5);
    await rsal.post('pause');
    await page.getByRole('button', { name: 'Place' }).click();
    await eventually(async () => (await truth('roamer')) === -1.5, 'it is there');
    await rsal.post('place', { robot: 'roamer', x: 2.5, y: 2, heading: 0 });
    await eventually(async () => (await x()) === 2.5, 'its numbers follow again');
  });
});
