import type { Ending, MeasureInfo } from '../api/messages';
import { numberText } from '../format';
import { texts } from '../texts';

/** Names of the values that are of the whole run, in the scenario's order. */
export function ofRun(ending: Ending, measures: MeasureInfo[]): string[] {
  return Object.keys(ending.measures).filter((name) => measures.some((measure) => measure.name === name));
}

/**
 * The values that each robot has of its own (`distance.prey-1`), as a table: names of its columns, and rows with the
 * name of the value in each column.
 */
export function ofRobots(
  ending: Ending,
  measures: MeasureInfo[],
): { names: string[]; rows: { robot: string; of: string[] }[] } {
  const shares = Object.keys(ending.measures).filter((name) => !ofRun(ending, measures).includes(name));
  const names = [...new Set(shares.map(measureOf))];
  const robots = [...new Set(shares.map((name) => name.slice(measureOf(name).length + 1)))];
  return {
    names,
    rows: robots.map((robot) => ({ robot, of: names.map((name) => `${name}.${robot}`) })),
  };
}

/** `0.116 m`; empty where a robot has no share of a measure. */
export function measured(name: string, ending: Ending, measures: MeasureInfo[]): string {
  const value = ending.measures[name];
  if (value === undefined) {
    return '';
  }
  return value === null ? texts.ending.unmeasured : withUnit(numberText(value), infoOf(name, measures));
}

/** What a value may be: `at most 0.3 m`. */
export function boundOf(name: string, measures: MeasureInfo[]): string {
  const info = infoOf(name, measures);
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

function infoOf(name: string, measures: MeasureInfo[]): MeasureInfo | undefined {
  return measures.find((measure) => measure.name === measureOf(name));
}

function measureOf(name: string): string {
  return name.split('.')[0]!;
}

function withUnit(number: string, info: MeasureInfo | undefined): string {
  return `${number} ${info?.unit ?? ''}`.trimEnd();
}
