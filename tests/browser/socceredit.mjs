import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { eventually } from './browser.mjs';
import { openSoccer } from './pitch.mjs';

const COACH = readFileSync('trees/soccer/coach.xml', 'utf8');

/** Puts a text in place of what the editor holds. @param {import('playwright-core').Page} page @param {string} text */
async function type(page, text) {
  const content = page.locator('#soccer .soccer-code .cm-content');
  await content.click();
  await page.keyboard.press('ControlOrMeta+a');
  await page.keyboard.insertText(text);
}

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'soccer_robots_and_ball_are_dragged_and_the_match_goes_on',
    async (open) => {
      const { page, whole, seek, drag, until, events, middle, spot, notice, tick } = await openSoccer(open);
      const before = await whole();
      await seek(600);
      await drag(4, 0, 0.55);
      await until(() => location.hash.includes('events='));
      const made = await whole();
      assert.notEqual(made, before);
      await eventually(async () => assert.equal(await tick(), 600, 'the moment stays'));
      const [[x, y], [wx, wy]] = [await middle(4), await spot(0, 0.55)];
      assert.ok(Math.hypot(x - wx, y - wy) < 3, 'it stands where it was dropped');
      const list = await events();
      assert.deepEqual(list.map((/** @type {any} */ { tick: at, key }) => [at, key]), [[600, 'soccer.arrangement']]);
      const hash = await page.evaluate(() => location.hash);
      await drag(6, 0, -0.55);
      await until((old) => location.hash !== old && location.hash.includes('f='), hash);
      assert.equal((await events()).length, 1, 'another change at the same moment takes the place of the first');
      const kept = await whole();
      const again = await openSoccer(open, await page.evaluate(() => location.hash));
      assert.equal(await again.whole(), kept, 'the link plays the same match');
      await drag(3, 0, 0.56);
      await page.locator('#soccer-refusal').filter({ hasText: /^Not there: robot \d of the (left|right) team: expected a place apart from robot/ }).waitFor();
      await seek(300);
      await drag(5, 0.1, -0.58);
      await notice(/From 0:05\.0 of play: your change\. What was done later was dropped\./);
      await page.getByRole('button', { name: 'Take back' }).click();
      await until((first) => document.querySelector('#soccer-fingerprint')?.textContent === first, before);
      assert.deepEqual(await events(), []);
    },
  ],
  [
    'soccer_things_are_moved_by_keys_and_by_numbers_and_refused_where_they_cannot_stand',
    async (open) => {
      const { page, whole, seek, until, events } = await openSoccer(open);
      await whole();
      await seek(200);
      await page.locator('#soccer .pitch-stage.own canvas').focus();
      await page.keyboard.press('PageDown');
      await eventually(async () => assert.equal(await page.locator('#soccer-thing').inputValue(), '0'));
      const x = Number(await page.locator('#soccer-x').inputValue());
      await page.keyboard.press('ArrowRight');
      await until((before) => Math.abs(Number(/** @type {HTMLInputElement} */ (document.querySelector('#soccer-x')).value) - before - 0.01) < 0.0015, x);
      await page.keyboard.press(']');
      await until(() => location.hash.includes('events='));
      await page.locator('#soccer-thing').selectOption('6');
      await page.locator('#soccer-x').fill('0.9');
      await page.locator('#soccer-x').press('Enter');
      await page.locator('#soccer-refusal').filter({ hasText: /^Not there: the ball: expected a place on the pitch/ }).waitFor();
      const kept = await events();
      assert.ok(Math.abs(kept[0].value.ball[0]) < 0.85, 'what was refused is not in the scenario');
      await page.locator('#soccer .pitch-stage.own canvas').focus();
      await page.keyboard.press('Escape');
      await eventually(async () => assert.equal(await page.locator('#soccer-thing').inputValue(), ''));
    },
  ],
  [
    'soccer_situations_are_staged_from_the_moment_on_screen',
    async (open) => {
      const { page, whole, seek, tab, until, events, team } = await openSoccer(open);
      await whole();
      await seek(500);
      await page.locator('#soccer-situation').selectOption('penalty-kick blue');
      await page.getByRole('button', { name: 'Stage it' }).click();
      await page.locator('#soccer-call').filter({ hasText: 'Penalty kick for blue because somebody asked for it' }).waitFor();
      await until(() => location.hash.includes('events='));
      assert.deepEqual((await events())[0], { tick: 500, key: 'soccer.restart', value: { kind: 'penalty-kick', team: 'blue' } });
      await tab('roles');
      await page.locator('#soccer .who').filter({ hasText: 'Penalty Kicker' }).waitFor();
      await team('Yellow');
      await page.locator('#soccer .who').filter({ hasText: 'Penalty Defender' }).waitFor();
      await tab('coach');
      await page.locator('#soccer .statechart [data-state-name=PenaltyDefense].now').waitFor();
      await page.locator('#soccer-situation').selectOption('free-ball 3');
      await page.getByRole('button', { name: 'Stage it' }).click();
      await page.locator('#soccer-call').filter({ hasText: 'Free ball for yellow, quadrant 3' }).waitFor();
      await whole();
    },
  ],
  [
    'soccer_coach_is_edited_with_errors_at_their_place_and_plays_at_once',
    async (open) => {
      const { page, whole, until, tab, problems } = await openSoccer(open);
      const before = await whole();
      await page.getByRole('button', { name: 'Edit the text' }).click();
      await page.locator('#soccer .soccer-code .cm-content').waitFor();
      await type(page, COACH.replace('<LostBall/>', '<LoseBall/>'));
      await page.locator('#soccer-text-said').filter({ hasText: 'problem' }).waitFor();
      const said = (await page.locator('#soccer .text-problems').textContent()) ?? '';
      const line = COACH.split('\n').findIndex((row) => row.includes('<LostBall/>')) + 1;
      assert.match(said, new RegExp(`line ${line}, column \\d+.*unknown node "LoseBall", did you mean "LostBall"`));
      assert.equal(await page.locator('#soccer-fingerprint').textContent(), before, 'the last valid coach plays on');
      await type(page, COACH.replace('roles="', '').replace('<AssignStartRoles/>', '<AssignStartRoles roles="striker;goalkeper;assistant"/>'));
      await page.locator('#soccer .text-problems').filter({ hasText: 'unknown role "goalkeper", did you mean "goalkeeper"?' }).waitFor();
      await type(page, COACH.replace('<LostBall/>', '<AlwaysFailure/>'));
      await until((old) => document.querySelector('#soccer-fingerprint')?.getAttribute('data-whole') === 'true' && document.querySelector('#soccer-fingerprint')?.textContent !== old, before);
      await eventually(async () => assert.match((await page.locator('#soccer-score').textContent()) ?? '', /tree, edited/));
      await until(() => location.hash.includes('soccer.blue-coach=~'));
      await page.locator('#soccer .tree .node').filter({ hasText: 'AlwaysFailure' }).first().waitFor();
      await tab('coach');
      await page.getByRole('button', { name: 'Built-in coach again' }).click();
      await until((first) => document.querySelector('#soccer-fingerprint')?.textContent === first, before);
      assert.deepEqual(problems, []);
    },
  ],
  [
    'soccer_roles_are_edited_too_and_a_team_without_coach_has_none_to_edit',
    async (open) => {
      const { page, whole, until } = await openSoccer(open, '#/soccer?preset=match&seed=3&soccer.half-seconds=20&soccer.yellow=formation');
      const before = await whole();
      await eventually(async () => assert.ok(await page.locator('[data-key="soccer.yellow-coach"] button').first().isDisabled()));
      await page.locator('[data-key="soccer.yellow-roles"]').getByRole('button', { name: /^Edit/ }).click();
      await page.locator('#soccer .soccer-code .cm-content').waitFor();
      const roles = readFileSync('trees/soccer/roles.xml', 'utf8');
      await type(page, roles.replace(/<BehaviorTree ID="Wingback">[\s\S]*?<\/BehaviorTree>/, ''));
      await page.locator('#soccer .text-problems').filter({ hasText: 'expected a tree named "Wingback" for the role wingback' }).waitFor();
      await type(page, roles.replace(/<BehaviorTree ID="Wingback">[\s\S]*?<\/BehaviorTree>/, '<BehaviorTree ID="Wingback"><Spin/></BehaviorTree>'));
      await until((old) => document.querySelector('#soccer-fingerprint')?.getAttribute('data-whole') === 'true' && document.querySelector('#soccer-fingerprint')?.textContent !== old, before);
    },
  ],
  [
    'soccer_coach_opens_in_the_workbench_and_comes_back',
    async (open) => {
      const { page, whole, until, inState } = await openSoccer(open);
      const before = await whole();
      await page.getByRole('button', { name: 'Open in the workbench' }).click();
      await until(() => location.hash.startsWith('#/trees'));
      const play = page.getByRole('button', { name: 'Play as coach' });
      await play.waitFor();
      await inState('paused', 'finished');
      await page.locator('#trees .trees-code .cm-content').click();
      await page.keyboard.press('ControlOrMeta+a');
      await page.keyboard.insertText(COACH.replace('<LostBall/>', '<AlwaysFailure/>'));
      await page.locator('#trees .bench-name').filter({ hasText: 'AlwaysFailure' }).first().waitFor({ state: 'attached' });
      await play.click();
      await until(() => location.hash.startsWith('#/soccer') && location.hash.includes('blue-coach=~'));
      assert.notEqual(await whole(), before);
      const { page: other } = await open('#/trees');
      await other.locator('#trees-fingerprint').filter({ hasText: /\w/ }).waitFor();
      assert.equal(await other.getByRole('button', { name: 'Play as coach' }).isVisible(), false, 'only for trees that coach');
    },
  ],
  [
    'soccer_robot_is_driven_by_keys_and_the_match_stays_reproducible',
    async (open) => {
      const first = await openSoccer(open);
      const { page, whole, seek, inState, until, notice, events, tick, hash } = first;
      await whole();
      await seek(120);
      await page.locator('#soccer-driven').selectOption('1');
      await page.getByRole('button', { name: 'Drive a robot' }).click();
      await inState('running');
      const beyond = (/** @type {number} */ tick) => until((wanted) => Number(/** @type {HTMLInputElement} */ (document.querySelector('#soccer-scrub')).value) > wanted, tick);
      await page.keyboard.down('ArrowUp');
      await beyond(130);
      await page.keyboard.down('ArrowLeft');
      await beyond(await tick());
      await page.keyboard.up('ArrowLeft');
      await page.keyboard.up('ArrowUp');
      await beyond(150);
      await page.keyboard.press('Escape');
      await notice(/commands recorded as events of the scenario/);
      const fingerprint = await whole();
      await until(() => location.hash.includes('f='));
      const list = await events();
      assert.ok(list.length >= 3, `${list.length} commands`);
      assert.ok(list.every((/** @type {any} */ { key }) => key === 'soccer.drive'));
      assert.equal(list[0].tick, 120);
      assert.equal(list.at(-1).value, null);
      assert.ok((await tick()) > 150);
      const again = await openSoccer(open, await hash());
      assert.equal(await again.whole(), fingerprint, 'the link plays the same match');
    },
  ],
  [
    'soccer_robot_is_driven_by_a_gamepad',
    async (open) => {
      const { page, whole, seek, inState, until, events } = await openSoccer(open);
      await whole();
      await seek(120);
      await page.evaluate(() => {
        const pad = { connected: true, axes: [0.02, -1, 0, 0], buttons: Array.from({ length: 16 }, () => ({ pressed: false })) };
        Object.defineProperty(navigator, 'getGamepads', { value: () => [null, pad] });
      });
      await page.locator('#soccer-driven').selectOption('4');
      await page.getByRole('button', { name: 'Drive a robot' }).click();
      await inState('running');
      await until(() => Number(/** @type {HTMLInputElement} */ (document.querySelector('#soccer-scrub')).value) > 140);
      await page.getByRole('button', { name: 'Stop driving' }).click();
      await whole();
      await until(() => location.hash.includes('f='));
      const list = await events();
      assert.deepEqual(list[0].value, { team: 'yellow', robot: 2, wheels: [34, 34] }, 'a tremble of the stick counts as rest');
      assert.equal(list.length, 2);
    },
  ],
];
