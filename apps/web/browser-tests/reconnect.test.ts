import { describe, expect, it } from 'vitest';
import { chromium } from './chromium';
import { eventually } from './eventually';
import { Rsal } from './rsal';
import { picture, visits } from './visits';

describe.skipIf(!chromium)('a page that comes back to another server at the same address', () => {
  const { open } = visits();

  it('may only watch, and says so at once', async () => {
    const first = await Rsal.run('teleop', '--port', '0');
    const page = await open(first.url, { mayFail: true });
    const stop = page.getByRole('button', { name: 'Emergency stop' });
    await stop.waitFor();
    expect(await stop.isEnabled()).toBe(true);
    expect(await page.getByText('View only').isVisible()).toBe(false);

    await first.end();
    await Rsal.run('teleop', '--port', first.port);

    await page.getByText('View only').waitFor();
    await eventually(async () => !(await stop.isEnabled()), 'the emergency stop is off');
    await picture(page, 'reconnect-view-only');
  });
});
