import { fileURLToPath } from 'node:url';
import { AxeBuilder } from '@axe-core/playwright';
import { chromium as driver, type Browser, type BrowserContext, type Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, describe, expect, it } from 'vitest';
import { chromium, flags } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';
import type { Links } from '../src/api/messages';

const RADIO = fileURLToPath(new URL('radio.yaml', import.meta.url));
const PICTURES = process.env.PICTURES;

describe.skipIf(!chromium)('who hears whom', () => {
  let rsal: Rsal;
  let browser: Browser | undefined;
  let context: BrowserContext | undefined;

  beforeAll(async () => {
    [rsal, browser] = await Promise.all([
      Rsal.run(RADIO, '--port', '0'),
      driver.launch({ executablePath: chromium!, args: flags }),
    ]);
  });

  afterAll(async () => {
    await browser?.close();
    await Rsal.endAll();
  });

  afterEach(() => context?.close());

  async function open(colorScheme: 'light' | 'dark'): Promise<Page> {
    context = await browser!.newContext({ viewport: { width: 1400, height: 900 }, colorScheme });
    const page = await context.newPage();
    await page.goto(rsal.url);
    await page.locator('tr[data-robot][data-x]').first().waitFor();
    return page;
  }

  const layer = (page: Page) => page.getByRole('button', { name: 'Links', exact: true });

  const told = async () => (await (await fetch(`${rsal.origin}/api/links`)).json()) as Links;

  async function picture(page: Page, name: string) {
    if (PICTURES) {
      await page.screenshot({ path: `${PICTURES}/${name}.png` });
    }
  }

  /** Of the canvas with the robots: pixels that have anything on them. */
  const drawn = (page: Page) =>
    page
      .locator('#map canvas')
      .nth(2)
      .evaluate((node) => {
        const { width, height } = node as HTMLCanvasElement;
        const { data } = (node as HTMLCanvasElement).getContext('2d')!.getImageData(0, 0, width, height);
        return data.filter((value, at) => at % 4 === 3 && value > 0).length;
      });

  it('is drawn, and asked for, only while the layer is on', async () => {
    const page = await open('light');
    const asked: string[] = [];
    page.on('request', (request) => asked.push(new URL(request.url()).pathname));
    await page.waitForTimeout(1000);
    const before = await drawn(page);
    expect(asked.filter((path) => path === '/api/links')).toEqual([]);
    await layer(page).click();
    await eventually(async () => (await drawn(page)) > before + 1000, 'lines are drawn');
    await page.waitForTimeout(1500);
    await picture(page, 'links-light');
    await page.getByRole('button', { name: /Look at an angle/ }).click();
    await eventually(async () => (await drawn(page)) > 1000, 'lines are drawn at an angle, too');
    await picture(page, 'links-oblique');
    await page.getByRole('button', { name: /Look at an angle/ }).click();
    await layer(page).click();
    await eventually(async () => (await drawn(page)) < before + 1000, 'lines are gone');
    const sofar = asked.length;
    await page.waitForTimeout(1500);
    expect(asked.slice(sofar).filter((path) => path === '/api/links')).toEqual([]);
  });

  it('is what the radio and faults allow, and what was said', async () => {
    await told(); // from now on it is noted
    await eventually(async () => {
      const { links, ofChosen } = await told();
      expect(ofChosen).toBe(false);
      const of = links.filter(({ one, other }) => one === 'scout-1' || other === 'scout-1');
      const heard = of.some(({ one, there, back }) => (one === 'scout-1' ? there : back));
      expect(heard).toBe(false);
      return links.some(({ saidThere, saidBack }) => saidThere || saidBack);
    }, 'somebody said something');
  });

  it('looks well in the dark, and is accessible', async () => {
    const page = await open('dark');
    await layer(page).click();
    await page.waitForTimeout(2500);
    await picture(page, 'links-dark');
    const { violations } = await new AxeBuilder({ page }).analyze();
    expect(violations.map(({ id, nodes }) => `${id}: ${nodes[0]?.html ?? ''}`)).toEqual([]);
  });
});
