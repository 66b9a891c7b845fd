import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    include: ['browser-tests/**/*.test.ts'],
    passWithNoTests: true,
    isolate: false, // files one after the other share a process, its libraries and its browser
    maxWorkers: 2, // browsers at a time: most of the time each waits for its run
    testTimeout: 180_000, // longer than what is waited for in them
    hookTimeout: 120_000,
    chaiConfig: { truncateThreshold: 0 }, // what was found is told whole
    reporters: ['default', 'junit'],
    outputFile: { junit: 'target/reports/browser.xml' },
  },
});
