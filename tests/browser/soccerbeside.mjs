import assert from 'node:assert/strict';
import { eventually } from './browser.mjs';
import { SHORT, openSoccer } from './pitch.mjs';

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'soccer_two_coaches_play_one_seed_side_by_side',
    async (open) => {
      const { page, whole, seek, until, problems } = await openSoccer(open, '#/soccer?preset=match&seed=3&soccer.half-seconds=60');
      await whole();
      await page.getByRole('button', { name: 'A | B' }).click();
      const said = page.locator('#soccer-compare');
      await said.filter({ hasText: /^(Identical until \d+:\d\d\.\d\.|Both matches are the same in every frame\.) At full time A ends \d+ : \d+ and B \d+ : \d+\.$/ }).waitFor();
      await eventually(async () => assert.equal(await page.locator('#soccer .soccer-side').count(), 2));
      await seek(1000);
      await page.locator('#soccer .side-said').first().filter({ hasText: /^A: \d+ : \d+/ }).waitFor();
      await eventually(async () => assert.equal(await page.locator('#soccer-other').inputValue(), 'machine'));
      await page.locator('#soccer-other').selectOption('tree');
      await said.filter({ hasText: 'Both matches are the same in every frame.' }).waitFor();
      await page.locator('#soccer .play').click();
      await until(() => Number(/** @type {HTMLInputElement} */ (document.querySelector('#soccer-scrub')).value) > 1010);
      await page.locator('#soccer .play').click();
      await page.getByRole('button', { name: 'A | B' }).click();
      await eventually(async () => assert.equal(await page.locator('#soccer .soccer-side').count(), 0));
      await page.locator('#soccer .pitch-stage.own canvas').waitFor();
      assert.deepEqual(problems, []);
    },
  ],
  [
    'soccer_a_and_b_are_part_of_the_link_and_reopened_by_it',
    async (open) => {
      const first = await openSoccer(open);
      await first.whole();
      await first.page.getByRole('button', { name: 'A | B' }).click();
      await first.page.locator('#soccer-other').selectOption('chase');
      await first.until(() => location.hash.includes('&b.soccer.blue=chase'));
      const said = await first.page.locator('#soccer-compare').filter({ hasText: 'At full time' }).textContent();
      const again = await openSoccer(open, await first.hash());
      await again.page.locator('#soccer-compare').filter({ hasText: said ?? '' }).waitFor();
      await eventually(async () => assert.equal(await again.page.locator('#soccer-other').inputValue(), 'chase'));
      await again.until(() => location.hash.includes('&b.soccer.blue=chase'));
      await again.page.getByRole('button', { name: 'A | B' }).click();
      await again.until(() => !location.hash.includes('b.soccer'));
      await again.page.evaluate(() => (location.hash = location.hash.replace('&t=', '&b.soccer.blue=formation&t=').replace(/&f=.*/, '&b.soccer.blue=formation')));
      await eventually(async () => assert.equal(await again.page.locator('#soccer-other').inputValue(), 'formation'));
      await again.page.evaluate(() => (location.hash = '#/soccer?preset=match&seed=4&soccer.half-seconds=20'));
      await eventually(async () => assert.equal(await again.page.locator('#soccer .soccer-side').count(), 0));
      const bad = await openSoccer(open, `${SHORT}&b.soccer.blue=wizard&b.soccer.seed=3`);
      await bad.notice(/'b\.soccer\.blue' was left out: found 'wizard', expected one of /);
      await bad.notice(/The link holds 'b\.soccer\.seed'/);
      await bad.whole();
      assert.equal(await bad.page.locator('#soccer .soccer-side').count(), 0);
      assert.deepEqual(first.problems.concat(again.problems, bad.problems), []);
    },
  ],
  [
    'soccer_tournament_fills_its_table_and_its_sums_agree',
    async (open) => {
      const { page, whole, until, problems } = await openSoccer(open);
      await whole();
      await page.getByRole('button', { name: 'Tournament' }).click();
      for (const name of ['tree without swaps', 'machine without swaps', 'tree, margins doubled', 'fixed formation']) await page.getByLabel(name, { exact: true }).uncheck();
      await page.locator('#soccer-half').fill('5');
      await page.locator('#soccer-half').press('Enter');
      await page.locator('#soccer-rounds').fill('2');
      await page.locator('#soccer-rounds').press('Enter');
      await page.locator('#soccer-workers').fill('2');
      await page.locator('#soccer-progress').filter({ hasText: '0 of 6 games' }).waitFor();
      await page.locator('#soccer-tournament-start').click();
      await until(() => document.querySelector('#soccer .tournament')?.getAttribute('data-played') === '6');
      const rows = await page.locator('#soccer-standings tbody tr').evaluateAll((list) => list.map((row) => [...row.querySelectorAll('td')].map((cell) => Number((cell.textContent ?? '').replace('−', '-')))));
      assert.equal(rows.length, 3);
      for (const [points, played, won, tied, lost, scored, conceded, difference] of rows) {
        assert.equal(played, 4);
        assert.equal(won + tied + lost, played);
        assert.equal(points, 3 * won + tied);
        assert.equal(difference, scored - conceded);
      }
      assert.ok(rows.every(([points], at) => at === 0 || points <= rows[at - 1][0]), 'in order');
      assert.equal(rows.reduce((sum, row) => sum + row[5], 0), rows.reduce((sum, row) => sum + row[6], 0));
      await page.locator('#soccer-sums').filter({ hasText: 'Goals scored and conceded agree' }).waitFor();
      await page.locator('#soccer .faulty').filter({ hasText: 'goals scored sum to 227, goals conceded to 196, so the differences sum to +31' }).waitFor();
      await page.locator('#soccer .games button').first().click();
      await page.locator('#soccer .pitch-stage.own canvas').waitFor();
      await until(() => location.hash.includes('half-seconds=5'));
      assert.deepEqual(problems, []);
    },
  ],
  [
    'soccer_tournament_pauses_and_needs_two_teams',
    async (open) => {
      const { page, whole, until } = await openSoccer(open);
      await whole();
      await page.getByRole('button', { name: 'Tournament' }).click();
      await page.locator('#soccer-progress').filter({ hasText: '0 of 21 games' }).waitFor();
      await page.locator('#soccer-tournament-start').click();
      await until(() => Number(document.querySelector('#soccer .tournament')?.getAttribute('data-played')) >= 1);
      await page.locator('#soccer-tournament-start').filter({ hasText: 'Pause' }).click();
      await page.locator('#soccer-tournament-start').filter({ hasText: 'Go on' }).waitFor();
      const stood = await page.locator('#soccer .tournament').getAttribute('data-played');
      await page.waitForTimeout(1500);
      assert.equal(await page.locator('#soccer .tournament').getAttribute('data-played'), stood);
      for (const box of await page.locator('#soccer .tournament fieldset input').all()) await box.uncheck();
      await page.getByText('Choose at least two teams.').waitFor();
      assert.ok(await page.locator('#soccer-tournament-start').isDisabled());
    },
  ],
];
