import { readdirSync, readFileSync } from 'node:fs';
import { expect, it } from 'vitest';

const source = new URL('.', import.meta.url);

it('names nothing by an absolute path, as a reverse proxy may show the page below another one', () => {
  const parts = readdirSync(source, { recursive: true }).filter((path) => String(path).endsWith('.svelte'));
  expect(parts.length).toBeGreaterThan(20);
  const absolute = parts.flatMap((path) => {
    const text = readFileSync(new URL(String(path), source), 'utf8');
    return [...text.matchAll(/\b(?:src|href)="\/[^"]*"/g)].map(([found]) => `${path}: ${found}`);
  });
  expect(absolute).toEqual([]);
});
