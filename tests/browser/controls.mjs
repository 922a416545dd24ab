import assert from 'node:assert/strict';
import { eventually } from './browser.mjs';

const MUTATION = '[data-key="geese.mutation-probability"]';

/** Types a value into a control's box. @param {import('playwright-core').Page} page @param {string} control @param {string} value */
async function type(page, control, value) {
  const box = page.locator(`${control} .number input`);
  await box.fill(value);
  await box.press('Enter');
}

/** Words of labels that stand on two lines, each with its label. @param {import('playwright-core').Page} page */
const brokenWords = (page) =>
  page.locator('.page-tab:not([hidden]) .controls-pane :is(label, .control-name)').evaluateAll((labels) =>
    labels.flatMap((label) => {
      const found = [];
      const texts = document.createTreeWalker(label, NodeFilter.SHOW_TEXT);
      for (let text = texts.nextNode(); text; text = texts.nextNode()) {
        for (const { 0: word, index } of (text.textContent ?? '').matchAll(/\S+/g)) {
          const range = document.createRange();
          range.setStart(text, index);
          range.setEnd(text, index + word.length);
          if (new Set([...range.getClientRects()].map(({ top }) => Math.round(top))).size > 1) found.push(`${word} in ${label.textContent}`);
        }
      }
      return found;
    }),
  );

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  ...[320, 1024].map((width) => /** @type {import('./browser.mjs').Case} */ ([
    `labels_break_between_their_words_only_at_${width}_pixels`,
    async (open) => {
      for (const hash of ['#/forage?preset=foraging', '#/sequence?preset=plan-small', '#/soccer?preset=match&soccer.half-seconds=20']) {
        const { page } = await open(hash, { viewport: { width, height: 768 } });
        const groups = page.locator('.page-tab:not([hidden]) .controls-pane details');
        await groups.first().waitFor({ state: 'attached' });
        await groups.evaluateAll((all) => all.forEach((group) => group.setAttribute('open', '')));
        assert.ok((await page.locator('.page-tab:not([hidden]) .control:visible').count()) > 10);
        assert.deepEqual(await brokenWords(page), [], hash);
      }
    },
  ])),
  [
    'live_change_becomes_an_event_and_survives_in_the_link',
    async (open) => {
      const first = await open();
      await first.seek(64);
      await first.openGroups();
      assert.equal(await first.page.locator(MUTATION).getAttribute('data-apply'), 'live');
      await type(first.page, MUTATION, '0.25');
      await first.until(() => location.hash.includes('events=~'));
      const fingerprint = await first.seek(130);
      const hash = await first.address(130);
      await first.seek(10);
      await eventually(async () => assert.notEqual(await first.page.locator(`${MUTATION} .number input`).inputValue(), '0.25')); // not in force yet at tick 10
      const second = await open(hash);
      assert.equal(await second.at(130), fingerprint);
      await second.openGroups();
      await eventually(async () => assert.equal(await second.page.locator(`${MUTATION} .number input`).inputValue(), '0.25'));
      await second.notice(/fingerprint matches/);
    },
  ],
  [
    'change_after_scrubbing_back_cuts_later_events',
    async (open) => {
      const { page, seek, openGroups, until, notice } = await open();
      await openGroups();
      await seek(100);
      await type(page, MUTATION, '0.3');
      await until(() => location.hash.includes('events=~'));
      await seek(40);
      await type(page, MUTATION, '0.4');
      await notice(/From tick 40: your change/);
      await seek(120);
      await eventually(async () => assert.equal(await page.locator(`${MUTATION} .number input`).inputValue(), '0.4'));
    },
  ],
  [
    'change_that_needs_a_restart_marks_itself',
    async (open) => {
      const { page, seek, openGroups, at, until } = await open();
      await openGroups();
      const before = await seek(30);
      const control = page.locator('[data-apply=restart]:has(.number)').first();
      const box = control.locator('.number input');
      const old = Number(await box.inputValue());
      const slider = control.locator('input[type=range]');
      await slider.focus();
      await slider.press('ArrowLeft');
      await control.locator('.waits').waitFor();
      assert.equal(await at(30), before);
      await eventually(async () => assert.ok(await page.locator('#apply').isVisible()));
      await page.locator('#apply').click();
      const after = await at(0);
      assert.notEqual(after, before);
      await eventually(async () => assert.notEqual(Number(await box.inputValue()), old));
      await page.locator('#apply').waitFor({ state: 'hidden' });
      const key = await control.getAttribute('data-key');
      await until((wanted) => location.hash.includes(`${wanted}=`), key);
      await control.locator('.reset').click();
      await control.locator('.waits').waitFor();
      await eventually(async () => assert.equal(Number(await box.inputValue()), old));
    },
  ],
  [
    'what_is_being_typed_survives_an_answer_that_comes_in',
    async (open) => {
      const { page, seek, openGroups } = await open();
      await openGroups();
      await seek(20);
      const box = page.locator(`${MUTATION} .number input`);
      const old = await box.inputValue();
      await box.focus();
      await box.press('ControlOrMeta+a');
      await box.pressSequentially('0.3');
      // Another change, by hand of nobody, so that the box keeps the focus; its answer shows every control anew.
      const other = page.locator('[data-key="geese.interaction-probability"]');
      await other.locator('input[type=range]').evaluate((/** @type {HTMLInputElement} */ slider) => {
        slider.value = slider.min;
        slider.dispatchEvent(new Event('change'));
      });
      await other.locator('.reset').waitFor();
      assert.equal(await box.inputValue(), '0.3');
      await box.press('Enter');
      await page.locator(`${MUTATION} .reset`).waitFor();
      assert.equal(await box.inputValue(), '0.3');
      await page.locator(`${MUTATION} .reset`).click();
      await eventually(async () => assert.equal(await box.inputValue(), old));
    },
  ],
  [
    'every_parameter_but_the_seed_has_a_control_with_help_and_source',
    async (open) => {
      const { page, engine, openGroups } = await open();
      const { schema } = /** @type {{ schema: any[] }} */ (await engine('hello'));
      await openGroups();
      for (const { key, type: kind, help, label } of schema) {
        if (kind === 'seed') continue;
        const control = page.locator(`[data-key="${key}"]`);
        assert.equal(await control.count(), 1, key);
        assert.ok(help && label, key);
        await control.locator('.about').click();
        assert.ok(((await control.locator('.help[id]').textContent()) ?? '').includes(help), key);
        assert.notEqual(await control.locator('.source').textContent(), '', key);
      }
    },
  ],
  [
    'box_goes_beyond_the_slider_with_a_warning',
    async (open) => {
      const { page, engine, openGroups } = await open();
      const { schema } = /** @type {{ schema: any[] }} */ (await engine('hello'));
      const wide = schema.find((/** @type {any} */ parameter) => parameter.type === 'int' && parameter.hard_max > parameter.max);
      assert.ok(wide, 'no parameter reaches beyond its slider');
      await openGroups();
      await type(page, `[data-key="${wide.key}"]`, String(wide.max + 1));
      await page.locator(`[data-key="${wide.key}"] .field-error`).filter({ hasText: /Beyond the slider/ }).waitFor();
    },
  ],
];
