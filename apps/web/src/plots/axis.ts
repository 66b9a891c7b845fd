import { numberText } from '../format';

/** What stands beside a box: round numbers, as many digits as tell them apart. */
export interface Axis {
  least: number;
  greatest: number;
  /** Growing. */
  ticks: readonly { value: number; text: string }[];
}

/** Into how many parts it is divided at most, but for what is added so that it ends at round numbers. */
const PARTS = 3;
/** Less of its size is not worth an axis: it is what is left of rounding. */
const NOTHING = 1e-7;

/** Less than that of a unit is what is left of reckoning: no device measures it, and nobody means it. */
const LEAST: Readonly<Record<string, number>> = {
  m: 1e-5,
  'm/s': 1e-5,
  '°': 1e-3,
  '°/s': 1e-3,
  J: 1e-3,
  W: 1e-3,
  V: 1e-5,
};
const LEAST_OF_ANY = 1e-12; // variances are small

/** A value as it is meant: nothing when it is less than anybody would measure. */
export const meant = (value: number, unit: string): number =>
  Math.abs(value) < (LEAST[unit] ?? LEAST_OF_ANY) ? 0 : value;

/** An axis that has room for some values: round numbers, of which it begins and ends at one. */
export function axisOf(least: number, greatest: number): Axis {
  const span = greatest - least;
  if (span <= NOTHING * Math.max(Math.abs(least), Math.abs(greatest))) {
    return { least, greatest: least, ticks: [{ value: least, text: numberText(least) }] };
  }
  const step = roundStep(span / PARTS);
  const first = Math.floor(least / step + 1e-9);
  const last = Math.ceil(greatest / step - 1e-9);
  const ticks = Array.from({ length: last - first + 1 }, (_, i) => {
    const value = (first + i) * step;
    return { value, text: fixed(value, step, Math.max(Math.abs(first), Math.abs(last)) * step) };
  });
  return { least: Math.min(least, first * step), greatest: Math.max(greatest, last * step), ticks };
}

/** The least of 1, 2, 5, 10, … that is no less. */
function roundStep(least: number): number {
  const power = 10 ** Math.floor(Math.log10(least));
  return power * [1, 2, 5, 10].find((factor) => factor * power >= least * (1 - 1e-9))!;
}

/** @param largest that it is beside */
function fixed(value: number, step: number, largest: number): string {
  if (largest >= 1e6 || step < 1e-4) {
    const digits = Math.max(0, Math.round(Math.log10(largest / step)));
    return value === 0 ? '0' : value.toExponential(Math.min(digits, 6));
  }
  return value.toFixed(decimals(step)).replace(/^-(0(?:\.0+)?)$/, '$1');
}

const decimals = (step: number) => Math.max(0, -Math.floor(Math.log10(step) + 1e-9));

/** How far it may be off beside it, both to the digit that the error leaves sure: `0.0390 ± 0.0006`. */
export function withError(value: number, error: number): string {
  if (error === 0) {
    return `${numberText(value)} ± 0`;
  }
  const largest = Math.max(Math.abs(value), error);
  const power = largest >= 1e6 || largest < 1e-3 ? 10 ** Math.floor(Math.log10(largest)) : 1;
  const digits = Math.min(9, decimalsOf(error / power));
  const both = `${(value / power).toFixed(digits)} ± ${(error / power).toFixed(digits)}`;
  return power === 1 ? both : `(${both})e${Math.round(Math.log10(power))}`;
}

/** Of an error: two digits where it begins with a one or a two, else one. */
function decimalsOf(error: number): number {
  const first = Math.floor(Math.log10(error));
  return Math.max(0, error / 10 ** first < 2.95 ? 1 - first : -first);
}
