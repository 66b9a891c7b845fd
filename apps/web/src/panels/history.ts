import type { ChangeInfo } from '../api/messages';

/** What changes at least as often is told once. */
const OFTEN = 5;

/** A change, or the newest of many of the same belief or goal. */
export interface HistoryLine {
  change: ChangeInfo;
  times: number;
}

/**
 * The newest first. What always changes, as where a robot is, would leave no room for the rest: of such a belief or
 * goal the newest change stands for all.
 *
 * @param changes the oldest first
 */
export function foldHistory(changes: readonly ChangeInfo[]): HistoryLine[] {
  const key = ({ kind, name }: ChangeInfo) => (kind === 'DOES' ? null : `${kind} ${name}`);
  const counts = new Map<string | null, number>();
  changes.forEach((change) => counts.set(key(change), (counts.get(key(change)) ?? 0) + 1));
  const told = new Set<string>();
  return changes.toReversed().flatMap((change) => {
    const of = key(change);
    const times = of === null ? 1 : counts.get(of)!;
    if (of === null || times < OFTEN) {
      return [{ change, times: 1 }];
    }
    const again = told.has(of);
    told.add(of);
    return again ? [] : [{ change, times }];
  });
}
