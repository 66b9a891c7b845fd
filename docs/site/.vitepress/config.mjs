import { defineConfig } from 'vitepress';
import { pages, resolved, title } from '../content.mjs';
import { licences } from '../licences.mjs';

const link = (path) => `/${pages.get(path)}`.replace(/(index)?\.md$/, '');

const sidebar = ({ groups }) =>
  groups.map((group) => ({
    text: group.title,
    items: group.pages.map((path) => ({ text: title(path), link: link(path) })),
  }));

/** What GitHub calls the place of a heading, so that links work there and here. */
const slugify = (heading) =>
  heading
    .toLowerCase()
    .replace(/[^\p{L}\p{N} _-]/gu, '')
    .replaceAll(' ', '-');

/** Where it is on its host, as `/rsal/`. */
const base = process.env.RSAL_SITE_BASE ?? '/';

export default defineConfig({
  title: 'RSAL',
  description: 'Agents decide what teams of robots do',
  lang: 'en',
  head: [['link', { rel: 'icon', type: 'image/svg+xml', href: `${base}icon.svg` }]],
  srcDir: 'target/pages',
  outDir: '../../target/site',
  cacheDir: 'target/cache',
  base,
  metaChunk: true,
  buildConcurrency: 1, // so that twice the same pages give the same search index
  vite: { plugins: [licences] },
  // Words of the documentation in <angle brackets> are no HTML.
  markdown: {
    html: false,
    languageAlias: { asl: 'prolog', console: 'shellsession' },
    anchor: { slugify },
    toc: { slugify },
  },
  themeConfig: {
    logo: '/icon.svg',
    outline: [2, 3],
    search: {
      provider: 'local',
      options: {
        miniSearch: {
          searchOptions: {
            // Who searches for "ROS" wants the page about it, before headings elsewhere that have few other words.
            boostDocument: (id, _term, stored) =>
              /\/(how-to|tutorials)\//.test(id) && stored?.titles?.length === 0 ? 2 : 1,
          },
        },
      },
    },
    nav: [
      ...resolved.map((part) => ({
        text: part.title,
        link: link(part.groups[0].pages[0]),
        activeMatch: `^/${pages.get(part.groups[0].pages[0]).split('/')[0]}/`,
      })),
      { text: 'Java API', link: '/javadoc/index.html', target: '_self' },
    ],
    sidebar: Object.fromEntries(
      resolved.map((part) => [`/${pages.get(part.groups[0].pages[0]).split('/')[0]}/`, sidebar(part)]),
    ),
    footer: { message: 'Apache-2.0' },
  },
});
