// Visits after the first, without the network and after a newer build came out.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { HASHED, dist, kept, nextBuild, ownServer, script } from './builds.mjs';

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
