import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { RobotInfo } from '../../api/messages';
import type { Palette } from '../palette';
import { View } from '../view';
import { Sprites } from './sprites';

const palette = {} as Palette;
const robot = { footprint: [[1, 1]], pieces: [], color: '#123456' } as unknown as RobotInfo;

let open = 0;

/** Counts pictures that nobody has closed. */
class Canvas {
  getContext() {
    return { scale: () => {}, transform: () => {} };
  }

  transferToImageBitmap() {
    open++;
    return { close: () => open-- };
  }
}

describe('sprites', () => {
  beforeEach(() => {
    open = 0;
    vi.stubGlobal('OffscreenCanvas', Canvas);
  });

  afterEach(() => vi.unstubAllGlobals());

  const seen = (sprites: Sprites, scale: number, turn = 0, oblique = false) =>
    sprites.begin(new View(scale, 0, 0, { turn, oblique }), 1, palette);

  it('do not pay while each frame has another scale, or another turn', () => {
    const sprites = new Sprites();
    expect(seen(sprites, 20)).toBe(false);
    expect(seen(sprites, 21)).toBe(false);
    expect(seen(sprites, 21)).toBe(true);
    expect(seen(sprites, 21, 0.1)).toBe(false);
    expect(seen(sprites, 21, 0.1)).toBe(true);
    expect(seen(sprites, 21, 0.1, true)).toBe(false);
    expect(seen(sprites, 21, 0.1, true)).toBe(true);
  });

  it('are made once for each direction, and closed when they are of no more use', () => {
    const sprites = new Sprites();
    seen(sprites, 20);
    const draw = vi.fn();
    for (const heading of [0, 0.001, 2 * Math.PI, Math.PI]) {
      sprites.of(robot, heading, 10, draw);
    }
    expect(draw).toHaveBeenCalledTimes(2);
    expect(draw.mock.lastCall![2]).toMatchObject({ scale: 20, oblique: false });
    expect(open).toBe(2);
    seen(sprites, 20);
    expect(open).toBe(2);
    seen(sprites, 30, 0, true);
    expect(open).toBe(0);
    sprites.of(robot, 0, 10, draw);
    expect(draw.mock.lastCall![2]).toMatchObject({ scale: 30, oblique: true });
  });
});
