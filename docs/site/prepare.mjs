/**
 * Lays out in docs/site/target/pages what VitePress makes the site of: the pages with their links as they are there,
 * pictures and other files beside them, and the sources that pages point to, as pages of their own. A link to nothing
 * ends it.
 */
import { cpSync, existsSync, mkdirSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, extname, join } from 'node:path';
import { START, exists, forgotten, isFolder, pages, read, target, top } from './content.mjs';

const out = join(top, 'docs/site/target/pages');
const CODE = /(^```.*?^```$|`[^`\n]*`)/ms;
const LINK = /\]\(([^)\s]+)\)/g;
const MARK = /<!-- (from the code: [^>]*|end) -->\n/g;
const LANGUAGES = { '.java': 'java', '.yaml': 'yaml', '.asl': 'asl', '.xml': 'xml' };

const dead = [];
const sources = new Set(); // that are to be shown as pages

function write(path, text) {
  mkdirSync(dirname(join(out, path)), { recursive: true });
  writeFileSync(join(out, path), text);
}

/** Puts a file where the site has it, beside the pages; `docs` is the site's top. */
function publish(path) {
  const place = path.replace(/^docs\//, '');
  cpSync(join(top, path), join(out, 'public', place), { recursive: true });
  return `/${place}`;
}

function show(path) {
  sources.add(path);
  return `/source/${path}.md`;
}

function linked(page, link) {
  const path = target(page, link);
  if (path === undefined) return link;
  const heading = link.includes('#') ? `#${link.split('#', 2)[1]}` : '';
  if (path === 'README.md' || path === START) return '/';
  if (pages.has(path)) return `/${pages.get(path)}${heading}`;
  if (!exists(path)) {
    dead.push(`${page}: ${link}`);
    return link;
  }
  if (isFolder(path)) return show(path);
  return path.startsWith('docs/') ? publish(path) : show(path);
}

/** A page of the repository as the site has it. */
function transformed(page) {
  return read(page)
    .replace(MARK, '')
    .split(CODE)
    .map((text, i) => (i % 2 ? text : text.replace(LINK, (_, link) => `](${linked(page, link)})`)))
    .join('');
}

const NOT_FOUND_BY_SEARCH = '---\nsearch: false\neditLink: false\n---\n\n';

function sourcePage(path) {
  const name = path.split('/').at(-1);
  if (isFolder(path)) {
    const files = readdirSync(join(top, path), { withFileTypes: true })
      .filter((file) => file.isFile())
      .map((file) => file.name)
      .sort();
    const lines = files.map((file) => `* [${file}](${show(`${path}/${file}`)})`);
    return `${NOT_FOUND_BY_SEARCH}# ${name}\n\nThe folder \`${path}\`.\n\n${lines.join('\n')}\n`;
  }
  const language = LANGUAGES[extname(name)] ?? 'text';
  return `${NOT_FOUND_BY_SEARCH}# ${name}\n\nThe file \`${path}\`.\n\n\`\`\`\`${language}\n${read(path)}\`\`\`\`\n`;
}

rmSync(out, { recursive: true, force: true });
cpSync(join(top, 'docs/site/index.md'), join(out, 'index.md'));
cpSync(join(top, 'apps/web/public/icon.svg'), join(out, 'public/icon.svg'));
publish('docs/images/page.png');
publish('docs/reference/scenario.schema.json');
publish('docs/reference/world.schema.json');
const javadoc = join(top, 'docs/site/target/javadoc'); // which `./rsal docs` makes
if (existsSync(javadoc)) cpSync(javadoc, join(out, 'public/javadoc'), { recursive: true });
for (const [page, place] of pages) write(place, transformed(page));
for (const path of sources) write(`source/${path}.md`, sourcePage(path)); // a folder adds its files meanwhile

const missing = forgotten().map((path) => `${path}: it belongs to no part of docs/site/parts.mjs`);
if (dead.length + missing.length > 0) {
  console.error(['Links that lead nowhere, and pages that nobody finds:', ...dead, ...missing].join('\n  '));
  process.exit(1);
}
