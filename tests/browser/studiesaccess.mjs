import assert from 'node:assert/strict';
import { violations } from './access.mjs';
import { eventually } from './browser.mjs';
import { SPEC, linkTo, openStudy } from './studies.mjs';

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
const SCREENS = /** @type {const} */ ([
  ['light', { width: 1440, height: 900 }],
  ['dark', { width: 1440, height: 900 }],
  ['light', { width: 1024, height: 768 }],
  ['dark', { width: 1024, height: 768 }],
  ['light', PHONE.viewport],
  ['dark', PHONE.viewport],
]);
const unfold = (/** @type {import('playwright-core').Page} */ page) => page.locator('#studies details').evaluateAll((all) => all.forEach((details) => details.setAttribute('open', '')));

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  ...SCREENS.map(([colorScheme, viewport]) => /** @type {import('./browser.mjs').Case} */ ([
    `axe_finds_nothing_in_${colorScheme}_at_the_studies_${viewport.width}_pixels_wide`,
    async (open) => {
      const study = await openStudy(open, '#/studies', { colorScheme, viewport, hasTouch: viewport.width < 900 });
      const { page } = study;
      await page.locator('.study-row').first().waitFor();
      assert.deepEqual(await violations(page), [], 'list');
      await page.evaluate((hash) => void (location.hash = hash), linkTo());
      await study.ready();
      assert.deepEqual(await violations(page), [], 'fresh');
      await study.finish();
      await unfold(page);
      assert.deepEqual(await violations(page), [], 'finished');
      await page.evaluate(() => void (location.hash = '#/studies/mutation?size=paper'));
      await page.locator('#studies-title').filter({ hasText: 'mutation' }).waitFor();
      await unfold(page);
      assert.deepEqual(await violations(page), [], 'form');
      await study.type(JSON.stringify({ ...SPEC, metrics: ['none'] }));
      await page.locator('#studies-fault').filter({ hasText: 'metrics' }).waitFor();
      assert.deepEqual(await violations(page), [], 'fault');
      await page.evaluate(() => void (location.hash = '#/studies/success?size=paper'));
      await page.locator('.studies-source').filter({ hasText: 'results/success.csv' }).waitFor();
      assert.deepEqual(await violations(page), [], 'committed');
      assert.deepEqual(study.problems, []);
    },
  ])),
  ...[320, 390, 768, 1024].map((width) => /** @type {import('./browser.mjs').Case} */ ([
    `studies_do_not_scroll_sideways_at_${width}_pixels`,
    async (open) => {
      const study = await openStudy(open, '#/studies', { viewport: { width, height: 640 }, hasTouch: true });
      const { page } = study;
      const fits = async (/** @type {string} */ what) => {
        const [scroll, client] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
        assert.ok(scroll <= client, `${what}: ${scroll} pixels in a window of ${client}`);
      };
      await page.locator('.study-row').first().waitFor();
      await fits('list');
      const long = 'b'.repeat(100);
      const cells = [{ name: 'a' }, { name: long, set: { 'geese.children': 4 } }];
      await page.evaluate((hash) => void (location.hash = hash), linkTo({ title: `${long} ${long}`, about: long, grid: undefined, cells, tests: undefined, paper: { [long]: { share: 0.5 } }, figure: { kind: 'box', metric: 'share' } }));
      await study.ready();
      await study.finish();
      await unfold(page);
      await fits('long words');
      await page.evaluate(() => void (location.hash = '#/studies/success?size=paper'));
      await page.locator('.studies-source').filter({ hasText: 'results/success.csv' }).waitFor();
      await unfold(page);
      await fits('committed');
    },
  ])),
  [
    'targets_of_the_studies_are_large_enough_for_fingers',
    async (open) => {
      const study = await openStudy(open, linkTo(), PHONE);
      await unfold(study.page);
      const small = await study.page.locator('#studies button:visible, #studies summary:visible, #studies select:visible, #studies input[type=text]:visible, #studies input[type=number]:visible, #studies label.check:visible, #studies .back').evaluateAll((targets) =>
        targets.filter((target) => target.getBoundingClientRect().height < 43.5).map((target) => target.outerHTML.slice(0, 80)),
      );
      assert.deepEqual(small, []);
    },
  ],
  [
    'a_study_is_opened_edited_run_and_taken_away_by_keyboard_alone',
    async (open) => {
      const study = await openStudy(open, '#/studies', { acceptDownloads: true });
      const { page, inState, until } = study;
      await page.locator('.study-row').first().waitFor();
      /** Tabs until the focus is at a place. @param {string} selector */
      const reach = async (selector) => {
        for (let presses = 0; presses < 120; presses += 1) {
          await page.keyboard.press('Tab');
          if (await page.evaluate((wanted) => document.activeElement?.matches(wanted), selector)) return;
        }
        assert.fail(`${selector} is not reached by Tab`);
      };
      await reach('a[href="#/studies/agents?size=glance"]');
      await page.keyboard.press('Enter');
      await study.ready();
      await reach('[id="study-grid.geese.agents"]');
      await page.keyboard.press('Control+a');
      await page.keyboard.type('25, 50, 100, 400');
      await page.keyboard.press('Tab');
      await until(() => /^0 of 8 runs/.test(document.querySelector('#studies-done')?.textContent ?? ''));
      assert.ok(await page.evaluate(() => document.activeElement?.closest('[data-path="grid"]')), 'the focus goes on from the field');
      await reach('#studies-json');
      await page.keyboard.press('Tab');
      assert.ok(!(await page.evaluate(() => document.activeElement?.matches('#studies-json'))), 'Tab leaves the text');
      await reach('#studies-run');
      await page.keyboard.press('Enter');
      await inState('busy');
      await page.keyboard.press(' ');
      await inState('paused');
      await page.keyboard.press('Enter');
      await study.finished();
      await reach('.studies-how select');
      for (let presses = 0; presses < 12 && !(await page.evaluate(() => document.activeElement?.textContent === 'CSV')); presses += 1) await page.keyboard.press('Tab');
      const waiting = page.waitForEvent('download');
      await page.keyboard.press('Enter');
      assert.equal((await waiting).suggestedFilename(), 'agents-glance.csv');
      assert.deepEqual(study.problems, []);
    },
  ],
  [
    'keys_choose_the_tab_and_start_and_pause_a_study',
    async (open) => {
      const { page, inState, until } = await open();
      await inState('paused');
      await page.keyboard.press('5');
      await page.locator('.study-row').first().waitFor();
      assert.equal(await page.title(), 'Studies · Swarm playground');
      await page.evaluate((hash) => void (location.hash = hash), linkTo({ scenario: { ...SPEC.scenario, steps: 6000 } }));
      await until(() => /^0 of 10 runs/.test(document.querySelector('#studies-done')?.textContent ?? ''));
      await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement).blur());
      await page.keyboard.press(' ');
      await inState('busy');
      await eventually(async () => assert.match((await page.locator('#live').textContent()) ?? '', /^Running: 10 runs to make$/));
      await page.keyboard.press(' ');
      await inState('paused');
      await eventually(async () => assert.match((await page.locator('#live').textContent()) ?? '', /^Paused: \d+ of 10 runs made$/));
      assert.equal(await page.locator('[aria-live]').count(), 1);
    },
  ],
  [
    'studies_are_loaded_with_their_tab_only',
    async (open) => {
      const { page, inState } = await open('');
      await inState('paused');
      const names = () => page.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name).filter((name) => /studies|desk/.test(name)));
      assert.deepEqual(await names(), []);
      const other = await openStudy(open, '#/studies');
      await other.page.locator('.study-row').first().waitFor();
      assert.equal(await other.page.locator('#preset').count(), 0, 'and no swarm is started for them');
    },
  ],
];
