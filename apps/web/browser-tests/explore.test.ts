import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { beforeAll, describe, expect, it } from 'vitest';
import { chromium } from './chromium';
import { eventually, settled } from './eventually';
import { Rsal } from './rsal';
import { longTest, picture, visits } from './visits';
import { timeOn } from './world';

const SCENARIO = fileURLToPath(new URL('../../../docs/examples/explore.yaml', import.meta.url));

describe.skipIf(!chromium)('robots that explore', () => {
  const { open } = visits();
  let rsal: Rsal;

  beforeAll(async () => {
    rsal = await Rsal.run(SCENARIO, '--port', '0');
  });

  it('are seen to draw their map', async () => {
    const page = await open(rsal.url);
    const free: number[] = []; // cells, of one map after the other
    page.on('response', (response) => {
      if (response.url().includes('/api/drawn/')) {
        void response.body().then((body) => free.push(body.subarray(16).filter((cell) => cell === 0).length));
      }
    });

    await eventually(() => Promise.resolve(free.length > 2 && free.at(-1)! > free[0]!), 'the map grows');
    const chip = page.getByRole('button', { name: 'SLAM', exact: true });
    const floor = page.locator('canvas').first();
    await rsal.post('pause');
    const seen = async () => (await floor.screenshot()).toString('base64');
    const shown = await settled(seen, 'what was sent before the pause is drawn');
    await chip.click();
    await eventually(async () => shown !== (await seen()), 'the map is hidden');
    expect(await chip.getAttribute('aria-pressed')).toBe('false');

    await chip.click();
    await eventually(async () => shown === (await seen()), 'the map is there again');
    const known = free.at(-1)!;
    const before = free.length;
    await page.getByRole('slider', { name: 'Time that is shown' }).fill(String((await timeOn(page)) / 2));
    // one that was on its way before may still come
    await eventually(
      () => Promise.resolve(free.length > before && free.at(-1)! < known),
      'the map of then is asked for',
    );
    await eventually(async () => shown !== (await seen()), 'the map of then is shown');
    await picture(page, 'explore-back');
    await page.getByRole('button', { name: 'Live' }).click();
    await eventually(() => Promise.resolve(free.at(-1)! >= known), 'the newest map is there');

    await page.getByRole('button', { name: 'explorer-1' }).click();
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('link', { name: 'Save its map' }).click(),
    ]);
    expect(download.suggestedFilename()).toBe('explorer-1-map.zip');
    expect(
      readFileSync(await download.path())
        .subarray(0, 2)
        .toString(),
    ).toBe('PK');
  });

  longTest('are asked for ever more seldom where there is none', async () => {
    const page = await open('about:blank', { mayFail: true });
    const asked: number[] = []; // when
    await page.route(/\/api\/drawn\//, (route) => {
      asked.push(performance.now());
      return route.fulfill({ status: 409, body: '{}' });
    });
    await rsal.post('pause'); // so that none that is newer is told of
    await page.goto(rsal.url);
    await eventually(() => Promise.resolve(asked.length >= 4), 'it is asked for again and again');
    const pauses = asked.slice(1, 4).map((at, i) => at - asked[i]!);
    [1000, 2000, 4000].forEach((least, i) => expect(pauses[i]).toBeGreaterThan(least - 50)); // timers are not exact
  });
});
