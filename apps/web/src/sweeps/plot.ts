import type { Scale } from './scale';

/** How wide a plot in the table is, and how much of that is left free at its ends, for half a dot [px]. */
export const WIDTH = 100;
const EDGE = 5;

/** Where a value lies in it, from its left end [px]. */
export function placeOf(value: number, scale: Scale): number {
  return EDGE + scale.at(value) * (WIDTH - 2 * EDGE);
}
