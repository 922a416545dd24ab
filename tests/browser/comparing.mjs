import assert from 'node:assert/strict';
import { violations } from './access.mjs';
import { eventually } from './browser.mjs';

/** @typedef {import('./browser.mjs').Opened} Opened */

/** A page in A | B, with the words its tests speak. @param {import('./browser.mjs').Open} open @param {string} hash @param {import('playwright-core').BrowserContextOptions} [options] */
export async function openPair(open, hash, options = {}) {
  const opened = await open(hash, options);
  const { page, until } = opened;
  await page.locator('.ab-side[data-side=b] .stage').waitFor({ state: 'attached' });
  return {
    ...opened,

    /** Waits until both stand at a tick; gives both fingerprints. @param {number} tick */
    async both(tick) {
      const a = await opened.at(tick);
      await until((wanted) => /** @type {HTMLElement} */ (document.querySelector('#ab-fingerprint-b')).dataset.tick === String(wanted), tick);
      return { a, b: /** @type {string} */ (await page.locator('#ab-fingerprint-b').textContent()) };
    },

    status: () => page.locator('#ab-status').textContent(),

    /** The last tick at which both are the same; NaN while none is known at which they differ. */
    parting: async () => {
      const until = await page.locator('#ab-status').getAttribute('data-until');
      return until === '' || until === null ? NaN : Number(until);
    },
  };
}

