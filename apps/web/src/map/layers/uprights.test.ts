import { describe, expect, it } from 'vitest';
import type { MapInfo } from '../../api/messages';
import { View } from '../view';
import { sidesOf } from './relief';
import { Uprights, uprightsOf, wallsOf } from './uprights';

const F = 0;
const W = 100;
const C = 101;

function mapOf(width: number, height: number): MapInfo {
  return {
    name: 'm',
    width,
    height,
    resolution: 0.5,
    originX: -1,
    originY: 2,
    colors: ['#ff0000'],
    wallHeight: null,
  };
}

function box(x: number, y: number, width: number, depth: number, high: number, heading = 0) {
  const [w, d] = [width / 2, depth / 2];
  const corners = [
    [-w, -d],
    [w, -d],
    [w, d],
    [-w, d],
  ];
  const piece = { color: null, corners, radius: 0, low: 0, high };
  const pose = { x, y, heading };
  return uprightsOf({ pose, height: 0, pieces: [piece] });
}

describe('walls of a map', () => {
  it('are few rectangles, one for rows that are alike', () => {
    const cells = Uint8Array.of(
      ...[W, W, W, F],
      ...[W, W, W, F],
      ...[F, W, F, F], // another row, from the lower left cell up
    );
    const walls = wallsOf(mapOf(4, 3), cells);
    expect(walls.map(({ outline }) => [...outline])).toEqual([
      [-1, 2, 0.5, 2, 0.5, 3, -1, 3],
      [-0.5, 3, 0, 3, 0, 3.5, -0.5, 3.5],
    ]);
  });

  it('of another color are others, and cover each cell once', () => {
    const cells = Uint8Array.of(W, C, C, W, C, F);
    const walls = wallsOf(mapOf(3, 2), cells);
    expect(walls).toHaveLength(3);
    expect(walls.map(({ pieces }) => pieces[0]!.color).filter((color) => color === '#ff0000')).toHaveLength(
      2,
    );
  });

  it('have sides where they end, those in a row as one', () => {
    const cells = Uint8Array.of(W, W, W, F, F, W, F, F);
    const [south, east, north, west] = sidesOf(mapOf(4, 2), cells, 1);
    expect(south!.ends).toEqual([-1, 2, 0.5, 2]);
    expect(east!.ends).toEqual([0, 2.5, 0, 3, 0.5, 2, 0.5, 2.5]);
    expect(north!.ends).toEqual([-1, 2.5, -0.5, 2.5, 0, 2.5, 0.5, 2.5, -0.5, 3, 0, 3]);
    expect(west!.ends).toEqual([-1, 2, -1, 2.5, -0.5, 2.5, -0.5, 3]);
  });
});

describe('what stands', () => {
  const above = new View(20, 0, 0);
  const oblique = new View(20, 0, 0, { turn: 0, oblique: true });
  const fromTheEast = new View(20, 0, 0, { turn: -Math.PI / 2, oblique: true });
  const place = { x: 0, y: 0 };

  it('hides what is behind it, from where one looks', () => {
    const before = new Uprights(box(0, -0.5, 4, 0.2, 1));
    const beside = new Uprights(box(0.5, 0, 0.2, 4, 1));
    expect(before.before(place, 0.2, oblique.up)).toHaveLength(1);
    expect(beside.before(place, 0.2, oblique.up)).toHaveLength(0);
    expect(before.before(place, 0.2, fromTheEast.up)).toHaveLength(0);
    expect(beside.before(place, 0.2, fromTheEast.up)).toHaveLength(1);
    expect(before.before(place, 0.2, above.up)).toHaveLength(0);
  });

  it('hides nothing that is before it, nor what is too far behind for its height', () => {
    const behind = new Uprights(box(0, 0.5, 4, 0.2, 1));
    expect(behind.before(place, 0.2, oblique.up)).toHaveLength(0);
    expect(new Uprights(box(0, -1.5, 4, 0.2, 1)).before(place, 0.2, oblique.up)).toHaveLength(0);
    expect(new Uprights(box(0, -1.5, 4, 0.2, 3)).before(place, 0.2, oblique.up)).toHaveLength(1);
  });

  it('is looked at where it is, not where its middle is', () => {
    const slanting = new Uprights(box(3, 3, 20, 0.1, 1, Math.atan(1.2))); // through (-2, -3)
    expect(slanting.before({ x: -2, y: -3.5 }, 0.2, oblique.up)).toHaveLength(0);
    expect(slanting.before({ x: -2, y: -2.6 }, 0.2, oblique.up)).toHaveLength(1);
    expect(slanting.before({ x: -2, y: -1 }, 0.2, oblique.up)).toHaveLength(0);
  });

  it('comes the farthest first', () => {
    const all = new Uprights([
      ...box(0, -0.3, 1, 0.1, 1),
      ...box(0, -0.9, 1, 0.1, 1),
      ...box(0, -0.6, 1, 0.1, 1),
    ]);
    const hiding = all.before(place, 0.3, oblique.up);
    expect(hiding.map(({ pose }) => pose.y)).toEqual([-0.3, -0.6, -0.9]);
  });
});
