// Visits after the first, without the network and after a newer build came out.
import assert from 'node:assert/strict';
import { cpSync, mkdtempSync, readFileSync, readdirSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { openPage } from './browser.mjs';
import { serve } from './serve.mjs';

/** @typedef {import('./browser.mjs').Open} Open */
/** @typedef {import('./browser.mjs').Opened} Opened */

const dist = fileURLToPath(new URL('../../dist', import.meta.url));
const HASHED = /-[\w-]{8}\.\w+$/;

/** A copy of the build as the next one would be: each file under another name, and none of the old ones. @param {string} folder */
function nextBuild(folder) {
  cpSync(dist, folder, { recursive: true });
  const assets = join(folder, 'assets');
  const renamed = readdirSync(assets).map((name) => /** @type {const} */ ([name, name.replace(HASHED, (end) => end.replace(/^-./, end[1] === 'x' ? '-y' : '-x'))]));
  for (const [name, next] of renamed) renameSync(join(assets, name), join(assets, next));
  for (const file of readdirSync(folder, { recursive: true, withFileTypes: true })) {
    if (!file.isFile() || !['.js', '.css', '.html'].includes(extname(file.name))) continue;
    const path = join(file.parentPath, file.name);
    let text = readFileSync(path, 'utf8');
    for (const [name, next] of renamed) text = text.replaceAll(name, next);
    if (file.name === 'sw.js') text = text.replace(/(url:.index\.html.,revision:.)\w{8}/, '$100000000');
    writeFileSync(path, text);
  }
}

/**
 * Runs a test on a server of its own whose folder can be changed.
 *
 * @param {Open} open only to know the browser
 * @param {(parts: { visit: (hash?: string) => Promise<Opened>, stop: () => void, replace: (folder: string) => void, temporary: string, url: string }) => Promise<void | string>} test
 */
async function ownServer(open, test) {
  const browser = /** @type {import('playwright-core').Browser} */ ((await open('#/trees')).page.context().browser());
  const temporary = mkdtempSync(join(tmpdir(), 'swarm-offline-'));
  const served = join(temporary, 'served');
  cpSync(dist, served, { recursive: true });
  const server = await serve(served, '/class/');
  /** @type {Opened[]} */
  const opened = [];
  const visit = async (hash = '') => {
    const page = await openPage(browser, server.url, hash, { serviceWorkers: 'allow' });
    opened.push(page);
    return page;
  };
  const replace = (/** @type {string} */ folder) => {
    rmSync(served, { recursive: true });
    cpSync(folder, served, { recursive: true });
  };
  try {
    return await test({ visit, stop: server.close, replace, temporary, url: server.url });
  } finally {
    for (const { close } of opened) await close();
    server.close();
    rmSync(temporary, { recursive: true });
  }
}

/** Waits until every file of the build is kept and the page is served from there. @param {Opened} opened */
const kept = ({ until }) => until(() => navigator.serviceWorker.controller?.state === 'activated');

/** The script that the page began with. @param {Opened} opened */
const script = ({ page }) => page.locator('script[type=module]').first().getAttribute('src');

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'the_second_visit_needs_no_server_on_any_tab',
    (open) =>
      ownServer(open, async ({ visit, stop }) => {
        const opened = await visit();
        await kept(opened);
        stop();
        const { page, seek, inState, problems } = opened;
        await page.reload();
        await inState('paused');
        assert.match(await seek(40), /^[0-9a-f]{16}$/);
        const tabs = await page.locator('#top nav a').evaluateAll((links) => links.map((link) => link.getAttribute('href') ?? ''));
        for (const tab of [...tabs, '#/studies/success', '#/bench']) {
          await page.evaluate((hash) => void (location.hash = hash), tab);
          await inState('paused', 'finished', 'running', 'busy');
          assert.equal(await page.locator('.tab-missing').count(), 0, tab);
        }
        await page.evaluate(() => void (location.hash = '#/studies/success?size=paper'));
        await page.locator('.studies-source').filter({ hasText: 'results/success.csv' }).waitFor(); // a file that no visit has opened
        assert.deepEqual(problems.filter((problem) => !/Failed to load resource.*ERR_CONNECTION_REFUSED/.test(problem)), [], 'but for the look for a newer sw.js');
        return `${tabs.length} tabs`;
      }),
  ],
  [
    'a_newer_build_waits_for_the_visitor_and_then_takes_over_as_a_whole',
    (open) =>
      ownServer(open, async ({ visit, replace, temporary }) => {
        const next = join(temporary, 'next');
        nextBuild(next);
        const opened = await visit('#/forage?preset=foraging&seed=4');
        const { page, seek, at, inState, until } = opened;
        await kept(opened);
        const fingerprint = await seek(30);
        await opened.address(30);
        const before = await script(opened);
        replace(next);
        await page.reload();
        await page.locator('.update').filter({ hasText: 'A new version of this page is ready' }).waitFor();
        assert.match((await page.locator('#live').textContent()) ?? '', /new version/);
        // Until then everything is of the old build, also what is opened only now and has gone from the server.
        assert.equal(await script(opened), before);
        await page.getByRole('link', { name: 'Trees' }).click();
        await page.locator('#trees-fingerprint').filter({ hasText: /^[0-9a-f]{16}$/ }).waitFor();
        await page.goBack();
        await until(() => location.hash.startsWith('#/forage'));
        const asked = new Set();
        page.on('request', (request) => asked.add(request.url().replace(/^.*\//, '')));
        await page.locator('.update').getByRole('button', { name: 'Reload' }).click();
        await until((old) => document.querySelector('script[type=module]')?.getAttribute('src') !== old && document.body.dataset.state !== 'loading', before);
        await inState('paused');
        assert.equal(await at(30), fingerprint);
        const files = readdirSync(join(next, 'assets'));
        const strange = [...asked].filter((name) => HASHED.test(name) && !files.includes(name));
        assert.deepEqual(strange, [], 'nothing of the old build beside the new one');
        assert.ok([...asked].some((name) => name.endsWith('.wasm') && files.includes(name)), [...asked].join(' '));
        assert.equal(await page.locator('.update').count(), 0);
      }),
  ],
  [
    'another_window_is_told_when_a_newer_build_took_over',
    (open) =>
      ownServer(open, async ({ visit, replace, temporary, url }) => {
        const next = join(temporary, 'next');
        nextBuild(next);
        const opened = await visit();
        await kept(opened);
        const other = await opened.page.context().newPage();
        await other.goto(url);
        await other.waitForFunction(() => document.body.dataset.state === 'paused');
        replace(next);
        await opened.page.reload();
        await opened.page.locator('.update').getByRole('button', { name: 'Reload' }).click();
        await other.locator('.update').filter({ hasText: 'in another window' }).waitFor();
        await other.locator('.update').getByRole('button', { name: 'Reload' }).click();
        await other.waitForFunction(() => document.querySelector('script[type=module]')?.getAttribute('src')?.includes('/index-x') || document.querySelector('script[type=module]')?.getAttribute('src')?.includes('/index-y'));
      }),
  ],
  [
    'an_embedded_page_keeps_nothing_for_later',
    (open) =>
      ownServer(open, async ({ visit }) => {
        const { page, at } = await visit('#/forage?preset=foraging&seed=4&embed=1');
        await at(0);
        assert.deepEqual(await page.evaluate(async () => [(await navigator.serviceWorker.getRegistrations()).length, (await caches.keys()).length]), [0, 0]);
      }),
  ],
  [
    'every_file_of_the_build_is_kept_and_no_address_beside_it',
    async () => {
      const worker = readFileSync(join(dist, 'sw.js'), 'utf8');
      const listed = [...worker.matchAll(/url:.([^`"']+)[`"'],revision:/g)].map(([, url]) => url.replace(/^.*\//, ''));
      const files = readdirSync(dist, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile() && entry.name !== 'sw.js');
      const missing = files.filter(({ name }) => !listed.includes(name)).map(({ name }) => name);
      assert.deepEqual(missing, [], 'files that sw.js does not keep');
      assert.doesNotMatch(worker, /NavigationRoute/, 'older versions below the page are not answered with this one');
      const loose = files.filter(({ name }) => name !== 'index.html' && !HASHED.test(name)).map(({ name }) => name);
      assert.deepEqual(loose, [], 'a name that stays the same could be of another build than the rest');
      return `${files.length} files`;
    },
  ],
];
