import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createServer, type AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { chromium } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';
import { picture, visits } from './visits';

const WATCHER = 'watcher-0123456789';
const OPERATOR = 'operator-0123456789';

function freePort(): Promise<number> {
  return new Promise((resolve) => {
    const server = createServer().listen(0, '127.0.0.1', () => {
      const { port } = server.address() as AddressInfo;
      server.close(() => resolve(port));
    });
  });
}

describe.skipIf(!chromium)('the page of another machine', () => {
  const { open } = visits();
  const folder = mkdtempSync(join(tmpdir(), 'rsal-listen-'));
  let address: string;

  beforeAll(async () => {
    await Rsal.headless('certificate', '127.0.0.1', '--out', folder);
    writeFileSync(join(folder, 'tokens'), `watch ${WATCHER}\noperate ${OPERATOR}\n`);
    const port = await freePort();
    const pem = (name: string) => join(folder, `${name}.pem`);
    await Rsal.run(
      'teleop',
      ...['--port', '0', '--listen', `127.0.0.1:${port}`, '--token-file', join(folder, 'tokens')],
      ...['--certificate', pem('certificate'), '--key', pem('key')],
    );
    address = `https://127.0.0.1:${port}/`;
  });

  afterAll(() => rmSync(folder, { recursive: true }));

  it('is live, and stops robots, with the token of an operator', async () => {
    const page = await open(`${address}#token=${OPERATOR}`, { ignoreHTTPSErrors: true });
    const stop = page.getByRole('button', { name: 'Emergency stop', exact: true });
    await eventually(() => stop.isEnabled(), 'the emergency stop can be used');
    await stop.click();
    await page.getByRole('button', { name: 'Arm' }).first().waitFor();
    expect(page.url()).toBe(address);
    await picture(page, 'listen-operator');
  });

  it('may only watch with the token of a watcher', async () => {
    const page = await open(`${address}#token=${WATCHER}`, { ignoreHTTPSErrors: true });
    await page.getByText('View only').waitFor();
    expect(await page.getByRole('button', { name: 'Emergency stop', exact: true }).isEnabled()).toBe(false);
  });

  it('asks for a token where there is none', async () => {
    const page = await open(address, { ignoreHTTPSErrors: true, mayFail: true });
    await page.getByText('This server needs a token.').waitFor();
    await picture(page, 'listen-refused');
    await page.getByLabel('Token').fill('wrong');
    await page.getByRole('button', { name: 'Open' }).click();
    await page.getByText('This server needs a token.').waitFor();
    await page.getByLabel('Token').fill(WATCHER);
    await page.keyboard.press('Enter');
    await page.getByText('View only').waitFor();
  });
});
