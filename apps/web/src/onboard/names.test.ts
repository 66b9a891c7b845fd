import { describe, expect, it } from 'vitest';
import { placeNames, type Seen } from './names';

const seen = (name: string, px: number, depth: number, py = 50): Seen => ({ name, px, py, depth, width: 40 });
const names = (all: Seen[]) => placeNames(all, 300).map(({ name }) => name);

describe('names in the view on board', () => {
  it('are those of the nearest robots where there is no room for all', () => {
    expect(names([seen('far', 100, 5), seen('near', 130, 2), seen('aside', 180, 9)])).toEqual([
      'near',
      'aside',
    ]);
  });

  it('stand one above the other', () => {
    expect(names([seen('far', 100, 5, 30), seen('near', 100, 2)])).toEqual(['near', 'far']);
  });

  it('are moved into the picture', () => {
    expect(placeNames([seen('left', 3, 1), seen('right', 299, 1)], 300).map(({ px }) => px)).toEqual([
      20, 280,
    ]);
    expect(placeNames([seen('wider than the picture', 3, 1)], 30)[0]!.px).toBe(15);
  });
});
