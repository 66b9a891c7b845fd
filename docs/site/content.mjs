import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { leftOut, others, parts } from './parts.mjs';

export const top = join(dirname(fileURLToPath(import.meta.url)), '../..');

export const read = (path) => readFileSync(join(top, path), 'utf8');

const inFolder = (folder) =>
  readdirSync(join(top, folder))
    .filter((name) => name.endsWith('.md'))
    .sort((a, b) => Number(b === 'README.md') - Number(a === 'README.md') || a.localeCompare(b))
    .map((name) => `${folder}/${name}`);

/** What GitHub shows of the folder `docs`; the site has its home instead. */
export const START = 'docs/README.md';

/** The parts with the paths of their pages. */
export const resolved = parts.map((part) => ({
  ...part,
  groups: part.groups.map((group) => ({
    ...group,
    pages: typeof group.pages === 'string' ? inFolder(group.pages) : group.pages,
  })),
}));

/** Where a page of the repository is in the site: `tutorials/first-agent.md`. */
function place(path) {
  if (path === 'CONTRIBUTING.md') return 'contributing.md';
  return path
    .replace(/^docs\//, '')
    .replace(/^first-hour/, 'tutorials/first-hour')
    .replace(/^runs\/scenarios\/.*\/([^/]+)\/README\.md$/, 'scenarios/$1.md')
    .replace(/README\.md$/, 'index.md');
}

/** Paths in the repository, and where they are in the site. */
export const pages = new Map(
  [...resolved.flatMap((part) => part.groups.flatMap((group) => group.pages)), ...others].map((path) => [
    path,
    place(path),
  ]),
);

export function title(path) {
  const heading = /^# (.*)$/m.exec(read(path));
  if (!heading) throw new Error(`Page (${path}) has no heading. Maybe it begins with "# Title"?`);
  return heading[1];
}

/** Markdown under `docs` that no part names: somebody forgot it. */
export function forgotten() {
  return readdirSync(join(top, 'docs'), { recursive: true })
    .map((name) => `docs/${name.replaceAll('\\', '/')}`)
    .filter((path) => path !== START)
    .filter((path) => path.endsWith('.md') && !leftOut.some((folder) => path.startsWith(`${folder}/`)))
    .filter((path) => !pages.has(path));
}

/** What a link in a page is about: a path in the repository, or undefined when it leads elsewhere. */
export function target(page, link) {
  if (/^([a-z]+:|#)/.test(link)) return undefined;
  return normalize(join(dirname(page), decodeURIComponent(link.split('#', 1)[0]))).replace(/\/$/, '');
}

export const isFolder = (path) => statSync(join(top, path)).isDirectory();

export const exists = (path) => existsSync(join(top, path));
