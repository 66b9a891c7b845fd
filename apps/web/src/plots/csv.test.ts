import { expect, it } from 'vitest';
import { csvOf } from './csv';
import { Series } from './series';

it('has a row for each time, a column for each number, and nothing where none was reported', () => {
  const [one, other] = [new Series(), new Series()];
  one.push(0.1, 1.5);
  one.push(0.2, null);
  one.push(0.3, -2e-9);
  other.push(0.2, 7);
  const columns = [
    { name: 'r1: laser distance, "least"', unit: 'm', series: one },
    { name: 'r1: base stalled', unit: '', series: other },
  ];
  expect(csvOf(columns)).toBe(
    'time [s],"r1: laser distance, ""least"" [m]",r1: base stalled\r\n0.1,1.5,\r\n0.2,,7\r\n0.3,-2e-9,\r\n',
  );
});
