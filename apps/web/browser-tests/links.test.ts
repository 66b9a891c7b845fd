import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { chromium } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';
import { expectAccessible, longTest, picture, visits } from './visits';
import { drawnOn } from './world';
import type { Links } from '../src/api/messages';

const RADIO = fileURLToPath(new URL('radio.yaml', import.meta.url));

describe.skipIf(!chromium)('who hears whom', () => {
  const { openRun } = visits();
  let rsal: Rsal;

  beforeAll(async () => {
    rsal = await Rsal.run(RADIO, '--port', '0');
  });

  const opened = (colorScheme: 'light' | 'dark') =>
    openRun(rsal.url, { viewport: { width: 1400, height: 900 }, colorScheme });

  const layer = (page: Page) => page.getByRole('button', { name: 'Links', exact: true });

  /** What the server knows; nothing while the run is too busy to answer. */
  const told = async () => {
    const response = await fetch(`${rsal.origin}/api/links`);
    return response.ok ? ((await response.json()) as Links) : null;
  };

  const drawn = (page: Page) => drawnOn(page, 'standing');

  /** How much is drawn once robots are. */
  async function somethingDrawn(page: Page) {
    await eventually(async () => (await drawn(page)) > 0, 'robots are drawn');
    return drawn(page);
  }

  longTest('is drawn, and asked for, only while the layer is on', async () => {
    const page = await opened('light');
    const asked: string[] = [];
    page.on('request', (request) => asked.push(new URL(request.url()).pathname));
    const before = await somethingDrawn(page);
    await page.waitForTimeout(1000);
    expect(asked.filter((path) => path === '/api/links')).toEqual([]);
    await layer(page).click();
    await eventually(async () => (await drawn(page)) > before + 1000, 'lines are drawn');
    await page.waitForTimeout(1500);
    await picture(page, 'links-light');
    await page.getByRole('button', { name: /Oblique view/ }).click();
    await eventually(async () => (await drawn(page)) > 1000, 'lines are drawn at an angle, too');
    await picture(page, 'links-oblique');
    await page.getByRole('button', { name: /Oblique view/ }).click();
    await layer(page).click();
    await eventually(async () => (await drawn(page)) < before + 1000, 'lines are gone');
    const sofar = asked.length;
    await page.waitForTimeout(1500);
    expect(asked.slice(sofar).filter((path) => path === '/api/links')).toEqual([]);
  });

  it('is what the radio and faults allow, and what was said', async () => {
    await told(); // from now on it is noted
    await eventually(async () => {
      const now = await told();
      if (now === null) {
        return false;
      }
      const { links, ofChosen } = now;
      expect(ofChosen).toBe(false);
      const of = links.filter(({ one, other }) => one === 'scout-1' || other === 'scout-1');
      const heard = of.some(({ one, there, back }) => (one === 'scout-1' ? there : back));
      expect(heard).toBe(false);
      return links.some(({ saidThere, saidBack }) => saidThere || saidBack);
    }, 'somebody said something');
  });

  longTest('is shown of what has been, too', async () => {
    const page = await opened('light');
    const without = await somethingDrawn(page);
    await layer(page).click();
    await eventually(async () => (await drawn(page)) > without + 1000, 'lines are drawn');
    await page.keyboard.press(',');
    await page.locator('[data-past=true]').waitFor();
    const then = await page.waitForResponse((response) => /api\/links.*time=/.test(response.url()));
    expect(((await then.json()) as Links).links.length).toBeGreaterThan(0);
    await eventually(async () => (await drawn(page)) > without + 1000, 'they were so then');
    await picture(page, 'links-past');
    await page.keyboard.press('l');
    await page.locator('[data-past=false]').waitFor();
  });

  longTest('looks well in the dark, and is accessible', async () => {
    const page = await opened('dark');
    await layer(page).click();
    await page.waitForTimeout(2500);
    await picture(page, 'links-dark');
    await expectAccessible(page);
  });
});
