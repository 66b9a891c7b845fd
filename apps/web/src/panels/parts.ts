const SIZE = 40;

/** A long list in parts, each for a {@link Part}. */
export function partsOf<T>(items: readonly T[]): (readonly T[])[] {
  return Array.from({ length: Math.ceil(items.length / SIZE) }, (_, i) =>
    items.slice(i * SIZE, (i + 1) * SIZE),
  );
}
