import { accessSync, constants } from 'node:fs';
import { delimiter, join } from 'node:path';

/** The first has no windows at all: it starts in a third of the time, and pages cost half of it. */
const NAMES = [
  'chromium-headless-shell',
  'chromium',
  'chromium-browser',
  'google-chrome',
  'google-chrome-stable',
];
const MAC = [
  '/Applications/Chromium.app/Contents/MacOS/Chromium',
  '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
];

/** The browser on this machine, if there is one. */
export const chromium = [
  ...NAMES.flatMap((name) => (process.env.PATH ?? '').split(delimiter).map((folder) => join(folder, name))),
  ...MAC,
].find(isExecutable);

if (!chromium) {
  console.warn(`
==================================================================
BROWSER TESTS SKIPPED: they need Chromium, and there is none. Install it:
  Debian           sudo apt-get install chromium-headless-shell   (or chromium)
  macOS            brew install --cask chromium
==================================================================`);
}

/** Nothing but the page: no calls home, no first-run pages, no GPU. */
export const flags = [
  '--headless',
  '--no-sandbox',
  '--disable-gpu',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--no-first-run',
];

function isExecutable(file: string): boolean {
  try {
    accessSync(file, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}
