// Starts Chromium and wraps a page in the few words the tests speak.
import { AssertionError } from 'node:assert/strict';
import { chromium } from 'playwright-core';
import { onPath } from './system.mjs';

// What Chromium would prepare beside each page and no test needs: the list of suggestions under its address bar, a page of
// its own that costs more processor time than ours takes to open. The other names are those that playwright switches off,
// which this list takes the place of.
const WITHOUT = [
  ...['WebUIOmniboxPopup', 'WebUIOmniboxAimPopup', 'WebUIOmniboxFullPopup'],
  ...['AimEnabled', 'AvoidCorsURLLoaderRestartOnRedirect', 'AvoidUnnecessaryBeforeUnloadCheckSync', 'DestroyProfileOnBrowserClose', 'HttpsFirstBalancedModeAutoEnable', 'HttpsUpgrades', 'LensOverlay', 'MediaRouter', 'NetworkTimeServiceQuerying', 'OptimizationHints', 'PaintHolding', 'PreconnectToSearch', 'ThirdPartyStoragePartitioning'],
];
const FLAGS = ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync', `--disable-features=${WITHOUT.join()}`];
const NAMES = ['chromium', 'chromium-browser', 'google-chrome'];
const PATIENCE_MS = 60_000; // a busy machine may stand still for half a minute

/** Chromium from the variable CHROMIUM or the PATH; null when there is none. */
export const findChromium = () => process.env.CHROMIUM || onPath(NAMES);

/** Also makes sure that the page works where there are none. */
const WITHOUT_SERVICE_WORKERS = () => Object.defineProperty(Navigator.prototype, 'serviceWorker', { value: undefined });

/** A context that waits as long as those of `openPage`. @param {import('playwright-core').BrowserContext} context */
export function patient(context) {
  context.setDefaultTimeout(PATIENCE_MS);
  return context;
}

/**
 * Repeats an assertion until it holds; what it said last is thrown when patience ends. For what the page shows a moment
 * after something was done; what must never be the case is asserted once, after something that shows that all is done.
 *
 * @template T
 * @param {() => T | Promise<T>} assertion
 * @returns {Promise<T>} what the assertion gives
 */
export async function eventually(assertion) {
  for (const end = Date.now() + PATIENCE_MS; ; await new Promise((resume) => setTimeout(resume, 20))) {
    try {
      return await assertion();
    } catch (error) {
      if (!(error instanceof AssertionError) || Date.now() > end) throw error;
    }
  }
}

/** Starts a browser with a user-data directory of its own. @param {string} executablePath */
export const launch = (executablePath) => chromium.launch({ executablePath, args: FLAGS });

/**
 * A page in a context of its own, opened at a hash and past loading.
 *
 * @param {import('playwright-core').Browser} browser
 * @param {string} url
 * @param {string} [hash] the opening scenario from tick 0 where nothing is said; a bare address is '#/'
 * @param {import('playwright-core').BrowserContextOptions} [options] motion is reduced unless asked for, so nothing moves by itself;
 *   without `serviceWorkers: 'allow'` the page keeps nothing for later visits
 * @param {(opened: Opened) => unknown} [made] is given the page before it has loaded
 */
export async function openPage(browser, url, hash = '', options = {}, made = () => {}) {
  const context = patient(await browser.newContext({ viewport: { width: 1440, height: 900 }, reducedMotion: 'reduce', ...options }));
  if (options.serviceWorkers !== 'allow') await context.addInitScript(WITHOUT_SERVICE_WORKERS);
  const page = await context.newPage();
  const problems = [];
  page.on('console', (message) => {
    if (message.type() === 'error' || message.type() === 'warning') problems.push(message.text());
  });
  page.on('pageerror', (error) => problems.push(error.message));
  page.on('request', (request) => {
    if (!request.url().startsWith(url) && !/^(data|blob):/.test(request.url())) problems.push(`asked for ${request.url()}`);
  });
  const opened = wrap(page, problems);
  made(opened);
  await page.goto(url + (hash || '#/forage?preset=foraging'));
  await opened.until(() => document.body.dataset.state !== 'loading');
  return opened;
}

/** @param {import('playwright-core').Page} page @param {string[]} problems */
function wrap(page, problems) {
  const opened = {
    page,
    problems,
    close: () => page.context().close(),

    /** Waits for a condition in the page. @param {(argument: any) => unknown} condition @param {unknown} [argument] */
    until: (condition, argument) => page.waitForFunction(condition, argument, { polling: 20 }),

    /** @param {...string} names */
    inState: (...names) => opened.until((/** @type {string[]} */ wanted) => wanted.includes(document.body.dataset.state ?? ''), names),

    tick: async () => Number(await page.locator('#tick').textContent()),

    /** Waits until the world stands at a tick and shows its fingerprint. @param {number} tick */
    async at(tick) {
      await opened.until(
        (wanted) =>
          document.querySelector('#tick')?.textContent === String(wanted) &&
          /** @type {HTMLElement} */ (document.querySelector('#fingerprint')).dataset.tick === String(wanted) &&
          ['paused', 'finished'].includes(document.body.dataset.state ?? ''),
        tick,
      );
      return /** @type {string} */ (await page.locator('#fingerprint').textContent());
    },

    /** Waits until the world stands after it has played; gives its tick. A frame may still be under way when the state is paused. */
    async rest() {
      await opened.until(() => document.body.dataset.state === 'paused' && location.hash.includes(`t=${document.querySelector('#tick')?.textContent}&f=`));
      return opened.tick();
    },

    /** Moves the scrubber. @param {number} tick */
    async seek(tick) {
      await page.locator('#scrub').evaluate((scrub, wanted) => {
        /** @type {HTMLInputElement} */ (scrub).value = String(wanted);
        scrub.dispatchEvent(new Event('input'));
      }, tick);
      return opened.at(tick);
    },

    /** Waits for a notice. @param {RegExp} pattern */
    async notice(pattern) {
      const notice = page.locator('.notice p').filter({ hasText: pattern });
      await notice.first().waitFor();
      return notice.first().textContent();
    },

    /** Asks a second engine, started from the page's own worker file. @param {string} type @param {object} [body] */
    engine: (type, body = {}) =>
      page.evaluate(
        ([address, message]) =>
          new Promise((resolve) => {
            const worker = new Worker(/** @type {string} */ (address), { type: 'module' });
            worker.onmessage = (event) => {
              worker.terminate();
              resolve(event.data);
            };
            worker.postMessage(message);
          }),
        [page.workers()[0].url(), { id: 1, type, ...body }],
      ),

    hash: () => page.evaluate(() => location.hash),

    /** Waits until the address names the moment on screen, and gives its hash. @param {number} tick */
    async address(tick) {
      const part = tick === 0 ? 'preset=' : `t=${tick}&f=${await opened.at(tick)}`;
      await opened.until((wanted) => location.hash.includes(wanted), part);
      return opened.hash();
    },

    /** Opens every group of controls. */
    openGroups: () => page.locator('#controls details').evaluateAll((groups) => groups.forEach((group) => group.setAttribute('open', ''))),
  };
  return opened;
}

/** @typedef {ReturnType<typeof wrap>} Opened */
/** @typedef {(hash?: string, options?: import('playwright-core').BrowserContextOptions) => Promise<Opened>} Open */
/** @typedef {[name: string, run: (open: Open, url: string) => Promise<void | string>, how?: 'alone']} Case a note that is returned is printed; one that measures time runs alone */
