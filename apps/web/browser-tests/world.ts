import type { FrameLocator, Page } from 'playwright-core';

/* What a page shows of its world, as numbers. */

export interface Place {
  x: number;
  y: number;
}

/** Simulated seconds on the page's clock. */
export async function timeOn(page: Page | FrameLocator): Promise<number> {
  const text = await page.getByTestId('time').innerText();
  return text.split(':').reduce((sum, part) => 60 * sum + Number(part), 0);
}

export async function poseOf(page: Page, robot: string) {
  const row = page.locator(`tr[data-robot="${robot}"]`);
  const [x, y, heading] = await Promise.all(
    ['data-x', 'data-y', 'data-heading'].map(async (name) => Number(await row.getAttribute(name))),
  );
  return { x: x!, y: y!, heading: heading! };
}

/** Where a place is on the screen, some metres above the floor: by the numbers that the page tells of its view. */
export async function onScreen(page: Page, { x, y }: Place, z = 0): Promise<Place> {
  const map = page.locator('#map');
  const box = (await map.boundingBox())!;
  const [scale, originX, originY, turn, squeeze, rise] = (await Promise.all(
    ['scale', 'origin-x', 'origin-y', 'turn', 'squeeze', 'rise'].map(async (name) =>
      Number(await map.getAttribute(`data-${name}`)),
    ),
  )) as [number, number, number, number, number, number];
  const away = squeeze * (x * Math.sin(turn) + y * Math.cos(turn)) + rise * z;
  return {
    x: box.x + originX + scale * (x * Math.cos(turn) - y * Math.sin(turn)),
    y: box.y + originY - scale * away,
  };
}

export async function drag(page: Page, from: Place, to: Place, button: 'left' | 'right' = 'left') {
  const [start, end] = [await onScreen(page, from), await onScreen(page, to)];
  await page.mouse.move(start.x, start.y);
  await page.mouse.down({ button });
  await page.mouse.move((start.x + end.x) / 2, (start.y + end.y) / 2);
  await page.mouse.move(end.x, end.y);
  await page.mouse.up({ button });
}

/** Red, green and blue of what is drawn at a place. */
export async function colorAt(page: Page, at: Place, z = 0): Promise<number[]> {
  const { x, y } = await onScreen(page, at, z);
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

/** How many pixels of a canvas of the map have something on them. */
export function drawnOn(page: Page, canvas: 'lying' | 'standing'): Promise<number> {
  return page
    .locator('#map canvas')
    .nth(canvas === 'lying' ? 1 : 2)
    .evaluate((node) => {
      const { width, height } = node as HTMLCanvasElement;
      const { data } = (node as HTMLCanvasElement).getContext('2d')!.getImageData(0, 0, width, height);
      return data.filter((value, at) => at % 4 === 3 && value > 0).length;
    });
}
