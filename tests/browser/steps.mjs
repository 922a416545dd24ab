import assert from 'node:assert/strict';
import { eventually } from './browser.mjs';

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'steps_forward_and_back_by_keys',
    async (open) => {
      const { page, at } = await open();
      const start = await at(0);
      await page.keyboard.press('.');
      const first = await at(1);
      assert.notEqual(first, start);
      await page.keyboard.press('>');
      await at(101);
      await page.keyboard.press('<');
      assert.equal(await at(1), first);
      await page.keyboard.press(',');
      assert.equal(await at(0), start);
    },
  ],
  [
    'steps_forward_and_back_by_buttons',
    async (open) => {
      const { page, at } = await open();
      const start = await at(0);
      for (let step = 0; step < 3; step += 1) await page.locator('[data-action=forward]').click();
      await at(3);
      for (let step = 0; step < 3; step += 1) await page.locator('[data-action=back]').click();
      assert.equal(await at(0), start);
    },
  ],
  [
    'play_button_names_its_action_and_space_does_not_act_twice',
    async (open) => {
      const { page, inState } = await open();
      await page.keyboard.press(' ');
      await inState('running');
      await eventually(async () => assert.equal(await page.locator('#play').textContent(), 'Pause'));
      await page.locator('#play').focus();
      await page.keyboard.press(' ');
      await inState('paused');
      await eventually(async () => assert.equal(await page.locator('#play').textContent(), 'Play'));
    },
  ],
  [
    'keys_do_nothing_in_fields_and_can_be_switched_off',
    async (open) => {
      const { page, at, tick } = await open();
      await at(0);
      await page.locator('#seed').focus();
      await page.keyboard.press('.');
      await page.locator('[data-action=keys]').click();
      await page.locator('.keys-dialog input').uncheck();
      await page.locator('.keys-dialog button').click();
      await page.locator('#canvas').focus();
      await page.keyboard.press('.');
      await eventually(async () => assert.equal(await page.locator('[aria-keyshortcuts]').count(), 0));
      assert.equal(await tick(), 0);
    },
  ],
  [
    'every_key_of_the_list_has_a_visible_button',
    async (open) => {
      const { page } = await open();
      const shown = await page.locator('[aria-keyshortcuts]').evaluateAll((buttons) => buttons.map((button) => button.getAttribute('aria-keyshortcuts')));
      for (const key of ['Space', '.', ',', '>', '<', 'R', 'N', '?']) assert.ok(shown.includes(key), `no button for ${key}`);
    },
  ],
  [
    'restart_keeps_the_seed_and_new_seed_has_six_digits',
    async (open) => {
      const { page, at, seek, until } = await open('#/forage?preset=foraging&seed=42');
      const start = await at(0);
      await seek(70);
      await page.locator('[data-action=restart]').click();
      assert.equal(await at(0), start);
      await eventually(async () => assert.equal(await page.locator('#seed').inputValue(), '42'));
      await page.locator('[data-action=new-seed]').click();
      await until(() => /^\d{6}$/.test(/** @type {HTMLInputElement} */ (document.querySelector('#seed')).value));
      await until((old) => document.querySelector('#fingerprint')?.textContent !== old, start);
    },
  ],
  [
    'speed_is_apart_from_drawing_and_max_runs_ahead',
    async (open) => {
      const { page, inState, until, tick } = await open();
      await page.locator('#max').check();
      await page.locator('#play').click();
      await until(() => Number(document.querySelector('#tick')?.textContent) > 300);
      await page.locator('#play').click();
      await inState('paused');
      assert.ok((await tick()) > 300);
    },
  ],
];
