import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { svelte } from '@sveltejs/vite-plugin-svelte';
import { defineConfig, type Plugin } from 'vite';

/** `npm run dev` shows the run of a server that is started beside it on its usual port. */
const server = 'http://127.0.0.1:8735';

/** Leaves what is worth it packed, too: so the server does not work for that while somebody waits. */
const packed: Plugin = {
  name: 'packed',
  apply: 'build',
  writeBundle({ dir }, files) {
    for (const name of Object.keys(files).filter((file) => /\.(js|css|html|svg)$/.test(file))) {
      const file = join(dir ?? 'dist', name);
      writeFileSync(`${file}.gz`, gzipSync(readFileSync(file), { level: 9 }));
    }
  },
};

export default defineConfig({
  base: './', // the same page is at the address of each of the runs side by side
  plugins: [svelte(), packed],
  build: {
    rolldownOptions: { input: ['index.html', 'beside.html'] },
    target: 'es2023',
    modulePreload: { polyfill: false },
    license: { fileName: 'licenses.json' }, // of libraries in it, for releases
    assetsInlineLimit: 0, // the page's Content-Security-Policy knows no inline data
  },
  server: {
    host: '127.0.0.1',
    proxy: Object.fromEntries(
      ['/api', '/beside/'].map((address) => [
        address,
        { target: server, ws: true, changeOrigin: true, headers: { origin: server } },
      ]),
    ),
  },
});
