import { defineConfig } from 'vite';

/** One script that reports carry, so that they need neither a server nor the network. */
export default defineConfig({
  publicDir: false,
  build: {
    target: 'es2023',
    emptyOutDir: false, // the page is there already
    license: { fileName: 'licenses-of-plots.json' }, // of libraries in it, for releases
    chunkSizeWarningLimit: 1500, // kB; Vega is large
    lib: { entry: 'src/plots/plots.ts', name: 'plots', formats: ['iife'], fileName: () => 'plots.js' },
  },
});
