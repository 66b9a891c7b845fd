import type { Ending, MetricInfo } from '../api/messages';
import { numberText } from '../format';
import { texts } from '../texts';

/** Names of the values that are of the whole run, in the scenario's order. */
export function ofRun(ending: Ending, metrics: MetricInfo[]): string[] {
  return Object.keys(ending.metrics).filter((name) => metrics.some((metric) => metric.name === name));
}

/**
 * The values that each robot has of its own (`distance.prey-1`), as a table: names of its columns, and rows with the
 * name of the value in each column.
 */
export function ofRobots(
  ending: Ending,
  metrics: MetricInfo[],
): { names: string[]; rows: { robot: string; of: string[] }[] } {
  const shares = Object.keys(ending.metrics).filter((name) => !ofRun(ending, metrics).includes(name));
  const names = [...new Set(shares.map(metricOf))];
  const robots = [...new Set(shares.map((name) => name.slice(metricOf(name).length + 1)))];
  return {
    names,
    rows: robots.map((robot) => ({ robot, of: names.map((name) => `${name}.${robot}`) })),
  };
}

/** `0.116 m`; empty where a robot has no share of a metric. */
export function measured(name: string, ending: Ending, metrics: MetricInfo[]): string {
  const value = ending.metrics[name];
  if (value === undefined) {
    return '';
  }
  return value === null ? texts.ending.unmeasured : withUnit(numberText(value), infoOf(name, metrics));
}

/** What a value may be: `at most 0.3 m`. */
export function boundOf(name: string, metrics: MetricInfo[]): string {
  const info = infoOf(name, metrics);
  const min = info?.min ?? null;
  const max = info?.max ?? null;
  if (min !== null && max !== null) {
    return texts.range.between(String(min), withUnit(String(max), info));
  }
  return min !== null
    ? texts.range.least(withUnit(String(min), info))
    : max !== null
      ? texts.range.most(withUnit(String(max), info))
      : '';
}

function infoOf(name: string, metrics: MetricInfo[]): MetricInfo | undefined {
  return metrics.find((metric) => metric.name === metricOf(name));
}

function metricOf(name: string): string {
  return name.split('.')[0]!;
}

function withUnit(number: string, info: MetricInfo | undefined): string {
  return `${number} ${info?.unit ?? ''}`.trimEnd();
}
