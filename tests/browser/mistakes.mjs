import assert from 'node:assert/strict';
import { eventually } from './browser.mjs';

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'bad_parts_of_a_link_are_named_and_the_rest_is_applied',
    async (open) => {
      const opened = await open('#/forage?v=0.0.1&preset=nowhere&seed=9007199254740993&geese.agents=many&nonsense=1&geese.grammar=~!!!&geese.mutation-probability=0.2&t=20&f=zz');
      await opened.at(20);
      await opened.notice(/Made with 0\.0\.1, this is/);
      const said = (await opened.page.locator('.notice p').allTextContents()).join('\n');
      assert.match(said, /'geese\.grammar'.*cannot be unpacked/);
      assert.match(said, /'f'.*16 hexadecimal digits/);
      assert.match(said, /holds 'nonsense'/);
      await opened.openGroups();
      await eventually(async () => assert.equal(await opened.page.locator('[data-key="geese.mutation-probability"] .number input').inputValue(), '0.2'));
      assert.equal(await opened.page.locator('#preset').inputValue(), 'foraging');
    },
  ],
  [
    'each_bad_value_says_what_was_found_and_what_is_allowed',
    async (open) => {
      for (const [part, pattern] of /** @type {[string, RegExp][]} */ ([
        ['seed=9007199254740993', /'seed' was left out: found '9007199254740993', expected a whole number from 0 to 9007199254740991/],
        ['seed=-1', /'seed' was left out: found '-1', expected a whole number from 0/],
        ['geese.agents=many', /'geese\.agents' was left out: found 'many', expected a whole number from/],
        ['geese.agents=0.5', /'geese\.agents' was left out: found '0\.5'/],
        ['preset=nowhere', /'preset' was left out: found 'nowhere', expected one of foraging/],
        ['t=soon', /'t' was left out: found 'soon', expected a tick/],
        ['events=~AAAA', /'events' was left out/],
      ])) {
        const opened = await open(`#/forage?${part}`);
        await opened.notice(pattern);
        await opened.inState('paused');
        assert.deepEqual(opened.problems, [], part);
        await opened.close();
      }
    },
  ],
  [
    'fingerprint_that_does_not_match_is_told_with_both_values',
    async (open) => {
      const { at, notice } = await open('#/forage?preset=foraging&t=15&f=0123456789abcdef');
      const found = await at(15);
      const said = (await notice(/does not match/)) ?? '';
      assert.ok(said.includes('0123456789abcdef') && said.includes(found), said);
    },
  ],
  [
    'bad_grammar_shows_line_and_column_and_the_world_goes_on',
    async (open) => {
      const { page, seek, openGroups, at } = await open();
      const before = await seek(12);
      await openGroups();
      const editor = page.locator('[data-key="geese.grammar"]');
      const area = editor.locator('textarea');
      const good = await area.inputValue();
      const lines = good.split('\n');
      lines[2] = `${lines[2]} | | [`;
      await area.fill(lines.join('\n'));
      await editor.getByRole('button', { name: 'Apply' }).click();
      const error = editor.locator('.field-error').filter({ hasText: /line \d+, column \d+/ });
      await error.waitFor();
      await editor.locator('.line-mark').waitFor();
      await eventually(async () => assert.equal(await editor.locator('.gutter .bad').textContent(), /line (\d+)/.exec((await error.textContent()) ?? '')?.[1]));
      assert.equal(await at(12), before);
      await page.locator('#canvas').focus();
      await page.keyboard.press('.');
      await at(13);
    },
  ],
  [
    'bad_seed_is_named_and_nothing_changes',
    async (open) => {
      const { page, at } = await open('#/forage?preset=foraging&seed=5');
      const before = await at(0);
      for (const seed of ['9007199254740992', '-3', '1.5', 'abc', '']) {
        await page.locator('#seed').fill(seed);
        await page.locator('#seed').press('Enter');
        await page.locator('#seed-error').filter({ hasText: 'expected a whole number from 0 to 9007199254740991' }).waitFor();
      }
      assert.equal(await at(0), before);
      await page.locator('#seed').fill('9007199254740991');
      await page.locator('#seed').press('Enter');
      await page.waitForFunction(() => location.hash.includes('seed=9007199254740991'));
    },
  ],
  [
    'broken_engine_is_replaced_and_taken_to_its_tick',
    async (open) => {
      const { page, seek, inState, at } = await open();
      const before = await seek(77);
      await page.workers()[0].evaluate(() => self.postMessage({ id: 0, type: 'error', fatal: true, message: 'panicked at a test' }));
      await inState('error');
      await page.locator('.fault').filter({ hasText: 'panicked at a test' }).waitFor();
      await page.getByRole('button', { name: 'Reload at tick 77' }).click();
      assert.equal(await at(77), before);
      await eventually(async () => assert.equal(await page.locator('.fault').isVisible(), false));
    },
  ],
  [
    'engine_that_cannot_start_gives_a_plain_sentence',
    async (open) => {
      const opened = await open();
      await opened.page.route('**/*.wasm', (route) => route.abort());
      await opened.page.reload();
      await opened.inState('error');
      await opened.page.locator('.fault').filter({ hasText: 'command line' }).waitFor();
    },
  ],
];
