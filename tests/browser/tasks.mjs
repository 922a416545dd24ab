import assert from 'node:assert/strict';
import { eventually } from './browser.mjs';

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'nest_maintenance_shows_debris_and_its_boundary',
    async (open) => {
      const { page, seek, problems } = await open('#/forage?preset=nest');
      await seek(300);
      await eventually(async () => assert.match((await page.locator('[data-layer=food]').textContent()) ?? '', /^Debris \d+$/));
      await eventually(async () => assert.match((await page.locator('#summary').textContent()) ?? '', /^Tick 300\. \d+ of 100 robots carry debris\. Delivered \d+ of 100\.$/));
      const names = await page.locator('.place-names text').allTextContents();
      assert.match(names.join(' | '), /^Hub \| Boundary \d+ \/ 100$/);
      assert.deepEqual(problems, []);
    },
  ],
  [
    'obstacles_and_traps_stand_without_names',
    async (open) => {
      const { page, seek, problems } = await open('#/forage?preset=obstacles');
      await seek(100);
      const names = (await page.locator('.place-names text').allTextContents()).filter(Boolean);
      assert.match(names.join(' | '), /^Hub( 0 \/ 100)? \| Site$/);
      assert.deepEqual(problems, []);
    },
  ],
  [
    'a_change_of_task_brings_its_own_built_in_rules',
    async (open) => {
      const { page, at, openGroups, until } = await open();
      await at(0);
      await openGroups();
      const rules = page.locator('[data-key="geese.grammar"] textarea');
      await eventually(async () => assert.match(await rules.inputValue(), /<s> ::= Hub \| Sites/));
      await page.locator('[data-key="geese.task"] select').selectOption('nest');
      await page.locator('#apply').click();
      await until(() => /<s> ::= Hub \| Boundary/.test(/** @type {HTMLTextAreaElement} */ (document.querySelector('[data-key="geese.grammar"] textarea')).value));
      await until(() => /Boundary/.test(document.querySelector('.place-names')?.textContent ?? ''));
    },
  ],
  [
    'all_five_fitness_types_are_listed_and_those_that_do_not_count_say_so',
    async (open) => {
      const { page, seek } = await open('#/forage?preset=geese-bt');
      await seek(50);
      await page.locator('#canvas').focus();
      await page.keyboard.press('Home');
      await page.getByRole('tab', { name: 'Robot' }).click();
      const list = page.locator('.facts-list').nth(1);
      await list.getByText('V Feedback B').waitFor();
      await eventually(async () => assert.match((await list.textContent()) ?? '', /III Prospective[01]IV Task\d+V Feedback B-?\d+ \(does not count\)/));
    },
  ],
  [
    'what_is_said_first_is_true_of_programs_that_do_not_evolve',
    async (open) => {
      const { page, seek, until, problems } = await open('#/forage?preset=hand-tree');
      await seek(100);
      await eventually(async () => assert.match((await page.locator('.lede').textContent()) ?? '', /^These behaviours were written by hand/));
      await page.locator('#preset').selectOption('foraging');
      await until(() => /^Nobody wrote these behaviours/.test(document.querySelector('.lede')?.textContent ?? ''));
      assert.deepEqual(problems, []);
    },
  ],
];
