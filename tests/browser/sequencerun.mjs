import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { eventually } from './browser.mjs';
import { SMALL, openPlan } from './plan.mjs';

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'sequence_opens_with_a_plan_that_improves_with_its_proof',
    async (open) => {
      const { page, planned, verdict, tab, fact, until, result, letters } = await openPlan(open);
      await planned();
      assert.match(await verdict(), /The best plan so far costs \d+ m, at most \d\.\d{3} times the least: none costs less than \d+ m\./);
      assert.match(await letters(), /^[FENWSRAXY.]{15}$/);
      await tab('search');
      const ratio = Number(await fact('ratio'));
      await until((before) => Number(document.querySelector('#panel-sequence-search [data-fact=ratio]')?.textContent) < before, ratio);
      assert.ok(Number(await fact('integrated')) > 0);
      await page.locator('#panel-sequence-search .numbers summary').click();
      await page.locator('#panel-sequence-search .numbers tbody tr').first().waitFor();
      await tab('plan');
      await page.locator('#sequence-more').click();
      await result('cancelled');
      assert.match(await verdict(), /^Stopped\. The best plan so far/);
      await page.locator('#sequence-more').filter({ hasText: 'Continue with' }).click();
      await result('searching');
      const names = await page.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name).filter((name) => /trees|studies/.test(name)));
      assert.deepEqual(names, [], 'other tabs are not loaded');
    },
  ],
  [
    'sequence_search_is_loaded_with_its_tab_only',
    async (open) => {
      const { page } = await open('#/forage');
      const names = await page.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name).filter((name) => /sequence/.test(name)));
      assert.deepEqual(names, []);
    },
  ],
  [
    'sequence_results_are_kept_apart',
    async (open) => {
      const { page, result, verdict, until } = await openPlan(open, SMALL);
      await result('optimal');
      assert.match(await verdict(), /^Proved optimal: \d+(\.\d)? m, and no plan costs less\./);
      await page.locator('#sequence-preset').selectOption('plan-walled');
      await result('infeasible');
      assert.match(await verdict(), /^Proved infeasible: there is no plan\. Every sequence was tried or ruled out, with \d+ integrations?\./);
      assert.equal(await page.locator('#sequence .plan-cell').count(), 0);
      await page.locator('#sequence-preset').selectOption('plan-live');
      await until(() => location.hash.includes('plan-live')); // before it is opened, it would take the budget back
      await page.locator('[id="control-sequencing.budget"]').fill('30');
      await page.locator('[id="control-sequencing.budget"]').press('Enter');
      await result('gave-up');
      assert.match(await verdict(), /^Gave up at the budget of integrations\. /);
      await page.locator('#sequence-more').filter({ hasText: 'Continue with 30 more' }).click();
      await until(() => /Gave up/.test(document.querySelector('#sequence-verdict')?.textContent ?? ''));
    },
  ],
  [
    'sequence_first_plan_after_a_drag_comes_soon',
    async (open) => {
      const { page, planned, drag } = await openPlan(open);
      await planned();
      for (let round = 0; round < 4; round += 1) {
        const drop = await drag('target-0', round % 2 === 0 ? -60 : 60, round % 2 === 0 ? 40 : -40, 1);
        for (let wait = 0; wait < 4; wait += 1) {
          await page.waitForTimeout(120);
          await page.mouse.move(700 + 8 * wait + round, 330 - 6 * wait);
        }
        await page.waitForTimeout(200);
        await drop();
        await planned();
      }
      const times = await page.evaluate(() => performance.getEntriesByName('first plan').map((entry) => ({ whole: entry.duration, search: /** @type {PerformanceMeasure} */ (entry).detail })));
      assert.ok(times.length >= 8, `${times.length} placements were measured`);
      const median = (/** @type {number[]} */ list) => list.toSorted((a, b) => a - b)[Math.floor(list.length / 2)].toFixed(0);
      return `first plan after ${median(times.map(({ whole }) => whole))} ms at the median of ${times.length} placements, of which ${median(times.map(({ search }) => search))} ms are the search`;
    },
    'alone',
  ],
  [
    'sequence_plan_is_scrubbed_stepped_and_played',
    async (open) => {
      const { page, result, inState, until } = await openPlan(open, SMALL);
      await result('optimal');
      const seconds = async () => Number.parseFloat((await page.locator('#sequence-time').textContent()) ?? '');
      const press = (/** @type {string} */ name) => page.getByRole('button', { name, exact: true }).click();
      await press('0.1 s forward');
      await eventually(async () => assert.equal(await seconds(), 0.1));
      await press('One interval forward');
      await eventually(async () => assert.equal(await seconds(), 10));
      await press('0.1 s back');
      await eventually(async () => assert.equal(await seconds(), 9.9));
      await press('One interval back');
      await eventually(async () => assert.equal(await seconds(), 0));
      await page.locator('#sequence-scrub').fill('123');
      await eventually(async () => assert.equal(await seconds(), 12.3));
      await page.locator('#sequence .play').click();
      await inState('running');
      await until(() => Number.parseFloat(document.querySelector('#sequence-time')?.textContent ?? '') > 13);
      await page.locator('#sequence .play').click();
      await inState('finished');
      await eventually(async () => assert.ok((await seconds()) > 13));
      await page.locator('#sequence .plan-cell').nth(2).click();
      await eventually(async () => assert.equal(await seconds(), 20));
      await until(() => location.hash.endsWith('&t=200'));
    },
  ],
  [
    'sequence_plan_is_edited_by_hand_and_kept_in_part',
    async (open) => {
      const { page, planned, letters, result, until, hash } = await openPlan(open, '#/sequence?preset=navigation');
      await result('solved', 'optimal');
      await planned();
      const before = await letters();
      await page.locator('#sequence .plan-cell').nth(1).click();
      await page.locator('#sequence-behaviour').selectOption('W');
      const said = page.locator('#sequence-hand');
      await said.filter({ hasText: 'Your plan' }).waitFor();
      const text = (await said.textContent()) ?? '';
      assert.match(text, /^Your plan (fails: in .*, robot \d+ (leaves the map|hits obstacle \d+) after \d+\.\d s\.|costs .* and does not reach the goal\.|reaches the goal for .*)$/);
      await eventually(async () => assert.equal((await letters()).charAt(1), 'W'));
      await until(() => location.hash.includes('&plan='));
      const link = await hash();
      await page.locator('#sequence-back').click();
      await until(() => !location.hash.includes('&plan='));
      await eventually(async () => assert.equal(await letters(), before));
      await page.keyboard.press('Control+z');
      await until(() => location.hash.includes('&plan='));
      await page.locator('#sequence-back').click();
      await page.locator('#sequence .plan-cell').nth(0).click();
      const other = before.startsWith('N') ? 'E' : 'N';
      await page.locator('#sequence-behaviour').selectOption(other);
      await page.locator('#sequence-lock').click();
      await until(() => location.hash.includes('sequencing.prefix='));
      await planned();
      assert.ok((await letters()).startsWith(other), 'the rest is planned after what was kept');
      await eventually(async () => assert.equal(await page.locator('#sequence .plan-cell.locked').count(), 1));
      await page.locator('#sequence-lock').filter({ hasText: 'Keep none' }).click();
      await until(() => !location.hash.includes('sequencing.prefix='));
      const again = await openPlan(open, link);
      await again.page.locator('#sequence-hand').filter({ hasText: 'Your plan' }).waitFor();
      await eventually(async () => assert.equal((await again.letters()).charAt(1), 'W'));
    },
  ],
  [
    'sequence_robustness_is_drawn_as_a_fan_and_said',
    async (open) => {
      const { page, result, problems } = await openPlan(open, SMALL);
      await result('optimal');
      await page.locator('#sequence-jitter').selectOption('0.1');
      await page.locator('#sequence-robust').click();
      const said = page.locator('#sequence-robust-said');
      await said.filter({ hasText: 'of 50 still succeed when every robot starts 10 cm elsewhere' }).waitFor();
      assert.deepEqual(problems, []);
    },
  ],
  [
    'sequence_a_and_b_search_the_same_layout_in_two_ways',
    async (open) => {
      const { page, result, until } = await openPlan(open, SMALL);
      await result('optimal');
      await page.getByRole('button', { name: 'A | B' }).click();
      const said = page.locator('#sequence-compare');
      await said.filter({ hasText: /^A: \d+ m after \d+ integrations\. B: \d+ m after \d+ integrations\.$/ }).waitFor();
      const count = async (/** @type {string} */ side) => Number(await page.locator(`#sequence [data-side=${side}] [data-fact=integrated]`).textContent());
      assert.ok((await count('a')) >= (await count('b')), 'word by word needs more integrations');
      await page.locator('#sequence-pair').selectOption('weight');
      await said.filter({ hasText: 'Both search' }).or(said.filter({ hasText: /^A:/ })).first().waitFor();
      await until(() => /Weight 2/.test(document.querySelector('#sequence [data-side=a] h3')?.textContent ?? ''));
      await said.filter({ hasText: /^A: \d+ m/ }).waitFor();
      assert.equal(page.workers().length, 3);
      await page.getByRole('button', { name: 'A | B' }).click();
      await page.locator('#sequence .ribbon').waitFor();
      assert.equal(page.workers().length, 1);
    },
  ],
  [
    'sequence_a_and_b_are_part_of_the_link_and_reopened_by_it',
    async (open) => {
      const first = await openPlan(open, SMALL);
      await first.result('optimal');
      await first.page.getByRole('button', { name: 'A | B' }).click();
      await first.page.locator('#sequence-pair').selectOption('weight');
      await first.until(() => location.hash.includes('&b=weight'));
      const said = await first.page.locator('#sequence-compare').filter({ hasText: /^A:/ }).textContent();
      const again = await openPlan(open, await first.hash());
      await again.page.locator('#sequence-compare').filter({ hasText: said ?? '' }).waitFor();
      await eventually(async () => assert.equal(await again.page.locator('#sequence-pair').inputValue(), 'weight'));
      await again.page.getByRole('button', { name: 'A | B' }).click();
      await again.until(() => !location.hash.includes('b=weight'));
      const bad = await openPlan(open, `${SMALL}&b=colour`);
      await bad.notice(/'b' was left out: found 'colour', expected one of literal, weight, geodesic/);
      await bad.result('optimal');
      assert.equal(await bad.page.locator('#sequence .sequence-side').count(), 0);
      assert.deepEqual(first.problems.concat(again.problems, bad.problems), []);
    },
  ],
  [
    'sequence_game_hides_the_search_and_ends_with_the_proof',
    async (open) => {
      const { page, result, tab, until } = await openPlan(open, SMALL);
      await result('optimal');
      await tab('game');
      await page.locator('#sequence-pace').selectOption('0');
      await page.locator('#sequence-game-begin').click();
      await page.locator('#sequence .ribbon').waitFor({ state: 'hidden' });
      await page.locator('#sequence-verdict').filter({ hasText: 'Your turn' }).waitFor();
      for (let choices = 0; choices < 5; choices += 1) {
        if (await page.locator('#sequence-game-result').filter({ hasText: /./ }).count()) break;
        await page.locator(`.game-keys [data-letter=${'ENENR'[choices]}]`).click();
        await until((made) => document.querySelector('#sequence-game-result')?.textContent || new RegExp(`^${made} of 5.*Choose the next`).test(document.querySelector('.game-said')?.textContent ?? ''), choices + 1);
      }
      const ended = (await page.locator('#sequence-game-result').textContent()) ?? '';
      assert.match(ended, /^(You reached the goal for|The goal was not reached|Collided after)/);
      await eventually(async () => assert.match((await page.locator('#sequence-game-planner').textContent()) ?? '', /The planner's best so far costs .* No plan costs less than/));
      await page.getByRole('button', { name: 'Show the plan' }).click();
      await page.locator('#sequence .ribbon').waitFor();
      if (ended.startsWith('You reached')) {
        await page.reload();
        await result('optimal');
        await tab('game');
        await page.locator('#panel-sequence-game').filter({ hasText: 'Your best here' }).waitFor();
      }
      return ended;
    },
  ],
  [
    'sequence_search_rests_while_another_tab_is_open',
    async (open) => {
      const { page, planned, verdict, until } = await openPlan(open);
      await planned();
      await page.keyboard.press('4');
      await until(() => location.hash.startsWith('#/trees'));
      const resting = await verdict();
      assert.match(resting, /^The search rests\. /);
      await page.waitForTimeout(200);
      assert.equal(await verdict(), resting);
      await page.keyboard.press('2');
      await until(() => location.hash.startsWith('#/sequence') && /^Searching\. /.test(document.querySelector('#sequence-verdict')?.textContent ?? ''));
    },
  ],
  [
    'broken_sequence_engine_is_replaced_and_plans_again',
    async (open) => {
      const { page, result, letters, until } = await openPlan(open, SMALL);
      await result('optimal');
      const before = await letters();
      await page.workers()[0].evaluate(() => self.postMessage({ id: 0, type: 'error', fatal: true, message: 'panicked at a test' }));
      await page.locator('#sequence .fault').filter({ hasText: 'panicked at a test' }).waitFor();
      await page.getByRole('button', { name: 'Plan again' }).click();
      await until(() => document.body.dataset.state === 'finished');
      await result('optimal');
      await eventually(async () => assert.equal(await letters(), before));
      await page.locator('#sequence-thing').selectOption('target-0');
      await page.locator('#sequence-x').fill('-12');
      await page.locator('#sequence-x').press('Enter');
      await until(() => location.hash.includes('target-x=-12'));
    },
  ],
  [
    'sequence_files_leave_and_come_back',
    async (open) => {
      const { page, result, letters, notice } = await openPlan(open, SMALL);
      await result('optimal');
      const saved = async (/** @type {string} */ name) => {
        const [download] = await Promise.all([page.waitForEvent('download'), page.locator('#sequence .take').getByRole('button', { name, exact: true }).click()]);
        return readFileSync(await download.path());
      };
      const plan = JSON.parse((await saved('Plan')).toString()).plan;
      assert.equal(plan.letters, await letters());
      assert.equal(plan.proven_ratio, 1);
      assert.ok(Math.abs(plan.costs.reduce((/** @type {number} */ sum, /** @type {number} */ cost) => sum + cost, 0) - plan.total) < 1e-9);
      const rows = (await saved('CSV')).toString().trim().split('\n');
      assert.equal(rows[0], 'seconds,interval,behaviour,robot,x,y,heading');
      assert.equal(rows.length, 1 + 501 * 3);
      assert.match((await saved('SVG')).toString(), /^<svg .*<\/svg>$/s);
      assert.deepEqual([...(await saved('PNG')).subarray(1, 4)].map((code) => String.fromCharCode(code)).join(''), 'PNG');
      const scenario = await saved('JSON');
      assert.equal(JSON.parse(scenario.toString()).world, 'sequencing');
      await page.locator('#sequence-preset').selectOption('coverage');
      await result('searching', 'solved');
      await page.locator('#sequence-file').setInputFiles({ name: 'mine.json', mimeType: 'application/json', buffer: scenario });
      await notice(/Opened mine\.json/);
      await result('optimal');
      assert.equal(await letters(), plan.letters);
      await page.locator('#sequence-file').setInputFiles({ name: 'other.json', mimeType: 'application/json', buffer: Buffer.from('{"world": "geese"}') });
      await notice(/other\.json was refused, and the last plan stays: it is of the world 'geese', expected 'sequencing'\./);
    },
  ],
];
