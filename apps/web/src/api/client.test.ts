import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { api, RefusedError, seats } from './client';

/** What was asked, and never answered unless it is given up. */
const asked = new Map<string, AbortSignal>();

beforeEach(() => {
  asked.clear();
  vi.stubGlobal('location', { pathname: '/' });
  vi.stubGlobal('sessionStorage', { getItem: () => 'me', setItem: () => {}, removeItem: () => {} });
  vi.stubGlobal('fetch', (address: string, { signal }: { signal: AbortSignal }) => {
    asked.set(address, signal);
    return new Promise((_, reject) => {
      signal.addEventListener('abort', () => reject(signal.reason as Error));
    });
  });
});

afterEach(() => {
  vi.unstubAllGlobals();
});

it.each([
  ['/', '/api/run/estop'],
  ['/beside/2/', '/api/run/estop'],
  ['/beside.html', '/api/run/estop'],
  ['/lab/robots/', '/lab/robots/api/run/estop'],
  ['/lab/robots/beside/12/index.html', '/lab/robots/api/run/estop'],
])('stops all runs from the page at %s, behind a reverse proxy, too', (pathname, address) => {
  vi.stubGlobal('location', { pathname });
  void api.emergencyStop().catch(() => {});
  expect([...asked.keys()]).toEqual([address]);
});

const velocity = { vx: 1, vy: 0, omega: 0 };

it('gives up what hangs for an emergency stop, but for driving, which goes on when robots are armed', async () => {
  const place = api.tell('place', { robot: 'ann', x: 0, y: 0, heading: 0 });
  const look = api.readings('ann');
  void api.tell('drive', { robot: 'ann', driver: 'me', ...velocity });
  void api.emergencyStop();
  await expect(place).rejects.toThrow(RefusedError);
  await expect(place).rejects.toThrow('emergency stop was sent first');
  await expect(look).resolves.toBeNull();
  expect(asked.get('api/run/drive')!.aborted).toBe(false);
  expect(asked.get('/api/run/estop')!.aborted).toBe(false);
});

it('gives up an answer that has begun, too', async () => {
  vi.stubGlobal('fetch', (_: string, { signal }: { signal: AbortSignal }) =>
    Promise.resolve({
      ok: true,
      status: 200,
      json: () =>
        new Promise((_, reject) => {
          signal.addEventListener('abort', () => reject(signal.reason as Error));
        }),
    }),
  );
  const place = api.tell('place', { robot: 'ann', x: 0, y: 0, heading: 0 });
  await Promise.resolve(); // its head is there
  void api.emergencyStop();
  await expect(place).rejects.toThrow('emergency stop was sent first');
});

it('gives way to the emergency stop of another page, and has others give way to its own', async () => {
  const other = new BroadcastChannel('rsal');
  try {
    const place = api.tell('place', { robot: 'ann', x: 0, y: 0, heading: 0 });
    const look = api.readings('ann');
    void api.tell('drive', { robot: 'ann', driver: 'me', ...velocity });
    other.postMessage('emergency stop');
    await expect(place).rejects.toThrow('emergency stop was sent first');
    await expect(look).resolves.toBeNull();
    expect(asked.get('api/run/drive')!.aborted).toBe(false);
    expect(asked.has('/api/run/estop')).toBe(false); // the other has said that itself

    const told = new Promise((resolve) => {
      other.onmessage = (message: MessageEvent<unknown>) => {
        resolve(message.data);
      };
    });
    void api.emergencyStop();
    await expect(told).resolves.toBe('emergency stop');
  } finally {
    other.close();
  }
});

it('knows a look that was given up from a server that does not answer', async () => {
  const look = seats.all();
  void api.emergencyStop();
  await expect(look).resolves.toBeUndefined();
  vi.stubGlobal('fetch', () => Promise.reject(new Error('refused')));
  await expect(seats.all()).resolves.toBeNull();
});

it('looks and acts again after it', () => {
  void api.emergencyStop();
  void api.readings('bob');
  void api.tell('remove', { name: 'bob' }).catch(() => {});
  expect(asked.get('api/readings?robot=bob')!.aborted).toBe(false);
  expect(asked.get('api/run/remove')!.aborted).toBe(false);
});
