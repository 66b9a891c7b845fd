import { describe, expect, it } from 'vitest';
import { decodeGrid } from './grid';

describe('maps that robots draw', () => {
  it('have their place before their cells', () => {
    const buffer = new ArrayBuffer(32 + 6);
    const view = new DataView(buffer);
    [3, 2].forEach((value, i) => view.setInt32(4 * i, value, true));
    [0.1, -1.5, 0.25].forEach((value, i) => view.setFloat64(8 + 8 * i, value, true));
    new Uint8Array(buffer).set([0, 100, 255, 0, 0, 0], 32);

    const { map, bytes } = decodeGrid(buffer, 'r1');

    expect(map).toEqual({
      name: 'r1',
      width: 3,
      height: 2,
      resolution: 0.1,
      originX: -1.5,
      originY: 0.25,
      colors: [],
      wallHeight: null,
    });
    expect([...bytes]).toEqual([0, 100, 255, 0, 0, 0]);
  });
});
