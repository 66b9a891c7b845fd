import { svelte } from '@sveltejs/vite-plugin-svelte';
import { defineConfig } from 'vitest/config';

export default defineConfig({
  plugins: [svelte()],
  test: {
    include: ['src/**/*.test.ts'],
    testTimeout: 60_000, // they run at low priority, beside all tests of Java
    hookTimeout: 60_000,
  },
});
