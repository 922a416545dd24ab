import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { eventually } from './browser.mjs';

/** Written by the engine's own tests: the same values hold natively, under Node and here. */
const golden = () => JSON.parse(readFileSync(new URL('../cases/golden.json', import.meta.url), 'utf8'));

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'fingerprint_in_the_page_equals_the_command_line',
    async (open) => {
      const { cases: rows } = golden();
      assert.ok(rows.length > 0, 'tests/cases/golden.json holds no cases');
      const { page, at } = await open();
      for (const { scenario, seed, tick, fingerprint } of rows) {
        await page.evaluate((hash) => void (location.hash = hash), `#/forage?preset=${scenario}&seed=${seed}&t=${tick}`);
        await eventually(async () => assert.equal(await at(tick), fingerprint, `${scenario}, seed ${seed}, tick ${tick}`));
      }
      return `${rows.length} cases`;
    },
  ],
  [
    'seek_in_random_order_equals_the_straight_run',
    async (open) => {
      const { seek, page } = await open();
      const straight = new Map();
      const ticks = [0, 1, 63, 64, 65, 100, 129, 250, 333, 401];
      for (const tick of ticks) straight.set(tick, await seek(tick));
      assert.equal(new Set(straight.values()).size, ticks.length);
      for (const tick of [333, 64, 401, 1, 250, 129, 0, 65, 100, 63]) assert.equal(await seek(tick), straight.get(tick), `tick ${tick}`);
      assert.equal(await page.locator('.notice.problem').count(), 0);
    },
  ],
  [
    'playing_gives_the_same_fingerprint_as_seeking',
    async (open) => {
      const { page, at, rest, seek, until } = await open();
      await page.locator('#max').check();
      await page.locator('#play').click();
      await until(() => Number(document.querySelector('#tick')?.textContent) > 150);
      await page.locator('#play').click();
      const reached = await rest();
      const played = await at(reached);
      await seek(0);
      assert.equal(await seek(reached), played);
    },
  ],
  [
    'long_seek_shows_progress_and_can_be_cancelled',
    async (open) => {
      const { page, inState, tick } = await open();
      await page.locator('#scrub').evaluate((scrub) => {
        /** @type {HTMLInputElement} */ (scrub).value = '12000';
        scrub.dispatchEvent(new Event('input'));
      });
      await inState('busy');
      await eventually(async () => assert.match((await page.locator('#progress').textContent()) ?? '', /Computing tick \d+ of 12000/));
      await page.locator('.busy button').click();
      await inState('paused');
      assert.ok((await tick()) < 12000);
    },
  ],
];
