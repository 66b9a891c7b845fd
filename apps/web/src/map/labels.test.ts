import { describe, expect, it } from 'vitest';
import { overlap, placeLabels, type Named } from './labels';

const robot = (x: number, y: number): Named => ({ x, y, reach: 10, width: 60, height: 16 });

describe('names', () => {
  it('stand above their robots', () => {
    const [label] = placeLabels([robot(100, 100)]);
    expect(label).toEqual({ x: 70, y: 71, width: 60, height: 16 });
  });

  it.each([
    ['side by side', [robot(100, 100), robot(125, 100), robot(150, 100)]],
    ['one above the other', [robot(100, 100), robot(100, 125), robot(100, 150)]],
    ['in a heap', [robot(100, 100), robot(115, 105), robot(105, 118), robot(120, 122)]],
  ])('of robots %s hide neither each other nor a robot', (_, robots) => {
    const labels = placeLabels(robots);
    expect(labels).not.toContain(null);
    const boxes = labels.map((label) => label!);
    boxes.forEach((label, i) => {
      boxes.slice(i + 1).forEach((other) => {
        const frame = { x: other.x - 2, y: other.y - 2, width: other.width + 4, height: other.height + 4 };
        expect(overlap(label, frame)).toBe(0);
      });
      robots.forEach(({ x, y }) =>
        expect(overlap(label, { x: x - 10, y: y - 10, width: 20, height: 20 })).toBe(0),
      );
    });
  });

  it('of a crowd are seen only where they hide nothing', () => {
    const at = (i: number) => ((i * 7919) % 1000) / 1000; // as good as anywhere
    const robots = Array.from({ length: 300 }, (_, i) => robot(900 * at(i), 700 * at(31 * i + 7)));
    const labels = placeLabels(robots);
    const seen = labels.filter((label) => label !== null);
    expect(seen.length).toBeGreaterThan(20);
    expect(seen.length).toBeLessThan(300);
    const others = robots.map(({ x, y }) => ({ x: x - 10, y: y - 10, width: 20, height: 20 }));
    const hidden = seen.flatMap((label, i) =>
      [...seen.slice(i + 1), ...others].map((other) => overlap(label, other)),
    );
    expect(Math.max(...hidden)).toBe(0);
  });

  it('of who is selected is seen in any crowd', () => {
    const heap = Array.from({ length: 60 }, (_, i) => ({ ...robot(100, 100), first: i === 59 }));
    expect(placeLabels(heap)[59]).toEqual({ x: 70, y: 71, width: 60, height: 16 });
  });

  it('stay where they are when somebody far away moves', () => {
    const [before] = placeLabels([robot(100, 100), robot(500, 100)]);
    const [after] = placeLabels([robot(100, 100), robot(600, 300)]);
    expect(after).toEqual(before);
  });
});
