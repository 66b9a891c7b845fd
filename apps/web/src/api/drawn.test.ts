import { describe, expect, it } from 'vitest';
import { decodeDrawn } from './drawn';

describe('maps that robots draw', () => {
  it('have their place before their cells', () => {
    const buffer = new ArrayBuffer(16 + 6);
    const view = new DataView(buffer);
    [3, 2, -1500, 250].forEach((value, i) => view.setInt32(4 * i, value, true));
    new Uint8Array(buffer).set([0, 100, 255, 0, 0, 0], 16);

    const { map, bytes } = decodeDrawn(buffer, 'r1', 0.1);

    expect(map).toEqual({
      name: 'r1',
      width: 3,
      height: 2,
      resolution: 0.1,
      originX: -1.5,
      originY: 0.25,
      colors: [],
    });
    expect([...bytes]).toEqual([0, 100, 255, 0, 0, 0]);
  });
});
