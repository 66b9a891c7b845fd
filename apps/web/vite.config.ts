import { svelte } from '@sveltejs/vite-plugin-svelte';
import { defineConfig } from 'vite';

/** `npm run dev` shows the run of a server that is started beside it on its usual port. */
const server = 'http://127.0.0.1:8735';

export default defineConfig({
  base: './', // the same page is at the address of each of the runs side by side
  plugins: [svelte()],
  build: {
    rolldownOptions: { input: ['index.html', 'beside.html'] },
    target: 'es2023',
    modulePreload: false,
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
