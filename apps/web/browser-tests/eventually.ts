const PATIENCE_MILLIS = 30_000;

/** Waits until something is so. */
export async function eventually(holds: () => Promise<boolean>, what: string): Promise<void> {
  const end = performance.now() + PATIENCE_MILLIS;
  while (!(await holds())) {
    if (performance.now() > end) {
      throw new Error(`It never came true that ${what}.`);
    }
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
}
