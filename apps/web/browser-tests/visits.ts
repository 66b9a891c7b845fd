import { AxeBuilder } from '@axe-core/playwright';
import {
  chromium as driver,
  type Browser,
  type BrowserContext,
  type BrowserContextOptions,
  type Page,
} from 'playwright-core';
import { afterAll, afterEach, beforeEach, expect, it } from 'vitest';
import { chromium, flags } from './chromium';
import { Rsal } from './rsal';

/** Where pictures go of what was tested, for people to look at; none when it is not set. */
const PICTURES = process.env.PICTURES;

/** What the server answers when people ask for what can't be: no error of the page, where a test does that. */
const REFUSED = /status of 4(09|22)/;

/** Whether `./rsal test --all` runs this, for which what takes too long for each landing is left. */
const all = process.env.RSAL_TEST_ALL === 'true';

/** A test that takes too long for each landing. */
export const longTest = it.runIf(all);

/** What a test tries: the first ones at each landing, all by `./rsal test --all`. */
export function trials<T>(values: readonly T[], landing = 1): readonly T[] {
  return all ? values : values.slice(0, landing);
}

/**
 * Lets a page draw 20 times a second, as on a slow computer. Without a GPU, 60 pictures a second take a third of the
 * processor that tests have.
 */
function drawSeldom() {
  const PERIOD = 50; // ms
  let due = 0;
  window.requestAnimationFrame = (draw) => {
    const now = performance.now();
    if (due <= now) {
      due = (Math.floor(now / PERIOD) + 1) * PERIOD; // all that ask until then are drawn together
    }
    return window.setTimeout(() => draw(performance.now()), due - now);
  };
  window.cancelAnimationFrame = (id) => window.clearTimeout(id);
}

/** Colors and sizes that pages are looked at in. */
export const looks = trials([
  ['light', 1280, 720],
  ['dark', 820, 1180],
  ['light', 820, 1180],
  ['dark', 1280, 720],
] as const);

let launched: Promise<Browser> | undefined;

/** The browser of all files that this process tests, as its start takes a second of a processor. It ends with the process. */
function theBrowser(): Promise<Browser> {
  launched ??= driver.launch({ executablePath: chromium!, args: flags }).then(
    (browser) => {
      browser.on('disconnected', () => (launched = undefined)); // one that has crashed fails the tests of one file
      return browser;
    },
    (error: unknown) => {
      launched = undefined; // so does one that does not start
      throw error;
    },
  );
  return launched;
}

interface Visit extends BrowserContextOptions {
  /** Of a server that may be gone at times: what goes wrong then is no error of the page. */
  mayFail?: boolean;
}

/**
 * The pages of a file's tests. To be called where they are described, before their own hooks. What is opened for one test
 * is closed behind it, what is opened for all of them behind the last; and no page may fail, break its security policy, or
 * call somebody else.
 *
 * @param refusals whether these tests ask for what can't be
 */
export function visits({ refusals = true } = {}) {
  const forAll: BrowserContext[] = [];
  let opened: BrowserContext[] = [];
  let faults: string[] = [];
  let forOneTest = false;

  beforeEach(() => {
    forOneTest = true;
  });

  /** Closes what was opened for this test, as its end does. */
  async function close() {
    await Promise.all(opened.map((context) => context.close()));
    opened = [];
  }

  afterEach(async () => {
    await close();
    const found = faults;
    faults = [];
    expect(found).toEqual([]);
  });

  afterAll(async () => {
    await Promise.all(forAll.map((context) => context.close()));
    await Rsal.endAll();
  });

  /** A page of somebody else each time. */
  async function open(url: string, { mayFail = false, ...options }: Visit = {}): Promise<Page> {
    const browser = await theBrowser();
    const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
    (forOneTest ? opened : forAll).push(context);
    context.setDefaultTimeout(60_000); // as the machine may be busy with other tests
    context.setDefaultNavigationTimeout(60_000);
    await context.addInitScript(drawSeldom);
    const page = await context.newPage();
    if (!mayFail) {
      watch(page, new URL(url).host);
    }
    await page.goto(url);
    return page;
  }

  function watch(page: Page, host: string) {
    page.on('pageerror', (error) => faults.push(error.message));
    page.on('console', (message) => {
      if (message.type() === 'error' && !(refusals && REFUSED.test(message.text()))) {
        faults.push(message.text());
      }
    });
    page.on('request', (request) => {
      const asked = new URL(request.url());
      if (asked.host !== '' && asked.host !== host) {
        faults.push(`asks ${request.url()}`);
      }
    });
  }

  /** The same, once its robots are there. */
  async function openRun(url: string, options?: Visit): Promise<Page> {
    const page = await open(url, options);
    await page.locator('tr[data-robot][data-x]').first().waitFor();
    return page;
  }

  return { open, openRun, close };
}

export async function picture(page: Page, name: string) {
  if (PICTURES) {
    await page.screenshot({ path: `${PICTURES}/${name}.png` });
  }
}

/**
 * No rule of accessibility is broken.
 *
 * @param within a selector, when the rest is not to be looked at
 */
export async function expectAccessible(page: Page, within?: string, what?: string) {
  const axe = violations(page).setLegacyMode(); // in the page itself, which has no frames of other origins
  await expectNoViolation(within === undefined ? axe : axe.include(within), what);
}

/** Finds what breaks a rule; what keeps one is not described, which takes most of the time. */
export function violations(page: Page): AxeBuilder {
  return new AxeBuilder({ page }).options({ resultTypes: ['violations'] });
}

export async function expectNoViolation(axe: AxeBuilder, what?: string) {
  const { violations } = await axe.analyze();
  expect(
    violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(' ')}`),
    what,
  ).toEqual([]);
}
