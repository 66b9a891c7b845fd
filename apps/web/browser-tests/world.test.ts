import { fileURLToPath } from 'node:url';
import { AxeBuilder } from '@axe-core/playwright';
import { chromium as driver, type Browser, type Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, it } from 'vitest';
import { chromium, flags } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';

const HALL = fileURLToPath(new URL('driving.world', import.meta.url));
const PICTURES = process.env.PICTURES;

interface Place {
  x: number;
  y: number;
}

describe.skipIf(!chromium)('the view of the world', () => {
  let rsal: Rsal;
  let browser: Browser | undefined;
  let page: Page;
  let faults: string[] = [];

  beforeAll(async () => {
    [rsal, browser] = await Promise.all([
      Rsal.run(HALL, '--port', '0'),
      driver.launch({ executablePath: chromium!, args: flags }),
    ]);
  });

  afterAll(async () => {
    await browser?.close();
    await Rsal.endAll();
  });

  beforeEach(async () => {
    faults = [];
    await rsal.post('restart', {});
    page = await open(1280, 800);
  });

  afterEach(async () => {
    await page.context().close();
    expect(faults).toEqual([]);
  });

  async function open(width: number, height: number, colorScheme: 'light' | 'dark' = 'light'): Promise<Page> {
    const context = await browser!.newContext({ viewport: { width, height }, colorScheme });
    const opened = await context.newPage();
    opened.on('pageerror', (error) => faults.push(error.message));
    opened.on('console', (message) => {
      if (message.type() === 'error' && !message.text().includes('status of 409')) {
        faults.push(message.text());
      }
    });
    await opened.goto(rsal.url);
    await opened.locator('tr[data-robot][data-x]').first().waitFor();
    return opened;
  }

  async function picture(name: string) {
    if (PICTURES) {
      await page.screenshot({ path: `${PICTURES}/${name}.png` });
    }
  }

  const map = () => page.locator('#map');
  const numberOf = async (name: string) => Number(await map().getAttribute(`data-${name}`));

  /** Where a place is on the screen, some metres above the floor: by the numbers that the page tells of its view. */
  async function onScreen({ x, y }: Place, z = 0): Promise<Place> {
    const box = (await map().boundingBox())!;
    const [scale, originX, originY, turn, squeeze, rise] = (await Promise.all(
      ['scale', 'origin-x', 'origin-y', 'turn', 'squeeze', 'rise'].map(numberOf),
    )) as [number, number, number, number, number, number];
    const away = squeeze * (x * Math.sin(turn) + y * Math.cos(turn)) + rise * z;
    return {
      x: box.x + originX + scale * (x * Math.cos(turn) - y * Math.sin(turn)),
      y: box.y + originY - scale * away,
    };
  }

  async function pose(robot: string) {
    const row = page.locator(`tr[data-robot="${robot}"]`);
    const [x, y, heading] = await Promise.all(
      ['data-x', 'data-y', 'data-heading'].map(async (name) => Number(await row.getAttribute(name))),
    );
    return { x: x!, y: y!, heading: heading! };
  }

  async function isAt(robot: string, { x, y }: Place): Promise<boolean> {
    const now = await pose(robot);
    return Math.hypot(now.x - x, now.y - y) < 0.15;
  }

  async function drag(from: Place, to: Place, button: 'left' | 'right' = 'left') {
    const [start, end] = [await onScreen(from), await onScreen(to)];
    await page.mouse.move(start.x, start.y);
    await page.mouse.down({ button });
    await page.mouse.move((start.x + end.x) / 2, (start.y + end.y) / 2);
    await page.mouse.move(end.x, end.y);
    await page.mouse.up({ button });
  }

  /** Red, green and blue of what is drawn at a place. */
  async function colorAt(at: Place, z = 0): Promise<number[]> {
    const { x, y } = await onScreen(at, z);
    const bytes = await page.screenshot({
      clip: { x: Math.round(x) - 1, y: Math.round(y) - 1, width: 3, height: 3 },
    });
    return page.evaluate(
      async (data) => {
        const image = await createImageBitmap(new Blob([new Uint8Array(data)], { type: 'image/png' }));
        const context = new OffscreenCanvas(3, 3).getContext('2d')!;
        context.drawImage(image, 0, 0);
        return [...context.getImageData(1, 1, 1, 1).data].slice(0, 3);
      },
      [...bytes],
    );
  }

  const WHITE = [255, 255, 255];

  async function isAccessible() {
    const found = await new AxeBuilder({ page }).analyze();
    expect(found.violations.map(({ id, nodes }) => `${id}: ${nodes[0]?.html ?? ''}`)).toEqual([]);
  }

  it('is turned by keys and back, and all stays where it is drawn', async () => {
    await page.getByRole('button', { name: 'Grid' }).click();
    await page.getByRole('button', { name: 'Scans' }).click();
    const back = page.getByRole('button', { name: 'Turn back' });
    expect(await back.isDisabled()).toBe(true);
    for (let press = 0; press < 3; press++) {
      await page.keyboard.press('Shift+ArrowLeft');
    }
    expect(await numberOf('turn')).toBeCloseTo(Math.PI / 4);
    // the pillar in the middle, to its corners, and the floor beside it
    for (const place of [
      { x: 0.4, y: 0.4 },
      { x: -0.4, y: 0.4 },
      { x: 0.4, y: -0.4 },
    ]) {
      expect(await colorAt(place)).not.toEqual(WHITE);
    }
    expect(await colorAt({ x: 0.8, y: 0 })).toEqual(WHITE);
    await page.keyboard.press('0');
    await picture('turned');
    expect(await numberOf('turn')).toBeCloseTo(Math.PI / 4);
    await drag(await pose('idle'), { x: -3, y: 2 });
    await eventually(() => isAt('idle', { x: -3, y: 2 }), 'it is where it was dragged');
    const at = await onScreen(await pose('idle'));
    await page.mouse.click(at.x, at.y);
    await page.locator('tr.card').waitFor();
    await isAccessible();
    await back.click();
    expect(await numberOf('turn')).toBe(0);
  });

  it('is turned by dragging with Alt, around the robot that is followed, too', async () => {
    await page.locator('tr[data-robot="idle"]').click();
    await page.keyboard.press('f');
    const box = (await map().boundingBox())!;
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.keyboard.down('Alt');
    await page.mouse.move(x + 150, y);
    await page.mouse.down();
    await page.mouse.move(x + 140, y - 60);
    await page.mouse.move(x, y - 150);
    await page.mouse.up();
    await page.keyboard.up('Alt');
    expect(await numberOf('turn')).toBeCloseTo(Math.PI / 2);
    await eventually(async () => {
      const at = await onScreen(await pose('idle'));
      return Math.hypot(at.x - x, at.y - y) < 2;
    }, 'it is still in the middle');
    await page.keyboard.press('n');
    expect(await numberOf('turn')).toBe(0);
  });

  it('sends the selected robot by the right button, headed as it is dragged', async () => {
    const goal = page.locator('li', { hasText: 'operator' });
    const sent: unknown[] = [];
    page.on('request', (request) => {
      if (request.url().endsWith('/api/run/goal')) {
        sent.push(request.postDataJSON());
      }
    });
    await page.keyboard.press('Shift+ArrowLeft'); // on a turned map, as on any
    await page.locator('tr[data-robot="idle"]').click();
    const [start, end] = [await onScreen({ x: -3, y: -2 }), await onScreen({ x: -3, y: 1 })];
    await page.mouse.move(start.x, start.y);
    await page.mouse.down({ button: 'right' });
    await page.mouse.move(start.x, start.y - 20);
    await page.mouse.move(end.x, end.y);
    await page.getByText(/^-(3\.0|2\.9)\d, -(2\.0|1\.9)\d m, (89|90|91)°$/).waitFor();
    await picture('right-drag');
    await page.keyboard.press('Escape');
    await page.mouse.up({ button: 'right' });
    expect(sent).toEqual([]);
    expect(await page.getByRole('menu').count()).toBe(0);

    await drag({ x: -3, y: -2 }, { x: -3, y: 1 }, 'right');
    await eventually(() => Promise.resolve(sent.length === 1), 'it was sent');
    const told = sent[0] as { robot: string; x: number; y: number; heading: number };
    expect(told.robot).toBe('idle');
    expect(told.x).toBeCloseTo(-3, 1);
    expect(told.y).toBeCloseTo(-2, 1);
    expect(told.heading).toBeCloseTo(Math.PI / 2, 1);
    expect(await page.getByRole('menu').count()).toBe(0);
    await goal.first().waitFor();
    await eventually(async () => {
      const now = await pose('idle');
      return Math.hypot(now.x + 3, now.y + 2) < 0.5 && Math.abs(now.heading - Math.PI / 2) < 0.4;
    }, 'it has arrived, and looks where it was to look');

    const aside = await onScreen({ x: 3, y: -2 });
    await page.mouse.click(aside.x, aside.y, { button: 'right' }); // without a drag
    await page.getByRole('menuitem', { name: 'Add a box here' }).waitFor();
    await page.keyboard.press('Escape');
    expect(sent).toHaveLength(1);
  });

  it('says why the right button cannot send a robot', async () => {
    await page.locator('tr[data-robot="blind"]').click();
    await drag({ x: 3, y: -2 }, { x: 3, y: 0 }, 'right');
    await page.getByRole('alert').getByText(/./).first().waitFor();
    expect(await page.getByRole('menu').count()).toBe(0);
  });

  it('is looked at from an angle: heights are seen, and what is behind them shines through', async () => {
    for (const layer of ['Grid', 'Scans', 'Names', 'Trails']) {
      await page.getByRole('button', { name: layer }).click();
    }
    await rsal.post('pause');
    const button = page.getByRole('button', { name: 'Look at an angle' });
    const behind = { x: 0, y: 1 }; // the pillar, 1 m each way, hides it: its top is seen there
    expect(await colorAt(behind)).toEqual(WHITE);
    await page.keyboard.press('v');
    expect(await button.getAttribute('aria-pressed')).toBe('true');
    expect(await numberOf('squeeze')).toBeLessThan(0.9);
    const top = await colorAt({ x: 0, y: 0.3 }, 1);
    const side = await colorAt({ x: 0, y: -0.5 }, 0.5);
    expect(top).not.toEqual(WHITE);
    expect(await colorAt(behind)).toEqual(top);
    expect(side[0]!).toBeLessThan(top[0]! - 10); // in less light
    expect(await colorAt({ x: 0, y: 1.6 })).toEqual(WHITE);
    expect(await colorAt({ x: 0, y: -0.7 })).toEqual(WHITE); // nothing stands before it
    await picture('oblique');

    const before = { x: -0.7, y: 1.2 };
    await drag(await pose('blind'), before); // from its foot to a foot
    await eventually(() => isAt('blind', before), 'it is where it was dragged');
    await rsal.post('place', { robot: 'blind', x: 0, y: 0.85, heading: 0 });
    await eventually(() => isAt('blind', { x: 0, y: 0.85 }), 'it is behind the pillar');
    await eventually(async () => {
      const [red, green, blue] = await colorAt({ x: 0.2, y: 0.7 }, 0.1);
      return red! > green! + 15 && red! > blue! + 15 && red! < 230;
    }, 'it is red behind gray');
    const hidden = await onScreen({ x: 0, y: 0.85 }, 0.15);
    await page.mouse.click(hidden.x, hidden.y);
    await page.locator('tr.card', { hasText: 'Drive by keys' }).waitFor();
    await picture('hidden');
    await page.keyboard.press('Escape');

    await page.keyboard.press('Shift+ArrowLeft');
    await page.keyboard.press('Shift+ArrowLeft');
    await page.keyboard.press('0');
    await picture('oblique-turned');
    await page.keyboard.press('n');
    await isAccessible();
    await button.click();
    expect(await numberOf('rise')).toBe(0);
    await eventually(async () => (await colorAt({ x: 0, y: 1.6 })).join() === WHITE.join(), 'it is flat');
  });

  it('shows the frames of the selected robot, in any view', async () => {
    await rsal.post('pause');
    await page.locator('tr[data-robot="idle"]').click();
    const { x, y } = await pose('idle'); // it looks along the x axis of the map
    const axes = page.getByRole('button', { name: 'Frames' });
    expect(await axes.getAttribute('aria-pressed')).toBe('false');
    await axes.click();
    for (const key of ['Shift+ArrowLeft', 'v']) {
      await page.keyboard.press(key);
      for (const origin of [
        { x, y },
        { x: 0, y: 0 },
      ]) {
        await eventually(async () => {
          const along = await colorAt({ x: origin.x + 0.15, y: origin.y });
          const left = await colorAt({ x: origin.x, y: origin.y + 0.15 });
          return along[0]! > 1.2 * along[1]! && left[1]! > 1.2 * left[0]!;
        }, 'x is red, and y green');
      }
    }
    await picture('frames');
  });

  it('fits a narrow screen, at an angle and in the dark', async () => {
    await page.context().close();
    page = await open(480, 900, 'dark');
    await page.keyboard.press('v');
    await picture('narrow');
    for (const name of ['Look at an angle', 'Turn back', 'Show all']) {
      const box = (await page.getByRole('button', { name }).boundingBox())!;
      expect(box.x >= 0 && box.x + box.width <= 480, name).toBe(true);
    }
    expect((await map().boundingBox())!.height).toBeGreaterThan(120);
    await isAccessible();
  });
});
