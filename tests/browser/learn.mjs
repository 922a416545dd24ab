import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { learnText } from '../../www/ui/strings.learn.en.js';
import { eventually } from './browser.mjs';

const MOST_WORDS = 120;
const folder = new URL('../../lessons/', import.meta.url);

/** @type {{ number: number, name: string, facts: Record<string, { value: number }>, check: any }[]} */
export const lessons = readdirSync(folder)
  .map((file) => {
    const [, number, name] = /** @type {RegExpExecArray} */ (/^(\d+)-(.+)\.json$/.exec(file));
    return { number: Number(number), name, ...JSON.parse(readFileSync(new URL(file, folder), 'utf8')) };
  })
  .sort((a, b) => a.number - b.number);

const ANSWERED = lessons.filter(({ check }) => check.options);

/** @param {import('./browser.mjs').Opened} opened */
async function verdict({ page, until }) {
  await until(() => document.querySelector('#learn-verdict')?.textContent && !(/** @type {HTMLButtonElement} */ (document.querySelector('#learn-ask')).disabled));
  return (await page.locator('#learn-verdict').textContent()) ?? '';
}

/** Waits until the world beside a lesson stands. @param {import('./browser.mjs').Opened} opened */
async function stands({ until }) {
  await until(() => document.body.hasAttribute('data-beside') && !['loading', 'error'].includes(document.body.dataset.state ?? 'loading'));
}

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'lessons_have_at_most_120_words_and_no_number_of_their_own',
    async () => {
      const counts = lessons.map(({ number, name, facts }) => {
        const write = learnText.lessons[name];
        const values = Object.fromEntries(Object.entries(facts).map(([fact, { value }]) => [fact, value]));
        const { title, body, ask } = write(values);
        const words = [...body, ask].join(' ').split(/\s+/).filter((word) => /[\p{L}\p{N}]/u.test(word)).length;
        assert.ok(words <= MOST_WORDS, `lesson ${number} has ${words} words`);
        // Every number comes from the lesson's file, where tests/lessons.rs finds it again.
        const unread = new Set(Object.keys(facts));
        const blank = write(new Proxy({}, { get: (_, fact) => (unread.delete(String(fact)), assert.ok(String(fact) in facts, `${name}: no fact '${String(fact)}'`), '#') }));
        const text = [blank.title, ...blank.body, blank.ask, ...Object.values(blank.options)].join(' ');
        assert.doesNotMatch(text.replaceAll('+1', ''), /\d/, `${name}: ${title}`);
        assert.deepEqual([...unread], [], `${name}: facts that nothing uses`);
        return words;
      });
      return `${counts.join(', ')} words`;
    },
  ],
  ...ANSWERED.map((lesson) => /** @type {import('./browser.mjs').Case} */ ([
    `the_engine_answers_lesson_${lesson.number}_${lesson.name.replaceAll('-', '_')}`,
    async (open) => {
      const opened = await open(`#/learn/${lesson.number}`);
      const { page, problems } = opened;
      await stands(opened);
      const options = Object.keys(lesson.check.options);
      await page.locator('#learn-ask').click();
      assert.equal(await verdict(opened), learnText.lesson.choose);
      await page.locator(`#learn-option-${options[0]}`).check();
      await page.locator('#learn-ask').click();
      await page.locator('.learn-table').waitFor();
      const rows = await page.locator('.learn-table tbody tr').evaluateAll((list) => list.map((row) => row.getAttribute('data-right') === 'true'));
      assert.equal(rows.length, options.length);
      assert.equal(rows.filter(Boolean).length, 1, 'one answer is right');
      assert.equal(await verdict(opened), rows[0] ? learnText.right : learnText.wrong);
      if (!rows[0]) {
        await page.locator(`#learn-option-${options[rows.indexOf(true)]}`).check();
        await page.locator('#learn-ask').click();
        await page.locator('.learn-findings[data-right=true]').waitFor();
        assert.equal(await verdict(opened), learnText.right);
      }
      await page.locator('.lesson .learn-top a').click();
      await page.locator('.learn-list').waitFor();
      assert.equal(await page.locator('.learn-mark').filter({ hasText: 'done' }).count(), 1);
      assert.deepEqual(problems, []);
    },
  ])),
  [
    'rules_that_bring_home_50_solve_lesson_4_and_the_ones_given_do_not',
    async (open) => {
      const opened = await open('#/learn/4');
      const { page, problems } = opened;
      await stands(opened);
      await page.locator('#learn-ask').click();
      assert.match(await verdict(opened), /^Not yet: your rules bring home 0 by tick/);
      const area = page.locator('[data-key="geese.grammar"] textarea');
      await area.fill((await area.inputValue()).replace('Sel[<bring>', 'Sel[<drop> <bring>'));
      await page.locator('[data-key="geese.grammar"]').getByRole('button', { name: 'Apply' }).click();
      await page.locator('#apply').click();
      await page.locator('.apply-strip').waitFor({ state: 'hidden' });
      await page.locator('#learn-ask').click();
      await page.locator('.learn-findings[data-right=true]').waitFor();
      assert.match(await verdict(opened), /^Done: your rules bring home \d+ by tick/);
      assert.deepEqual(problems, []);
    },
  ],
  [
    'a_plan_played_by_hand_solves_lesson_10_and_stands_beside_the_planners',
    async (open) => {
      const opened = await open('#/learn/10');
      const { page, until } = opened;
      await stands(opened);
      await page.locator('#learn-ask').click();
      assert.match(await verdict(opened), /press Begin/);
      const planner = /** @type {string} */ (await page.locator('.learn-table tbody tr').nth(1).locator('td').first().textContent());
      const letters = [.../** @type {RegExpExecArray} */ (/^(\S+): target reached/.exec(planner))[1]];
      await page.locator('#sequence-pace').selectOption('0');
      await page.locator('#sequence-speed').evaluate((slider) => {
        /** @type {HTMLInputElement} */ (slider).value = '100';
        slider.dispatchEvent(new Event('input'));
      });
      await page.locator('#sequence-game-begin').click();
      for (const [turn, letter] of letters.entries()) {
        if (await page.locator('#sequence-game-result').isVisible()) break;
        await page.locator(`.game-keys [data-letter="${letter}"]`).click();
        await until((wanted) => !document.querySelector('#sequence [data-state=running]') && document.body.dataset.state !== 'running' && (document.querySelector('#sequence-game-result')?.textContent || document.querySelector('.game-said')?.textContent?.includes(`${wanted}`)), turn + 1);
      }
      await until(() => document.querySelector('#sequence-game-result')?.textContent);
      await page.locator('#learn-ask').click();
      await page.locator('.learn-findings[data-right=true]').waitFor();
      assert.match(await verdict(opened), /You brought everybody to the target/);
    },
  ],
  [
    'lesson_1_is_done_by_keyboard_alone',
    async (open) => {
      const opened = await open('#/learn');
      const { page, until } = opened;
      const focused = () => page.evaluate(() => document.activeElement?.id || document.activeElement?.textContent?.trim() || '');
      /** @param {(name: string) => boolean} wanted */
      const tabTo = async (wanted) => {
        for (let press = 0; press < 40; press += 1) {
          await page.keyboard.press('Tab');
          if (wanted(await focused())) return;
        }
        assert.fail(`the Tab key never came to it; it stands at ${await focused()}`);
      };
      await tabTo((name) => name === 'One robot, one rule');
      await page.keyboard.press('Enter');
      await stands(opened);
      await eventually(async () => assert.equal(await focused(), 'One robot, one rule')); // the heading, so that a reader goes on from there
      await tabTo((name) => name.startsWith('learn-option-'));
      await page.keyboard.press('ArrowDown');
      await page.keyboard.press('ArrowDown');
      await tabTo((name) => name === 'learn-ask');
      await page.keyboard.press('Enter');
      await page.locator('.learn-findings[data-right=true]').waitFor();
      await eventually(async () => assert.equal(await page.locator('#live').textContent(), learnText.right));
      await tabTo((name) => name === 'canvas');
      await page.keyboard.press(' ');
      await until(() => document.body.dataset.state === 'running');
      await page.keyboard.press(' ');
      await until(() => document.body.dataset.state === 'paused');
      await page.keyboard.press('Shift+Tab');
      for (let press = 0; press < 10 && (await focused()) !== 'learn-next'; press += 1) await page.keyboard.press('Shift+Tab');
      await page.keyboard.press('Enter');
      await until(() => location.hash === '#/learn/2');
      assert.deepEqual(opened.problems, []);
    },
  ],
  [
    'a_lesson_hides_controls_and_shows_all_of_them_when_asked',
    async (open) => {
      const opened = await open('#/learn/1');
      const { page } = opened;
      await stands(opened);
      for (const hidden of ['#controls', '#inspector', '#foot', '.legend', '#seed']) assert.equal(await page.locator(hidden).isVisible(), false, hidden);
      assert.ok(await page.locator('#play').isVisible());
      await page.locator('.learn-controls').click();
      for (const shown of ['#controls', '#inspector', '#foot', '#seed']) await eventually(async () => assert.ok(await page.locator(shown).isVisible(), shown));
      await page.locator('.learn-controls').click();
      await eventually(async () => assert.equal(await page.locator('#controls').isVisible(), false));
    },
  ],
  [
    'a_lesson_is_left_and_the_tab_is_as_it_was_before',
    async (open) => {
      const opened = await open('#/forage?preset=foraging&seed=7');
      const { page, seek, at, until, address } = opened;
      const fingerprint = await seek(50);
      await address(50);
      await page.getByRole('link', { name: 'Learn' }).click();
      await page.getByRole('link', { name: 'One robot, one rule' }).click();
      await stands(opened);
      await until(() => document.querySelector('#tick')?.textContent === '0');
      assert.equal(await page.evaluate(() => location.hash), '#/learn/1');
      await page.locator('#top').getByRole('link', { name: 'Forage' }).click();
      assert.equal(await at(50), fingerprint);
      await eventually(async () => assert.ok(await page.locator('#controls').isVisible()));
      await page.goBack();
      await until(() => location.hash === '#/learn/1' && document.querySelector('#tick')?.textContent === '0');
      await eventually(async () => assert.equal(await page.locator('#controls').isVisible(), false));
    },
  ],
  [
    'a_lesson_that_does_not_exist_is_named',
    async (open) => {
      const { page } = await open('#/learn/99<b>x');
      await eventually(async () => assert.match((await page.locator('.learn-unknown').textContent()) ?? '', /no lesson '99/));
      assert.equal(await page.locator('.learn-unknown b').count(), 0);
    },
  ],
  [
    'the_worksheet_prints_a_page_for_each_lesson',
    async (open) => {
      const { page } = await open('#/learn/worksheet');
      await eventually(async () => assert.equal(await page.locator('.sheet-page').count(), lessons.length));
      const pdf = (await page.pdf({ format: 'A4' })).toString('latin1');
      assert.equal((pdf.match(/\/Type ?\/Page\b/g) ?? []).length, lessons.length);
    },
  ],
  [
    'the_answer_key_is_made_by_the_engine',
    async (open) => {
      const { page } = await open('#/learn/answers');
      await page.locator('.worksheet[data-answered=true]').waitFor();
      const rights = await page.locator('.learn-table').evaluateAll((tables) => tables.map((table) => table.querySelectorAll('tr[data-right=true]').length));
      assert.deepEqual(rights, ANSWERED.map(() => 1));
    },
  ],
];
