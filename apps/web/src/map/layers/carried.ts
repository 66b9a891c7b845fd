import type { CarriedInfo, GripperInfo, PieceInfo } from '../../api/messages';
import type { Gripper } from '../../live/frame';

const PADDLES = '#5b6576';

const known = new WeakMap<readonly CarriedInfo[], { of: readonly PieceInfo[]; now: readonly PieceInfo[] }>();

/**
 * The pieces of a robot's body as they are now, the lowest first.
 *
 * @param pieces as they are while all actuators are at home
 * @param carried what actuators have carried elsewhere
 */
export function carriedPieces(
  pieces: readonly PieceInfo[],
  carried: readonly CarriedInfo[] | undefined,
): readonly PieceInfo[] {
  if (!carried?.some((load) => load.pieces.length > 0)) {
    return pieces;
  }
  const before = known.get(carried);
  if (before?.of === pieces) {
    return before.now;
  }
  const now = [...pieces];
  for (const load of carried) {
    for (const number of load.pieces) {
      const piece = pieces[number];
      if (piece) {
        now[number] = shifted(piece, load);
      }
    }
  }
  now.sort(byTop);
  known.set(carried, { of: pieces, now });
  return now;
}

/** The same with the paddles of its gripper, as far open and as high as they are. */
export function withPaddles(
  pieces: readonly PieceInfo[],
  info: GripperInfo | null,
  state: Gripper | null | undefined,
  carried: readonly CarriedInfo[] | undefined,
): readonly PieceInfo[] {
  return info === null ? pieces : [...pieces, ...paddles(info, state, carried)].sort(byTop);
}

function byTop(a: PieceInfo, b: PieceInfo): number {
  return a.high - b.high;
}

function paddles(
  { name, x, y, heading, length, width, paddleLength, paddleWidth, low, high, lift }: GripperInfo,
  state: Gripper | null | undefined,
  carried: readonly CarriedInfo[] | undefined,
): PieceInfo[] {
  const gap = (width / 2 - paddleWidth) * (1 - (state?.closed ?? 0));
  const rise = lift * (state?.raised ?? 0);
  const [from, to] = [length / 2 - paddleLength, length / 2];
  const mount: Move = { x, y, heading, rise };
  const load = carrierOf(name, carried);
  return [gap, -gap - paddleWidth].map((inside) => {
    const corners = [
      [from, inside],
      [to, inside],
      [to, inside + paddleWidth],
      [from, inside + paddleWidth],
    ];
    const paddle = shifted({ color: PADDLES, corners, radius: 0, low, high }, mount);
    return load ? shifted(paddle, load) : paddle;
  });
}

/** What has carried a device elsewhere. */
export function carrierOf(
  device: string,
  carried: readonly CarriedInfo[] | undefined,
): CarriedInfo | undefined {
  return carried?.find(({ devices }) => devices.includes(device));
}

type Move = Pick<CarriedInfo, 'x' | 'y' | 'heading' | 'rise'>;

function shifted(piece: PieceInfo, by: Move): PieceInfo {
  return {
    ...piece,
    corners: piece.corners.map((corner) => movedTo(corner, by)),
    low: piece.low + by.rise,
    high: piece.high + by.rise,
  };
}

/** Where a place of a robot is, in its base frame, that has been moved. */
export function movedTo([x, y]: readonly number[], by: Move): number[] {
  const [cos, sin] = [Math.cos(by.heading), Math.sin(by.heading)];
  return [by.x + cos * x! - sin * y!, by.y + sin * x! + cos * y!];
}
