import type { Series } from './series';

export interface Column {
  readonly name: string;
  readonly unit: string;
  readonly series: Series;
}

/** All that is kept of some numbers, a row for each time of any of them [s]; empty where one was not told then. */
export function csvOf(columns: readonly Column[]): string {
  const times = [...new Set(columns.flatMap(({ series }) => [...series.times]))].sort((a, b) => a - b);
  const known = columns.map(({ series }) => new Map(series.times.map((time, i) => [time, series.values[i]])));
  const heads = columns.map(({ name, unit }) => (unit === '' ? name : `${name} [${unit}]`));
  return [
    ['time [s]', ...heads].map(quoted),
    ...times.map((time) => [time, ...known.map((values) => values.get(time) ?? '')]),
  ]
    .map((row) => `${row.join(',')}\r\n`)
    .join('');
}

const quoted = (text: string) => (/[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
