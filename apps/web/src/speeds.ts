/** Speeds that are offered: times real time, as the server takes them. */
export const speeds = ['0.1', '0.2', '0.5', '1', '2', '5', '10', '20', '50', '100', 'max'];

/** Where a speed is among those offered; the nearest below when it is between two. */
export function speedIndex(speed: number): number {
  const index = speeds.findLastIndex((offered) => valueOf(offered) <= speed);
  return Math.max(0, index);
}

export function nextSpeed(speed: number, direction: 1 | -1): string {
  const index = speedIndex(speed) + direction;
  return speeds[Math.min(speeds.length - 1, Math.max(0, index))]!;
}

/** The speeds that are offered and another one, slowest first. */
export function speedsWith(speed: string): string[] {
  return [...new Set([...speeds, speed])].sort((a, b) => valueOf(a) - valueOf(b));
}

/** What the server calls a speed. */
export function nameOf(speed: number): string {
  return speed === Infinity ? 'max' : String(Number(speed.toPrecision(6))); // frames have single precision
}

export function valueOf(speed: string): number {
  return speed === 'max' ? Infinity : Number(speed);
}
