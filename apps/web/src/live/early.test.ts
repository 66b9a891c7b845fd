import { readFileSync } from 'node:fs';
import { runInThisContext } from 'node:vm';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { connect } from './connection';

const EARLY = readFileSync(new URL('../../public/early.js', import.meta.url), 'utf8');

class Socket {
  static readonly OPEN = 1;
  static opened: Socket[] = [];
  readonly readyState = Socket.OPEN;
  readonly sent: string[] = [];
  onmessage: (event: { data: unknown }) => void = () => {};
  onclose: (event: { code: number }) => void = () => {};

  constructor(readonly url: URL) {
    Socket.opened.push(this);
  }

  send(text: string) {
    this.sent.push(text);
  }
}

beforeEach(() => {
  vi.useFakeTimers();
  Socket.opened = [];
  vi.stubGlobal('WebSocket', Socket);
});

afterEach(() => {
  vi.unstubAllGlobals();
  vi.useRealTimers();
});

/** What public/early.js does at an address, before the code is there. */
function load(href = 'http://127.0.0.1:8735/#token=abc'): Socket {
  vi.stubGlobal('location', new URL(href));
  runInThisContext(EARLY);
  return Socket.opened[0]!;
}

/** The code is there; what it is told from now on. */
async function begin() {
  const told: unknown[] = [];
  connect({
    onFrame: () => told.push('frame'),
    onMessage: (message) => told.push(message),
    onGone: (closed) => told.push(closed ? 'closed' : 'gone'),
  });
  await vi.advanceTimersByTimeAsync(0);
  return told;
}

const event = (sequence: number) => ({ events: { run: 1, events: [{ sequence }] } });

describe('the line that is opened early', () => {
  it.each([
    ['http://127.0.0.1:8735/#token=abc', 'ws://127.0.0.1:8735/api/live'],
    ['http://127.0.0.1:8735/index.html?theme=a/b#token=abc', 'ws://127.0.0.1:8735/api/live'],
    ['http://127.0.0.1:8735/beside/2/#token=abc', 'ws://127.0.0.1:8735/beside/2/api/live'],
  ])('of %s is %s, and later ones are the same', async (href, line) => {
    const first = load(href);
    await begin();
    first.onclose({ code: 1006 });
    await vi.advanceTimersByTimeAsync(1000);
    expect(Socket.opened.map(({ url }) => String(url))).toEqual([line, line]);
  });

  it('waits at a server of another machine, which wants to see a token first', async () => {
    load('https://robots.example/beside/12/#token=abc');
    expect(Socket.opened).toEqual([]);
    await begin();
    expect(Socket.opened.map(({ url }) => String(url))).toEqual(['wss://robots.example/beside/12/api/live']);
  });

  it('is the one that the code goes on with, from what it has brought before', async () => {
    const line = load();
    line.onmessage({ data: JSON.stringify(event(1)) });
    line.onmessage({ data: JSON.stringify(event(2)) });
    expect(line.sent, 'nobody has taken it yet').toEqual([]);
    const told = await begin();
    line.onmessage({ data: JSON.stringify(event(3)) });
    expect(told).toEqual([event(1), event(2), event(3)]);
    expect(line.sent.map((text) => JSON.parse(text) as unknown)).toEqual(
      [1, 2, 3].map((events) => ({ events })),
    );
    expect(Socket.opened).toHaveLength(1);
  });

  it('may have been refused: then another is opened a little later', async () => {
    load().onclose({ code: 1013 });
    const told = await begin();
    expect(told).toEqual(['gone']);
    expect(Socket.opened).toHaveLength(1);
    await vi.advanceTimersByTimeAsync(1000);
    expect(Socket.opened).toHaveLength(2);
    Socket.opened[1]!.onmessage({ data: JSON.stringify(event(1)) });
    expect(told).toEqual(['gone', event(1)]);
  });

  it('of a run that was closed meanwhile is the last one', async () => {
    const line = load();
    line.onmessage({ data: JSON.stringify(event(1)) });
    line.onclose({ code: 4000 });
    expect(await begin()).toEqual([event(1), 'closed']);
    await vi.advanceTimersByTimeAsync(5000);
    expect(Socket.opened).toHaveLength(1);
  });
});
