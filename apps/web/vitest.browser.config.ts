import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    include: ['browser-tests/**/*.test.ts'],
    passWithNoTests: true,
    fileParallelism: false, // one browser at a time; they share the machine with the run
    testTimeout: 60_000,
    hookTimeout: 120_000,
    chaiConfig: { truncateThreshold: 0 }, // what was found is told whole
    reporters: ['default', 'junit'],
    outputFile: { junit: 'target/reports/browser.xml' },
  },
});