/** A list of changes as it stands in links. @param {object[]} events */
async function packed(events) {
  const { deflateRawSync } = await import('node:zlib');
  return `~${deflateRawSync(Buffer.from(JSON.stringify(events))).toString('base64url')}`;
}

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'a_live_change_in_b_parts_the_two_at_its_tick_exactly',
    async (open) => {
      // Robots that are scattered keep their programs for a while, so the fitness memory tells in the very next step.
      for (const tick of [1, 63, 64, 97, 200]) {
        const events = await packed([{ tick, key: 'geese.fitness-memory', value: 0.5 }]);
        const pair = await openPair(open, `#/forage?preset=foraging&seed=5&geese.start-positions=uniform&b.events=${events}`);
        await eventually(async () => assert.match((await pair.status()) ?? '', /^Identical so far/));
        const jump = await pair.seek(260).then(() => pair.parting());
        assert.equal(jump, tick, 'in one seek');
        await eventually(async () => assert.equal(await pair.status(), `Identical until tick ${tick}`));
        await pair.seek(10);
        assert.equal(await pair.parting(), tick, 'it is kept on the way back');
        assert.deepEqual(pair.problems, []);
        await pair.close();
      }
      const events = await packed([{ tick: 97, key: 'geese.fitness-memory', value: 0.5 }]);
      const pair = await openPair(open, `#/forage?preset=foraging&seed=5&geese.start-positions=uniform&b.events=${events}`);
      await pair.page.locator('#max').check();
      await pair.page.locator('#play').click();
      await pair.until(() => Number(document.querySelector('#tick')?.textContent) > 150);
      await pair.page.locator('#play').click();
      await pair.inState('paused');
      await eventually(async () => assert.equal(await pair.parting(), 97, 'while playing'));
    },
  ],
  [
    'runs_that_differ_in_one_tick_only_part_there_however_far_the_seek_goes',
    async (open) => {
      // Without memory and evolution, fitness is the last tick's alone: a memory of one step is forgotten in the next.
      const events = await packed([
        { tick: 97, key: 'geese.fitness-memory', value: 0.5 },
        { tick: 98, key: 'geese.fitness-memory', value: 0 },
      ]);
      const pair = await openPair(open, `#/forage?preset=foraging&seed=5&geese.fitness-memory=0&geese.evolution=false&b.events=${events}`);
      for (const [tick, same] of /** @type {[number, boolean][]} */ ([[300, true], [98, false], [97, true], [99, true]])) {
        await pair.seek(tick);
        const { a, b } = await pair.both(tick);
        assert.equal(a === b, same, `tick ${tick}`);
        assert.equal(await pair.status(), 'Identical until tick 97');
      }
    },
  ],
  [
    'both_stand_at_one_tick_and_equal_the_runs_alone',
    async (open) => {
      const alone = new Map();
      for (const preset of ['foraging-paper', 'foraging']) {
        const single = await open(`#/forage?preset=${preset}&seed=8`);
        for (const tick of [0, 1, 65, 130]) alone.set(`${preset} ${tick}`, await single.seek(tick));
        await single.close();
      }
      const pair = await openPair(open, '#/forage?preset=foraging-paper&seed=8&b.preset=foraging');
      for (const tick of [130, 1, 65, 0]) {
        await pair.seek(tick);
        assert.deepEqual(await pair.both(tick), { a: alone.get(`foraging-paper ${tick}`), b: alone.get(`foraging ${tick}`) }, `tick ${tick}`);
      }
      await pair.page.locator('#canvas').focus();
      await pair.page.keyboard.press('.');
      assert.deepEqual(await pair.both(1), { a: alone.get('foraging-paper 1'), b: alone.get('foraging 1') });
      await pair.page.keyboard.press('r');
      assert.deepEqual(await pair.both(0), { a: alone.get('foraging-paper 0'), b: alone.get('foraging 0') });
      assert.deepEqual(pair.problems, []);
    },
  ],
  [
    'frames_of_a_and_b_are_drawn_at_one_tick_while_they_play',
    async (open) => {
      const pair = await openPair(open, '#/forage?preset=foraging-paper&b.preset=foraging');
      await pair.page.locator('#max').check();
      await pair.page.locator('#play').click();
      await pair.until(() => Number(document.querySelector('#tick')?.textContent) > 200);
      await pair.page.locator('#play').click();
      const tick = await pair.rest();
      const played = await pair.both(tick);
      await pair.seek(0);
      await pair.seek(tick);
      assert.deepEqual(await pair.both(tick), played, 'a seek to the same tick gives the same two states');
    },
  ],
  [
    'a_cancelled_seek_leaves_both_at_one_tick',
    async (open) => {
      const pair = await openPair(open, '#/forage?preset=foraging-paper&b.preset=foraging');
      await pair.page.locator('#scrub').evaluate((scrub) => {
        /** @type {HTMLInputElement} */ (scrub).value = '12000';
        scrub.dispatchEvent(new Event('input'));
      });
      await pair.inState('busy');
      await pair.page.locator('.busy button').click();
      await pair.inState('paused');
      const tick = await pair.tick();
      assert.ok(tick < 12000);
      await pair.both(tick);
    },
  ],
  [
    'a_run_that_ends_first_stands_at_its_end_while_the_other_goes_on',
    async (open) => {
      const pair = await openPair(open, '#/forage?preset=foraging&seed=6&geese.steps=50&b.geese.steps=120');
      const { page } = pair;
      await eventually(async () => assert.equal(await page.locator('#scrub').getAttribute('max'), '120'));
      await pair.seek(80);
      const ended = await pair.at(80);
      await page.locator('#ab-counts-a').filter({ hasText: 'ended at tick 50: tick limit' }).waitFor();
      assert.equal(await pair.status(), 'Identical so far, up to tick 50');
      await page.locator('#max').check();
      await page.locator('#play').click();
      await pair.inState('finished');
      await eventually(async () => assert.equal(await pair.tick(), 120));
      await eventually(async () => assert.equal(await page.locator('#tag').textContent(), 'Finished: tick limit'));
      const hash = await pair.address(120);
      const again = await openPair(open, hash);
      await again.notice(/Tick 120 is reached and the fingerprint matches/);
      assert.equal(await again.page.locator('.notice.problem').count(), 0);
      await page.getByRole('button', { name: 'A | B', exact: true }).click();
      await page.locator('.ab-arenas').waitFor({ state: 'detached' });
      assert.equal(await pair.at(50), ended, 'A alone stands where it ended');
      assert.equal(await page.locator('#scrub').getAttribute('max'), '50');
      assert.deepEqual(pair.problems, []);
    },
  ],
  [
    'the_link_of_a_pair_gives_the_same_pair_again',
    async (open) => {
      const events = await packed([{ tick: 40, key: 'geese.mutation-probability', value: 0.4 }]);
      for (const said of ['b=same', 'b.preset=geese-bt', 'b.geese.children=12&b.geese.swap-rule=d-gt', `b.preset=foraging-paper&b.geese.children=5&b.events=${events}`]) {
        const first = await openPair(open, `#/forage?preset=foraging&seed=7&${said}`);
        await first.seek(120);
        const found = await first.both(120);
        const hash = await first.address(120);
        assert.ok(hash.includes(`&${said}&b.f=${found.b}&t=120`), hash);
        const second = await openPair(open, hash);
        assert.deepEqual(await second.both(120), found, said);
        await second.notice(/fingerprint matches/);
        assert.equal(await second.page.locator('.notice.problem').count(), 0);
        assert.equal(await second.status(), await first.status());
        await first.close();
        await second.close();
      }
    },
  ],
  [
    'bad_parts_of_b_in_a_link_are_named_and_the_rest_is_applied',
    async (open) => {
      const pair = await openPair(open, '#/forage?preset=foraging&b.preset=nowhere&b.geese.agents=many&b.geese.site-distance=45&b.geese.swap-rule=d-ge&b.seed=4&b.f=zz&b.events=~AAAA');
      await pair.both(0);
      const said = (await pair.page.locator('.notice p').allTextContents()).join('\n');
      assert.match(said, /'b\.events' was left out/);
      assert.match(said, /holds 'b\.seed'/);
      assert.match(said, /'b\.geese\.site-distance' was left out: site-distance: expected at most 40/);
      assert.deepEqual(await pair.page.locator('[data-difference]').evaluateAll((rows) => rows.map((row) => row.getAttribute('data-difference'))), ['geese.swap-rule']);
      const wrong = await openPair(open, '#/forage?preset=foraging&b.preset=foraging-paper&t=10&b.f=0123456789abcdef');
      assert.match((await wrong.notice(/B's fingerprint at tick 10 does not match/)) ?? '', /0123456789abcdef/);
    },
  ],
  [
    'differences_are_added_changed_swapped_and_removed',
    async (open) => {
      const pair = await open('#/forage?preset=foraging&seed=2');
      const { page, until, seek, problems } = pair;
      await seek(80);
      await page.getByRole('button', { name: 'A | B', exact: true }).click();
      await page.locator('.ab-side').nth(1).waitFor();
      await pair.at(80); // A stays at its tick
      await page.locator('.ab-status').filter({ hasText: 'Identical so far, up to tick 80' }).waitFor();
      await page.locator('#ab-add').selectOption('geese.swap-rule');
      await page.locator('.ab-add').getByRole('button', { name: 'Add', exact: true }).click();
      const row = page.locator('[data-difference="geese.swap-rule"]');
      await row.locator('select').selectOption('d-gt');
      await until(() => location.hash.includes('b.geese.swap-rule=d-gt'));
      await page.locator('.ab-status').filter({ hasText: /^Identical until tick \d+/ }).waitFor();
      await pair.at(80);
      const a = await page.locator('#fingerprint').textContent();
      const b = await page.locator('#ab-fingerprint-b').textContent();
      await page.getByRole('button', { name: 'Swap A and B' }).click();
      await until((wanted) => document.querySelector('#fingerprint')?.textContent === wanted, b);
      await until((wanted) => document.querySelector('#ab-fingerprint-b')?.textContent === wanted, a);
      await eventually(async () => assert.match(await pair.hash(), /&geese\.swap-rule=d-gt&b\.geese\.swap-rule=always/));
      await row.getByRole('button', { name: /Remove the difference/ }).click();
      await until((wanted) => document.querySelector('#ab-fingerprint-b')?.textContent === wanted, b);
      await page.locator('.ab-status').filter({ hasText: 'Identical so far, up to tick 80' }).waitFor();
      await page.locator('#ab-from').selectOption('geese-bt');
      await page.locator('[data-difference="geese.behaviours"]').waitFor();
      await page.getByRole('button', { name: 'Make B the same as A' }).click();
      await page.locator('[data-difference]').first().waitFor({ state: 'detached' });
      await page.getByRole('button', { name: 'A | B', exact: true }).click();
      await page.locator('.ab-arenas').waitFor({ state: 'detached' });
      assert.equal(await pair.at(80), b);
      await until(() => !/[?&]b[.=]/.test(location.hash));
      assert.deepEqual(problems, []);
    },
  ],
  [
    'a_value_that_b_cannot_take_is_named_and_b_stays',
    async (open) => {
      const pair = await openPair(open, '#/forage?preset=foraging&seed=2&b.geese.children=12');
      const before = await pair.both(0);
      const { page } = pair;
      const box = page.locator('[data-difference="geese.children"] .ab-in-b > input');
      await box.fill('0');
      await box.press('Enter');
      await page.locator('.ab-editor .field-error').filter({ hasText: "found '0', expected a whole number from 1 to 1000" }).waitFor();
      await page.locator('#ab-add').selectOption('geese.site-distance');
      await page.locator('.ab-add').getByRole('button', { name: 'Add', exact: true }).click();
      const distance = page.locator('[data-difference="geese.site-distance"] .ab-in-b > input');
      await distance.fill('45');
      await distance.press('Enter');
      await page.locator('.ab-editor .field-error').filter({ hasText: 'B was not changed: site-distance: expected at most 40' }).waitFor();
      assert.deepEqual(await pair.both(0), before);
    },
  ],
  [
    'changes_of_a_concern_b_too_unless_b_has_its_own_value',
    async (open) => {
      const pair = await openPair(open, '#/forage?preset=foraging&seed=2&b.geese.fitness-memory=0.5');
      const { page } = pair;
      await pair.openGroups();
      await pair.seek(50);
      const type = async (/** @type {string} */ key, /** @type {string} */ value) => {
        const box = page.locator(`[data-key="${key}"] .number input`);
        await box.fill(value);
        await box.press('Enter');
      };
      await type('geese.mutation-probability', '0.3');
      await pair.until(() => location.hash.includes('&events=~'));
      await type('geese.fitness-memory', '0.7');
      await pair.seek(110);
      const found = await pair.both(110);
      const base = { world: 'geese', seed: 2, 'explore-heading': 'turning', 'mutation-mode': 'codon', 'mutation-probability': 0.1, 'drop-rule': 'sink', 'swap-rule': 'always' };
      const mutation = { tick: 50, key: 'geese.mutation-probability', value: 0.3 };
      const run = async (/** @type {object} */ scenario) => {
        const hash = await page.evaluate(
          async ([address, json]) => {
            const worker = new Worker(/** @type {string} */ (address), { type: 'module' });
            const ask = (/** @type {object} */ message) =>
              new Promise((resolve) => {
                worker.onmessage = (event) => event.data.type !== 'progress' && resolve(event.data);
                worker.postMessage({ id: 1, ...message });
              });
            await ask({ type: 'load', scenario: json });
            const { fingerprint } = await ask({ type: 'seek', tick: 110 });
            worker.terminate();
            return fingerprint;
          },
          /** @type {const} */ ([page.workers()[0].url(), JSON.stringify(scenario)]),
        );
        return hash;
      };
      assert.equal(found.a, await run({ ...base, events: [mutation, { tick: 50, key: 'geese.fitness-memory', value: 0.7 }] }));
      assert.equal(found.b, await run({ ...base, 'fitness-memory': 0.5, events: [mutation] }));
    },
  ],
  [
    'one_number_is_selected_in_both_and_the_inspector_shows_the_side_asked_for',
    async (open) => {
      const pair = await openPair(open, '#/forage?preset=foraging-paper&b.preset=foraging');
      const { page } = pair;
      await pair.seek(300);
      await page.locator('#canvas').focus();
      await page.keyboard.press('End');
      for (const side of ['a', 'b']) await page.locator(`.ab-side[data-side=${side}] .selected-name`).filter({ hasText: 'Robot 99' }).waitFor();
      await page.locator('#tab-agent').click();
      const place = () => page.locator('.facts-list').first().textContent();
      const a = await place();
      await page.locator('.ab-looking').getByRole('button', { name: 'B', exact: true }).click();
      await pair.until((former) => document.querySelector('.facts-list')?.textContent !== former, a);
      assert.equal(await page.locator('.ab-side[data-looked]').getAttribute('data-side'), 'b');
      await page.getByRole('button', { name: 'Table', exact: true }).click();
      await page.locator('.agent-table caption').filter({ hasText: 'Robots of B at tick 300' }).waitFor();
      await page.getByRole('button', { name: 'Table', exact: true }).click();
      await page.locator('#canvas').focus();
      await page.keyboard.press('Home'); // a choice in A's arena looks at A again
      await pair.until(() => document.querySelector('.ab-side[data-looked]')?.getAttribute('data-side') === 'a');
    },
  ],
  [
    'the_chart_shows_both_curves_with_a_table_and_names_them',
    async (open) => {
      const pair = await openPair(open, '#/forage?preset=foraging-paper&b.preset=foraging');
      await pair.seek(900);
      const { page } = pair;
      const counts = await page.locator('#ab-counts-b').textContent();
      const delivered = /Delivered (\d+) of/.exec(counts ?? '')?.[1];
      await page.locator('.ab-chart .said').filter({ hasText: new RegExp(`^Delivered at tick 900: A \\d+, B ${delivered}$`) }).waitFor();
      await page.locator('.ab-chart summary').click();
      const last = page.locator('.ab-chart tbody tr').last();
      await last.locator('th').filter({ hasText: '900' }).waitFor();
      await eventually(async () => assert.equal(await last.locator('td').nth(1).textContent(), delivered));
      await page.locator('.ab-plot canvas').waitFor();
    },
  ],
  [
    'comparisons_are_offered_only_for_presets_that_exist',
    async (open) => {
      const pair = await openPair(open, '#/forage?preset=foraging&seed=11&b=same');
      const { page } = pair;
      const presets = await page.locator('#preset option').evaluateAll((options) => options.map((option) => /** @type {HTMLOptionElement} */ (option).value));
      const offered = await page.locator('#ab-pair option').evaluateAll((options) => options.map((option) => /** @type {HTMLOptionElement} */ (option).value).filter(Boolean));
      assert.equal(offered.includes('paper-published'), presets.includes('published'));
      for (const name of offered) {
        await page.locator('#ab-pair').selectOption(name);
        await pair.until(() => document.body.dataset.state === 'paused' && document.querySelectorAll('[data-difference]').length > 0);
        await pair.both(0);
        await eventually(async () => assert.equal(await page.locator('#ab-pair').inputValue(), name));
        await eventually(async () => assert.equal(await page.locator('#seed').inputValue(), '11'));
      }
      assert.deepEqual(pair.problems, []);
    },
  ],
  [
    'an_engine_that_breaks_in_a_pair_is_replaced_and_both_return_to_their_tick',
    async (open) => {
      const pair = await openPair(open, '#/forage?preset=foraging-paper&b.preset=foraging');
      await pair.seek(70);
      const before = await pair.both(70);
      await pair.page.workers()[1].evaluate(() => self.postMessage({ id: 0, type: 'error', fatal: true, message: 'panicked at a test' }));
      await pair.inState('error');
      await pair.page.getByRole('button', { name: 'Reload at tick 70' }).click();
      await pair.inState('paused');
      assert.deepEqual(await pair.both(70), before);
    },
  ],
  [
    'a_chart_that_asks_an_engine_started_again_before_its_world_is_there_breaks_nothing',
    async (open) => {
      const pair = await openPair(open, '#/forage?preset=foraging-paper&b.preset=foraging');
      const { page } = pair;
      const before = { a: await pair.seek(70), b: (await pair.both(70)).b };
      // B breaks as soon as it has come to tick 71, and the engines are started again at once: the chart, which is drawn ten
      // times a second, asks both for what is new while A still waits for B's world.
      await page.workers()[1].evaluate(() =>
        self.addEventListener('message', ({ data }) => {
          if (data.type === 'seek') setTimeout(() => self.postMessage({ id: 0, type: 'error', fatal: true, message: 'panicked at a test' }), 40);
        }),
      );
      await page.evaluate(() => {
        const watch = new MutationObserver(() => {
          const button = document.querySelector('.fault:not([hidden]) button.primary');
          if (button?.textContent?.startsWith('Reload at')) {
            watch.disconnect();
            /** @type {HTMLElement} */ (button).click();
            /** @type {any} */ (globalThis).startedAgain = true;
          }
        });
        watch.observe(document.body, { subtree: true, childList: true, attributes: true });
      });
      await page.locator('[data-action=forward]').first().click();
      await pair.until(() => /** @type {any} */ (globalThis).startedAgain); // before that, tick 71 is the one of the engines that break
      await pair.at(71);
      await pair.seek(70);
      assert.deepEqual(await pair.both(70), before);
      assert.equal(await page.locator('.fault').isVisible(), false);
    },
  ],
  [
    'a_pair_is_opened_and_left_by_keyboard_alone_and_back_leaves_it',
    async (open) => {
      const { page, seek, until, at, problems } = await open('#/forage?preset=foraging&seed=4');
      const fingerprint = await seek(30);
      await page.locator('#canvas').focus();
      await page.keyboard.press('a');
      await page.locator('.ab-side[data-side=b] #canvas-b').waitFor();
      assert.equal(await at(30), fingerprint);
      await until(() => location.hash.includes('b=same') && location.hash.includes('t=30'));
      await page.locator('#canvas-b').focus();
      await page.keyboard.press('Home');
      await page.locator('.ab-side[data-side=b] .selected-name').filter({ hasText: 'Robot 0' }).waitFor();
      await page.keyboard.press('.');
      await at(31);
      await page.locator('#ab-pair').focus();
      for (let press = 0; press < 8; press += 1) await page.keyboard.press('Tab');
      await eventually(async () => assert.ok(await page.evaluate(() => document.activeElement !== document.body && !document.activeElement?.matches('#ab-pair')), 'Tab leaves the editor'));
      await page.locator('#canvas-b').focus();
      await page.keyboard.press('a');
      await page.locator('.ab-arenas').waitFor({ state: 'detached' });
      await at(31);
      await page.goBack();
      await page.locator('.ab-arenas').waitFor();
      await page.goBack();
      await page.locator('.ab-arenas').waitFor({ state: 'detached' });
      await at(30);
      assert.deepEqual(problems, []);
    },
  ],
  [
    'reduced_motion_opens_a_pair_without_playing_it',
    async (open) => {
      const pair = await openPair(open, '#/forage?preset=foraging&b.preset=foraging-paper');
      await pair.inState('paused');
      assert.equal(await pair.tick(), 0);
      const moving = await openPair(open, '#/forage?preset=foraging&b.preset=foraging-paper', { reducedMotion: 'no-preference' });
      await moving.inState('running');
      await moving.until(() => Number(document.querySelector('#tick')?.textContent) >= 3);
      assert.deepEqual(moving.problems, []);
    },
  ],
  [
    'the_first_load_holds_nothing_of_a_and_b',
    async (open) => {
      const { page } = await open();
      const names = await page.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name).filter((name) => /compare|uPlot/i.test(name)));
      assert.deepEqual(names, []);
    },
  ],
  ...['light', 'dark'].flatMap((colorScheme) =>
    [1440, 1024, 390].map((width) => /** @type {import('./browser.mjs').Case} */ ([
      `axe_finds_nothing_in_a_pair_in_${colorScheme}_at_${width}_pixels`,
      async (open) => {
        const phone = width < 900;
        const pair = await openPair(open, '#/forage?preset=foraging-paper&b.preset=foraging', {
          colorScheme: /** @type {'light' | 'dark'} */ (colorScheme),
          viewport: { width, height: phone ? 844 : 900 },
          hasTouch: phone,
          isMobile: phone,
        });
        await pair.seek(100);
        await pair.page.locator('.ab-chart summary').click();
        await pair.page.locator('.ab-chart tbody tr').first().waitFor();
        assert.deepEqual(await violations(pair.page), []);
        await pair.page.locator('#canvas').focus();
        await pair.page.keyboard.press('Home');
        await pair.page.locator('#tab-agent').click();
        await pair.page.locator('.fitness-list').waitFor();
        assert.deepEqual(await violations(pair.page), [], 'with a robot chosen');
      },
    ])),
  ),
  ...[320, 768].map((width) => /** @type {import('./browser.mjs').Case} */ ([
    `a_pair_scrolls_nothing_sideways_at_${width}_pixels`,
    async (open) => {
      const pair = await openPair(open, '#/forage?preset=foraging-paper&b.preset=geese-bt', { viewport: { width, height: 640 }, hasTouch: true });
      await pair.seek(50);
      await pair.page.locator('.ab-chart summary').click();
      const { scroll, client } = await pair.page.evaluate(() => ({ scroll: document.documentElement.scrollWidth, client: document.documentElement.clientWidth }));
      assert.ok(scroll <= client, `${scroll} pixels in a window of ${client}`);
    },
  ])),
];
