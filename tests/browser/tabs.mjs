import assert from 'node:assert/strict';
import { eventually } from './browser.mjs';

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'tabs_are_links_that_change_title_state_and_history',
    async (open) => {
      const { page, at, inState, until, problems } = await open('', { reducedMotion: 'no-preference' });
      await inState('running');
      await eventually(async () => assert.equal(await page.title(), 'Forage · Swarm playground'));
      await page.getByRole('link', { name: 'Trees' }).click();
      await page.locator('#trees-fingerprint').filter({ hasText: /^[0-9a-f]{16}$/ }).waitFor();
      await inState('paused');
      await eventually(async () => assert.equal(await page.title(), 'Trees · Swarm playground'));
      await eventually(async () => assert.equal(await page.locator('nav [aria-current=page]').textContent(), 'Trees'));
      await eventually(async () => assert.equal(await page.locator('#world').isVisible(), false));
      await until(() => location.hash.startsWith('#/trees?v='));
      await page.goBack();
      await inState('paused'); // it was paused when it was left
      await until(() => location.hash.startsWith('#/forage?v='));
      await at(Number(await page.locator('#tick').textContent()));
      await eventually(async () => assert.equal(await page.locator('.trees-frame').isVisible(), false));
      await page.goForward();
      await until(() => location.hash.startsWith('#/trees?v='));
      await eventually(async () => assert.ok(await page.locator('.trees-frame').isVisible()));
      assert.deepEqual(problems, []);
    },
  ],
  [
    'a_tab_that_is_left_keeps_its_state_and_finds_its_address_again',
    async (open) => {
      const { page, seek, at, address, until } = await open('#/forage?preset=foraging&seed=3');
      const fingerprint = await seek(70);
      const before = await address(70);
      await page.getByRole('link', { name: 'Trees' }).click();
      await until(() => location.hash.startsWith('#/trees?v='));
      await page.locator('#trees [data-action=forward]').click();
      await until(() => document.querySelector('#trees-tick')?.textContent === '3' && location.hash.includes('t=3'));
      const trees = await page.evaluate(() => location.hash);
      await page.getByRole('link', { name: 'Forage' }).click();
      await until((wanted) => location.hash === wanted, before);
      assert.equal(await at(70), fingerprint);
      await page.getByRole('link', { name: 'Trees' }).click();
      await until((wanted) => location.hash === wanted, trees);
      await eventually(async () => assert.equal(await page.locator('#trees-tick').textContent(), '3'));
    },
  ],
  [
    'an_address_of_trees_starts_no_swarm_and_an_unknown_one_is_named',
    async (open) => {
      const { page } = await open('#/trees');
      assert.equal(page.workers().length, 1);
      assert.equal(await page.locator('#preset').count(), 0);
      const other = await open('#/nowhere');
      await other.notice(/The link asks for 'nowhere'/);
      await other.inState('paused');
      const names = await other.page.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name).filter((name) => /trees/.test(name)));
      assert.deepEqual(names, [], 'the workbench is loaded with its tab only');
    },
  ],
  [
    'number_keys_choose_tabs_and_the_list_shows_the_keys_of_the_open_tab',
    async (open) => {
      const { page, inState, until } = await open();
      await inState('paused');
      const keys = async () => {
        await page.keyboard.press('?');
        await page.locator('.keys-dialog[open]').waitFor();
        const rows = await page.locator('.keys-dialog tbody td').allTextContents();
        await page.keyboard.press('Escape');
        await page.locator('.keys-dialog').waitFor({ state: 'hidden' }); // the browser closes it a moment later
        return rows.join('\n');
      };
      assert.match(await keys(), /restart with a new seed/);
      await page.keyboard.press('4');
      await until(() => location.hash.startsWith('#/trees?v='));
      const shown = await keys();
      assert.doesNotMatch(shown, /new seed|codon/);
      assert.match(shown, /find a node/);
      const before = Number(await page.locator('#trees-tick').textContent());
      await page.keyboard.press('.');
      await until((wanted) => document.querySelector('#trees-tick')?.textContent === String(wanted), before + 1);
      await page.keyboard.press('1');
      await until(() => location.hash.startsWith('#/forage?v='));
      await page.keyboard.press('.');
      await until(() => document.querySelector('#tick')?.textContent === '1');
    },
  ],
];
