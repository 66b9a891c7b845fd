import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import type { Locator, Page } from 'playwright-core';
import { afterEach, describe, it } from 'vitest';
import type { StatusInfo } from '../src/api/messages';
import { chromium } from '../browser-tests/chromium';
import { eventually } from '../browser-tests/eventually';
import { Rsal } from '../browser-tests/rsal';
import { visits } from '../browser-tests/visits';

const root = new URL('../../../', import.meta.url);
const OUT = fileURLToPath(new URL('docs/images/', root));
const EXPLORE = fileURLToPath(new URL('docs/examples/explore.yaml', root));

/** Of a laptop's window, a bit sharper. */
const LAPTOP = { viewport: { width: 1280, height: 800 }, deviceScaleFactor: 1.5 };
/** A run is as fast as this machine can have it until shortly before the moment that is wanted. */
const SHORTLY = 4; // simulated seconds
const HURRY = '20';

/**
 * What the README and the documentation show of the page: each of the command that stands with it, so that whoever
 * follows sees the same. `npm run pictures`, or one of them: `npm run pictures -- -t rescue`.
 */
describe.skipIf(!chromium)('pictures of the documentation', () => {
  const { open, openRun, close } = visits();

  afterEach(async () => {
    await close();
    await Rsal.endAll();
  });

  async function status(rsal: Rsal): Promise<StatusInfo> {
    const answer = await fetch(`${rsal.origin}/api/status`);
    return (await answer.json()) as StatusInfo;
  }

  const reaches = (rsal: Rsal, time: number) =>
    eventually(async () => (await status(rsal)).time >= time, `it reaches ${time} s`, 500_000);

  /** Lets it go on until a moment of it, and pauses. */
  async function at(rsal: Rsal, time: number): Promise<void> {
    await rsal.post('speed', { factor: HURRY });
    await reaches(rsal, time - SHORTLY);
    await rsal.post('speed', { factor: '1' });
    await reaches(rsal, time);
    await rsal.post('pause');
  }

  const select = (page: Page, robot: string) => page.locator(`tr[data-robot="${robot}"]`).click();

  /** Whoever looks on moves nothing, and waits for what was asked. */
  async function take(page: Page, name: string, part?: Locator): Promise<void> {
    await page.mouse.move(0, 0);
    await page.waitForTimeout(1500);
    await (part ?? page).screenshot({ path: join(OUT, `${name}.png`) });
  }

  const map = (page: Page) => page.getByRole('region', { name: 'Map' });

  it('page: a hunt, with a hunter selected', async () => {
    const rsal = await Rsal.run('hunt-and-prey', '--seed', '7', '--port', '0');
    const page = await openRun(rsal.url, { ...LAPTOP, viewport: { width: 1280, height: 760 } });
    await at(rsal, 25);
    await select(page, 'hunter-1');
    await take(page, 'page');

    await page.keyboard.press('e');
    await take(page, 'onboard', map(page));
    await page.keyboard.press('e');

    await page.keyboard.press('Escape');
    await page.keyboard.press('c');
    await page.getByRole('dialog').locator('img').first().waitFor();
    await take(page, 'scenarios');
    await page.keyboard.press('Escape');

    await page.keyboard.press('v');
    for (let i = 0; i < 2; i++) {
      await page.keyboard.press('Shift+ArrowLeft');
    }
    await page.keyboard.press('0');
    for (let i = 0; i < 2; i++) {
      await page.keyboard.press('i');
    }
    await take(page, 'oblique', map(page));
  });

  it('beside: two hunts', async () => {
    const rsal = await Rsal.run('hunt-and-prey', '--port', '0');
    const page = await openRun(rsal.url, { ...LAPTOP, viewport: { width: 1440, height: 900 } });
    await rsal.post('pause'); // until the other one is there
    await rsal.beside({ configuration: 'advanced' });
    await page.keyboard.press('b');
    await page
      .locator('section[data-run="2"]')
      .frameLocator('iframe')
      .locator('tr[data-robot][data-x]')
      .first()
      .waitFor();
    await rsal.post('resume');
    await reaches(rsal, 14);
    await page.keyboard.press('p');
    await take(page, 'beside');
  });

  it.each([
    ['hunt', 14.3, ['hunt-and-prey:advanced', '--seed', '4']],
    ['find-and-collect', 140, ['find-and-collect:watched', '--seed', '1']],
    ['foraging', 95, ['foraging', '--seed', '1']],
    ['rescue', 190, ['rescue', '--seed', '1']],
    ['patrol', 625, ['patrol', '--seed', '1']],
    ['explore', 166, [EXPLORE, '--seed', '3']],
  ])('%s', async (name, time, command) => {
    const rsal = await Rsal.run(...command, '--port', '0');
    const page = await openRun(rsal.url, LAPTOP);
    await at(rsal, time);
    await take(page, name);
  });

  it('formation: a wedge', async () => {
    const rsal = await Rsal.run('swarm:formation', '--seed', '3', '--port', '0');
    const page = await openRun(rsal.url, LAPTOP);
    await at(rsal, 217);
    await page.getByRole('button', { name: 'Scans', exact: true }).click();
    await select(page, 'robot-1');
    await page.getByRole('button', { name: 'Follow', exact: true }).click();
    for (let i = 0; i < 7; i++) {
      await page.getByRole('button', { name: 'Zoom in' }).click();
    }
    await take(page, 'formation');
  });

  it('distribution: places that were found, at the end', async () => {
    const rsal = await Rsal.run('distribution:found', '--seed', '1', '--speed', HURRY, '--port', '0');
    const page = await openRun(rsal.url, { viewport: { width: 1580, height: 900 } });
    await eventually(async () => (await status(rsal)).outcome !== '', 'it ends', 500_000);
    await take(page, 'distribution', map(page));
  });

  it('teleop: robots that were sent somewhere', async () => {
    const rsal = await Rsal.run('teleop:three', '--port', '0');
    const page = await openRun(rsal.url, LAPTOP);
    await rsal.post('goal', { robot: 'robot-3', x: -3.4, y: 3.2, heading: 0 });
    await at(rsal, 25);
    await rsal.post('resume');
    await rsal.post('goal', { robot: 'robot-1', x: 17.4, y: 3.5, heading: Math.PI / 2 });
    await rsal.post('goal', { robot: 'robot-2', x: -21.4, y: 2, heading: 0 });
    await at(rsal, 45);
    await take(page, 'teleop', map(page));
  });

  /** Real robots, as far as ours can tell: another process serves them. */
  async function mixed(served: string[], run: string[], time: number): Promise<Page> {
    await Rsal.bridge('player', ...served, '--no-agents', '--page');
    const rsal = await Rsal.run(...run, '--port', '0');
    const page = await openRun(rsal.url, LAPTOP);
    await rsal.post('rearm');
    await reaches(rsal, time);
    return page;
  }

  it('mixed: a real prey, a real hunter and a simulated one', async () => {
    const page = await mixed(['hunt-and-prey', '--seed', '7'], ['hunt-and-prey:mixed', '--seed', '7'], 30);
    await take(page, 'mixed');
  });

  it('mixed-collect: a real collector has gripped a can', async () => {
    const page = await mixed(
      ['find-and-collect', '--seed', '2', '--set', 'collectors=1', '--set', 'cans=2'],
      ['find-and-collect:mixed', '--seed', '2'],
      20,
    );
    await eventually(
      async () => (await page.getByText(/takes \(can-\d\) along/).count()) > 0,
      'a can goes along',
      300_000,
    );
    await take(page, 'mixed-collect');
  });

  it('report: of a sweep', async () => {
    const folder = await mkdtemp(join(tmpdir(), 'rsal-pictures-'));
    try {
      const out = join(folder, 'hunt');
      const vary = ['--vary', 'hunters=1:3', '--vary', 'hunterSpeed=0.5,0.8'];
      await Rsal.headless('sweep', 'hunt-and-prey', ...vary, '--repeat', '20', '--out', out);
      await Rsal.headless('report', out);
      const page = await open(pathToFileURL(join(out, 'report.html')).href, {
        viewport: { width: 980, height: 1300 },
      });
      await take(page, 'report');
    } finally {
      await rm(folder, { recursive: true });
    }
  });
});
