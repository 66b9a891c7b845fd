import { defineConfig } from 'vitest/config';

/** Takes the documentation's pictures of the page anew. */
export default defineConfig({
  test: {
    include: ['pictures/**/*.pictures.ts'],
    fileParallelism: false, // one browser at a time; they share the machine with the run
    testTimeout: 600_000,
    hookTimeout: 120_000,
  },
});
