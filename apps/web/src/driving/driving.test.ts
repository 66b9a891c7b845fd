import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { api, RefusedError } from '../api/client';
import type { Abilities, Commands } from '../api/messages';
import { driving } from './driving.svelte';

vi.mock('../api/client', () => ({
  api: { tell: vi.fn() },
  RefusedError: class extends Error {},
}));

const can: Abilities = {
  forward: 1,
  backward: 0.4,
  sideways: 0,
  turn: 2,
  behaviors: [],
  noBehavior: '',
  noGoal: '',
};

describe('a robot that is driven', () => {
  const tell = vi.mocked(api.tell);

  beforeEach(async () => {
    vi.useFakeTimers();
    tell.mockReset().mockResolvedValue({});
    driving.share(50);
    driving.take('r1', can);
    await passes();
  });

  afterEach(async () => {
    await driving.letGo();
    vi.useRealTimers();
  });

  const passes = () => vi.advanceTimersByTimeAsync(200);

  const key = (code: string, more: Partial<KeyboardEvent> = {}) =>
    ({ code, shiftKey: false, repeat: false, ...more }) as KeyboardEvent;

  const last = () => tell.mock.lastCall![1] as Commands['drive']['takes'];

  async function refused() {
    tell.mockRejectedValueOnce(new RefusedError('No.', []));
    await passes();
    expect(driving.robot).toBeNull();
  }

  it('goes while a key is down', async () => {
    expect(last()).toMatchObject({ robot: 'r1', vx: 0 });
    driving.keyDown(key('KeyW'));
    await passes();
    expect(last()).toMatchObject({ robot: 'r1', vx: 0.5 });
    driving.keyUp(key('KeyW'));
    await passes();
    expect(last()).toMatchObject({ vx: 0 });
  });

  it('stands when it is taken again after a refusal, whatever was down then', async () => {
    driving.keyDown(key('KeyW', { shiftKey: true }));
    await refused();
    driving.keyUp(key('KeyW')); // which nobody hears
    driving.take('r1', can);
    await passes();
    expect(last()).toMatchObject({ vx: 0, omega: 0 });
    driving.keyDown(key('KeyW', { repeat: true })); // had it not been released
    await passes();
    expect(last()).toMatchObject({ vx: 0 });
    driving.share(60);
    driving.keyUp(key('KeyW'));
    driving.keyDown(key('KeyW'));
    await passes();
    expect(last()).toMatchObject({ vx: 0.6 });
  });

  it('stands when it is taken again, whatever a finger did to the pad after it was lost', async () => {
    driving.hold({ ahead: 1, aside: 0, turn: 0 });
    await refused();
    driving.hold({ ahead: 1, aside: 0, turn: 0.1 }); // the pad is not gone yet
    driving.take('r1', can);
    await passes();
    expect(last()).toMatchObject({ vx: 0, omega: 0 });
  });

  it('stands when the page takes another one with a key down', async () => {
    driving.keyDown(key('KeyW'));
    driving.take('r2', can);
    await passes();
    expect(last()).toMatchObject({ robot: 'r2', vx: 0 });
  });
});
