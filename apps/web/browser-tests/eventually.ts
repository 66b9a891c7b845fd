const PATIENCE_MILLIS = 60_000; // a machine may be busy with other tests

/**
 * Waits until something is so.
 *
 * @param patience how long at most [ms]
 */
export async function eventually(
  holds: () => Promise<boolean>,
  what: string,
  patience = PATIENCE_MILLIS,
): Promise<void> {
  const end = performance.now() + patience;
  while (!(await holds())) {
    if (performance.now() > end) {
      throw new Error(`It never came true that ${what}.`);
    }
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
}

/** Waits until something is the same three times in a row, and tells what that is. */
export async function settled<T>(look: () => Promise<T>, what: string): Promise<T> {
  const seen: string[] = [];
  let now = await look();
  await eventually(async () => {
    now = await look();
    seen.push(JSON.stringify(now));
    await new Promise((resolve) => setTimeout(resolve, 200));
    return seen.length > 2 && new Set(seen.slice(-3)).size === 1;
  }, what);
  return now;
}
