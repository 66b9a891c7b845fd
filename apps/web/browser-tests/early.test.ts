import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect } from 'vitest';
import { decodeFrame } from '../src/live/frame';
import { chromium } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';
import { longTest, visits } from './visits';
import { timeOn } from './world';

const LATE_MILLIS = 3000;

describe.skipIf(!chromium)('a page whose code comes late', () => {
  const { open } = visits();
  const folder = mkdtempSync(join(tmpdir(), 'rsal-early-'));
  const file = join(folder, 'run.mcap');
  let running: Rsal;
  let recorded: Rsal;

  beforeAll(async () => {
    await Rsal.headless(
      ...['run', 'teleop', '--headless', '--speed', 'max', '--for', '60', '--record', file],
    );
    [running, recorded] = await Promise.all([
      Rsal.run('teleop', '--port', '0'),
      Rsal.replay(file, '--port', '0'),
    ]);
    await running.beside({ configuration: 'three' });
  }, 120_000);

  afterAll(async () => {
    await Rsal.endAll();
    rmSync(folder, { recursive: true });
  });

  /** Loads it anew, its code late; what lines it has opened, and the times of the frames that came by them [s]. */
  async function late(page: Page, url: string) {
    const lines: string[] = [];
    const times: number[] = [];
    page.on('websocket', (line) => {
      lines.push(line.url());
      line.on('framereceived', ({ payload }) => {
        if (typeof payload !== 'string') {
          times.push(decodeFrame(new Uint8Array(payload).buffer).time);
        }
      });
    });
    await page.route(/\/assets\/.*\.js$/, async (route) => {
      await new Promise((resolve) => setTimeout(resolve, LATE_MILLIS));
      await route.continue();
    });
    await page.goto('about:blank');
    await page.goto(url, { waitUntil: 'commit' });
    return { lines, times };
  }

  const isThere = (page: Page, robot: string) => page.locator(`tr[data-robot="${robot}"][data-x]`).waitFor();

  longTest('has the run by the line that was opened before, and no other', async () => {
    const page = await open(running.url);
    const { lines, times } = await late(page, running.url);
    await eventually(() => Promise.resolve(times.length > 0), 'a frame is there');
    expect(await page.locator('#map').count(), 'before the code').toBe(0);
    await isThere(page, 'robot-1');
    const before = await timeOn(page);
    await eventually(async () => (await timeOn(page)) > before, 'it goes on');
    expect(lines).toEqual([`${running.origin.replace('http', 'ws')}/api/live`]);
  });

  longTest('has one of the runs side by side, where that one is', async () => {
    const url = running.url.replace('/#', '/beside/2/#');
    const page = await open(url);
    const { lines } = await late(page, url);
    await isThere(page, 'robot-3');
    expect(lines).toEqual([`${running.origin.replace('http', 'ws')}/beside/2/api/live`]);
  });

  longTest('has a recording from its beginning', async () => {
    const page = await open(recorded.url);
    const { lines, times } = await late(page, recorded.url);
    await isThere(page, 'robot-1');
    expect(await timeOn(page)).toBeLessThan(LATE_MILLIS / 1000);
    expect(times[0]).toBeLessThan(0.5);
    const before = await timeOn(page);
    await eventually(async () => (await timeOn(page)) > before, 'it plays');
    expect(lines).toHaveLength(1);
  });

  longTest('tries again when the line was refused before the code was there', async () => {
    const page = await open(running.url);
    let asked = 0;
    await page.routeWebSocket(/\/api\/live$/, (line) => {
      asked++;
      if (asked === 1) {
        void line.close({ code: 1013 });
      } else {
        line.connectToServer();
      }
    });
    await late(page, running.url);
    await isThere(page, 'robot-1');
    expect(asked).toBe(2);
  });
});
