import { describe, expect, it } from 'vitest';
import type { CarriedInfo, GripperInfo, PieceInfo } from '../../api/messages';
import { carriedPieces, withPaddles } from './carried';

function piece(x: number, high: number): PieceInfo {
  return { color: null, corners: [[x, 0]], radius: 0.1, low: 0, high };
}

const body = [piece(0, 0.2), piece(1, 0.3)];
const turned: CarriedInfo = { devices: ['hand'], pieces: [0], x: 0, y: 1, heading: Math.PI / 2, rise: 0.5 };
const hand: GripperInfo = {
  name: 'hand',
  x: 0.3,
  y: 0,
  heading: 0,
  length: 0.2,
  width: 0.3,
  paddleLength: 0.1,
  paddleWidth: 0.05,
  low: 0,
  high: 0.1,
  lift: 0.1,
};

describe('what actuators carry', () => {
  it('is where they have carried it, the lowest first', () => {
    const [still, carried] = carriedPieces(body, [{ ...turned, x: 2, y: 0 }]);
    expect(still).toBe(body[1]);
    expect(carried).toMatchObject({ low: 0.5, high: 0.7 });
    expect(carried!.corners[0]![0]).toBeCloseTo(2);
    expect(carried!.corners[0]![1]).toBeCloseTo(0);
  });

  it('is the same object until it moves, and as it was sent while all are at home', () => {
    const carried = [turned];
    expect(carriedPieces(body, carried)).toBe(carriedPieces(body, carried));
    expect(carriedPieces(body, [])).toBe(body);
    expect(carriedPieces(body, undefined)).toBe(body);
  });

  it('leaves out pieces that were not sent', () => {
    expect(carriedPieces(body.slice(1), [{ ...turned, pieces: [7] }])).toEqual(body.slice(1));
  });
});

describe('the paddles of a gripper', () => {
  it('close and rise', () => {
    const [right, left] = withPaddles([], hand, { closed: 0.5, raised: 0.5, holding: false }, []).toSorted(
      (a, b) => a.corners[0]![1]! - b.corners[0]![1]!,
    );
    expect(left!.corners[0]![0]).toBeCloseTo(0.3);
    expect(left!.corners[0]![1]).toBeCloseTo(0.05);
    expect(right!.corners[0]![1]).toBeCloseTo(-0.1);
    expect(left!.low).toBeCloseTo(0.05);
    expect(left!.high).toBeCloseTo(0.15);
  });

  it('go with the actuator that they stand on', () => {
    const [paddle] = withPaddles([], hand, null, [turned]);
    expect(paddle!.corners[0]![1]).toBeCloseTo(1.3);
    expect(paddle!.low).toBeCloseTo(0.5);
  });
});
