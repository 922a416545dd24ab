import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { eventually } from './browser.mjs';
import { SHORT, openSoccer } from './pitch.mjs';

/** @param {import('playwright-core').Page} page @param {string} name */
async function saved(page, name) {
  const download = page.waitForEvent('download');
  await page.locator('#soccer .foot').getByRole('button', { name, exact: true }).click();
  return readFileSync(await (await download).path(), 'utf8');
}

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'soccer_match_is_computed_ahead_and_gone_through_freely',
    async (open) => {
      const { page, whole, seek, inState, until, problems } = await openSoccer(open, '#/soccer');
      const start = Date.now();
      const fingerprint = await whole();
      const took = Date.now() - start;
      assert.match(fingerprint, /^[0-9a-f]{16}$/);
      await eventually(async () => assert.equal(await page.locator('#soccer-scrub').getAttribute('max'), '36000', 'ten minutes'));
      await seek(18_060);
      await eventually(async () => assert.equal(await page.locator('#soccer-clock').textContent(), '5:01.0'));
      await eventually(async () => assert.equal(await page.locator('#soccer-time').textContent(), '0:01 second half'));
      const goals = await page.locator('#soccer .marks .goal-mark').count();
      await seek(36_000);
      await inState('finished');
      const score = [await page.locator('#soccer-goals-blue').textContent(), await page.locator('#soccer-goals-yellow').textContent()].map(Number);
      assert.equal(score[0] + score[1], goals, 'a mark for every goal');
      await eventually(async () => assert.match((await page.locator('#soccer-tag').textContent()) ?? '', /^Finished: full time, /));
      await until(() => location.hash.includes('t=36000&f='));
      assert.deepEqual(problems, []);
      return `ten minutes computed and shown ${took} ms after the page was there`;
    },
    'alone',
  ],
  [
    'soccer_engine_is_loaded_with_its_tab_only',
    async (open) => {
      const { page } = await open('#/forage');
      const names = await page.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name).filter((name) => /soccer/.test(name)));
      assert.deepEqual(names, []);
    },
  ],
  [
    'soccer_link_holds_match_moment_and_fingerprint',
    async (open) => {
      const first = await openSoccer(open);
      const fingerprint = await first.whole();
      await first.seek(700);
      await first.until(() => location.hash.includes('t=700&f='));
      const hash = await first.hash();
      const again = await openSoccer(open, hash);
      await again.notice(/The whole match was played and its fingerprint matches/);
      assert.equal(await again.whole(), fingerprint);
      await eventually(async () => assert.equal(await again.tick(), 700));
      const wrong = await openSoccer(open, `${hash.replace(/f=[0-9a-f]{16}/, 'f=0123456789abcdef')}&nonsense=1`);
      await wrong.notice(/The fingerprint of the whole match does not match: expected 0123456789abcdef/);
      await wrong.notice(/The link holds 'nonsense'/);
    },
  ],
  [
    'soccer_is_played_paused_and_stepped_by_keys',
    async (open) => {
      const { page, whole, inState, until, tick, seek } = await openSoccer(open);
      await whole();
      await page.keyboard.press(' ');
      await inState('running');
      await until(() => Number(/** @type {HTMLInputElement} */ (document.querySelector('#soccer-scrub')).value) > 20);
      await page.keyboard.press(' ');
      await inState('paused');
      await seek(100);
      await page.keyboard.press('.');
      await eventually(async () => assert.equal(await tick(), 101));
      await page.keyboard.press(',');
      await eventually(async () => assert.equal(await tick(), 100));
      await page.keyboard.press('>');
      await eventually(async () => assert.ok((await tick()) > 100, 'to the next call'));
      await eventually(async () => assert.match((await page.locator('#soccer-call').textContent()) ?? '', /^(Goal|Free ball|Penalty kick|Goal kick|Kick-off|Full time).* because /));
      await page.keyboard.press('r');
      await eventually(async () => assert.equal(await tick(), 0));
    },
  ],
  [
    'soccer_waits_of_the_referee_are_shown_when_they_are_wanted',
    async (open) => {
      const { page, whole, seek, tick } = await openSoccer(open);
      await whole();
      await page.getByLabel("Show the referee's waits").check();
      await seek(0);
      await page.locator('#soccer .play').click();
      await page.waitForTimeout(1200);
      assert.equal(await tick(), 0, 'the kick-off waits for eight seconds');
      await page.getByLabel("Show the referee's waits").uncheck();
      await page.waitForFunction(() => Number(/** @type {HTMLInputElement} */ (document.querySelector('#soccer-scrub')).value) > 5);
    },
  ],
  [
    'soccer_inspector_shows_tree_machine_roles_structure_log_and_charts',
    async (open) => {
      const { page, whole, seek, tab, team, until, tick, problems } = await openSoccer(open);
      await whole();
      await seek(300);
      await page.locator('#soccer .tree [data-status=SUCCESS]').first().waitFor();
      await page.locator('#soccer .tree .node').filter({ hasText: 'RolesSwapperInitializer' }).first().waitFor();
      await team('Yellow');
      await page.locator('#soccer .statechart .state.now').waitFor();
      await eventually(async () => assert.equal(await page.locator('#soccer .statechart .state').count(), 8));
      await eventually(async () => assert.equal(await page.locator('#soccer .statechart .way').count(), 11));
      await page.locator('#soccer .guards tbody tr').first().waitFor();
      await tab('roles');
      await eventually(async () => assert.equal(await page.locator('#soccer .who tbody tr').count(), 3));
      await page.locator('#soccer .role-line .role-box').first().waitFor();
      await page.locator('#panel-soccer-roles').getByRole('button', { name: 'Yellow 2' }).click();
      await page.locator('#panel-soccer-roles h2').filter({ hasText: 'played by Yellow 2' }).waitFor();
      await page.locator('#panel-soccer-roles .tree .node').first().waitFor();
      await tab('organisation');
      await page.locator('#soccer .violations').filter({ hasText: 'No change broke the organisation' }).waitFor();
      await eventually(async () => assert.equal(await page.locator('#soccer .org-role').count(), 8));
      await eventually(async () => assert.equal(await page.locator('#soccer .org-role.held').count(), 3));
      await eventually(async () => assert.equal(await page.locator('#soccer .org-group.active').count(), 1));
      await tab('log');
      const line = page.locator('#soccer .log tbody tr').last();
      const [minutes, seconds] = ((await line.locator('button').textContent()) ?? '').split(':').map(Number);
      await line.locator('button').click();
      await eventually(async () => assert.ok(Math.abs((await tick()) / 60 - 60 * minutes - seconds) < 0.1, 'the line leads to its moment'));
      await page.locator('#panel-soccer-log').getByRole('button', { name: 'Coaches' }).click();
      await page.locator('#soccer .log .deed').first().waitFor();
      await tab('charts');
      await eventually(async () => assert.equal(await page.locator('#panel-soccer-charts .uplot').count(), 4));
      await page.locator('#panel-soccer-charts .numbers summary').click();
      await page.locator('#panel-soccer-charts .numbers tbody tr').nth(1).waitFor();
      await until(() => document.querySelector('#soccer-summary')?.textContent?.startsWith('0:'));
      assert.deepEqual(problems, []);
    },
  ],
  [
    'soccer_inspector_shows_the_tree_as_it_answered_a_call',
    async (open) => {
      const { page, whole, seek } = await openSoccer(open);
      await whole();
      await seek(1);
      await page.locator('#panel-soccer-coach').getByText('At the call that led here').waitFor();
      const assigned = page.locator('#soccer .tree .node').filter({ hasText: 'AssignStartRoles' }).first();
      await eventually(async () => assert.equal(await assigned.getAttribute('data-status'), 'SUCCESS'));
    },
  ],
  [
    'soccer_controls_play_the_match_anew',
    async (open) => {
      const { page, whole, until, notice } = await openSoccer(open);
      const before = await whole();
      await page.locator('[id="control-soccer.yellow"]').selectOption('chase');
      await until((old) => document.querySelector('#soccer-fingerprint')?.getAttribute('data-whole') === 'true' && document.querySelector('#soccer-fingerprint')?.textContent !== old, before);
      await until(() => location.hash.includes('soccer.yellow=chase'));
      await eventually(async () => assert.match((await page.locator('#soccer-score').textContent()) ?? '', /two chasers/));
      await page.locator('#soccer-seed').fill('-1');
      await page.locator('#soccer-seed').press('Enter');
      await page.locator('#soccer-seed-error').filter({ hasText: 'expected a whole number' }).waitFor();
      await page.locator('[data-key="soccer.enter"]').evaluate((control) => control.closest('details')?.setAttribute('open', ''));
      await page.locator('[id="control-soccer.enter"]').fill('2');
      await page.locator('[id="control-soccer.enter"]').press('Enter');
      await until(() => location.hash.includes('soccer.enter=2'));
      const wrong = await openSoccer(open, `${SHORT}&soccer.blue=${encodeURIComponent('nobody')}`);
      await wrong.notice(/The link's 'soccer.blue' was left out/);
      void notice;
    },
  ],
  [
    'soccer_presets_all_open',
    async (open) => {
      const { page, whole, until } = await openSoccer(open);
      await whole();
      const names = readdirSync('scenarios').filter((name) => /^match.*\.json$/.test(name)).map((name) => name.replace('.json', ''));
      const listed = await page.locator('#soccer-preset option').evaluateAll((options) => options.map((option) => /** @type {HTMLOptionElement} */ (option).value));
      assert.deepEqual(listed.toSorted(), names.toSorted());
      for (const name of names) {
        await page.locator('#soccer-preset').selectOption(name);
        await until((wanted) => location.hash.includes(`preset=${wanted}&`) || location.hash.endsWith(`preset=${wanted}`), name);
        await whole();
      }
      const { page: forage } = await open('#/forage');
      const others = await forage.locator('#preset option').evaluateAll((options) => options.map((option) => /** @type {HTMLOptionElement} */ (option).value));
      assert.deepEqual(others.filter((name) => name.startsWith('match')), []);
    },
  ],
  [
    'soccer_log_and_poses_are_exported_and_a_log_plays_again',
    async (open) => {
      const { page, whole, notice, inState } = await openSoccer(open);
      const fingerprint = await whole();
      const log = JSON.parse(await saved(page, 'Log'));
      assert.equal(log.fingerprint, fingerprint);
      assert.equal(log.scenario.world, 'soccer');
      assert.ok(log.referee.length > 0 && log.coaches.length > 0 && log.referee[0].reason === 'the coin gave it the first kick-off');
      const lines = (await saved(page, 'Log CSV')).trim().split('\n');
      assert.equal(lines[0], 'tick,seconds,phase,seconds_in_phase,elapsed,who,team,what,quadrant,why');
      assert.equal(lines.length, 1 + log.referee.length + log.coaches.length);
      const poses = (await saved(page, 'Poses')).trim().split('\n');
      assert.equal(poses.length, 1 + 7 * 401, 'six robots and the ball, ten times a second for 40 s, both ends included');
      assert.match(await saved(page, 'SVG'), /^<svg .*tree \d+ : \d+ machine, seed 3/s);
      const scenario = JSON.parse(await saved(page, 'JSON'));
      assert.equal(scenario['half-seconds'], 20);
      await page.locator('[id="control-soccer.yellow"]').selectOption('formation');
      await inState('paused');
      await page.locator('#soccer-file').setInputFiles({ name: 'log.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(log)) });
      await notice(/fingerprint matches/);
      await page.locator('#soccer-file').setInputFiles({ name: 'geese.json', mimeType: 'application/json', buffer: Buffer.from('{"world": "geese"}') });
      await notice(/geese\.json was not opened: the file is of the world 'geese'/);
      const overlapping = { world: 'soccer', events: [{ tick: 0, key: 'soccer.arrangement', value: { ball: [0, 0], blue: [[-0.5, 0, 0], [-0.5, 0.01, 0], [-0.3, 0.3, 0]], yellow: [[0.5, 0, 0], [0.4, 0.3, 0], [0.4, -0.3, 0]] } }] };
      await page.locator('#soccer-file').setInputFiles({ name: 'overlap.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(overlapping)) });
      await notice(/overlap\.json was not opened: events\[0\]\.value: robot 1 of the left team: expected a place apart from robot 2/);
    },
  ],
  [
    'broken_soccer_engine_is_replaced_and_the_match_plays_again',
    async (open) => {
      const { page, whole, seek, tick, inState } = await openSoccer(open);
      const before = await whole();
      await seek(300);
      await page.workers()[0].evaluate(() => self.postMessage({ id: 0, type: 'error', fatal: true, message: 'panicked at a test' }));
      await page.locator('#soccer .fault').filter({ hasText: 'panicked at a test' }).waitFor();
      await inState('error');
      await page.getByRole('button', { name: 'Play again' }).click();
      await inState('paused');
      assert.equal(await whole(), before);
      await eventually(async () => assert.equal(await tick(), 300));
    },
  ],
];
