/** Rows of each part: as many as most screens show of a list, so that the first picture does not wait for more. */
const SIZE = 12;

/** A long list in parts, each for a {@link Part}. */
export function partsOf<T>(items: readonly T[]): (readonly T[])[] {
  return Array.from({ length: Math.ceil(items.length / SIZE) }, (_, i) =>
    items.slice(i * SIZE, (i + 1) * SIZE),
  );
}
