import type { SweepCombination, SweepEstimate } from '../api/messages';
import { axisOf, type Axis } from '../plots/axis';

/** Where values lie in plots of a metric. */
export interface Scale {
  /** From the left end of the plots to the right one. */
  axis: Axis;
  /** From 0 at the left to 1 at the right. */
  at: (value: number) => number;
}

/** Of a metric, the same for all combinations, so that their plots can be compared; null when there is nothing. */
export function scaleOf(metric: string, combinations: readonly SweepCombination[]): Scale | null {
  const values = combinations.flatMap(({ metrics }) => (metrics[metric] ? ends(metrics[metric]) : []));
  if (values.length === 0) {
    return null;
  }
  const axis = axisOf(Math.min(...values), Math.max(...values));
  const span = axis.greatest - axis.least;
  return { axis, at: span === 0 ? () => 0.5 : (value) => (value - axis.least) / span };
}

function ends({ mean, low, high, box }: SweepEstimate): number[] {
  return [mean, low ?? mean, high ?? mean, box.low, box.high, ...box.outside];
}

/** `2 min 5 s` */
export function duration(seconds: number): string {
  const whole = Math.round(seconds);
  if (whole >= 3600) {
    return `${Math.floor(whole / 3600)} h ${Math.floor((whole % 3600) / 60)} min`;
  }
  return whole >= 60 ? `${Math.floor(whole / 60)} min ${whole % 60} s` : `${whole} s`;
}
