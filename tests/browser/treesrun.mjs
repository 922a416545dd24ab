import assert from 'node:assert/strict';
import { SMALL, documentOf, openBench, packed } from './bench.mjs';
import { eventually } from './browser.mjs';

const RETRY = documentOf('<RetryUntilSuccessful num_attempts="3"><Push/></RetryUntilSuccessful>', '<Action ID="Push"/>');
const FAILING = JSON.stringify([{ tick: 0, leaf: 'Push', then: 'FAILURE' }]);

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'tree_steps_forward_and_back_plays_and_is_scrubbed',
    async (open) => {
      const { page, at, step, seek, inState, until } = await openBench(open, `#/trees?xml=${packed(SMALL)}`);
      const start = await at(0);
      await step();
      const first = await at(1);
      assert.notEqual(first, start);
      await step(2);
      await at(3);
      await page.locator('#trees [data-action=back]').click();
      await at(2);
      await eventually(async () => assert.equal(await page.locator('#trees-scrub').getAttribute('max'), '3'));
      assert.equal(await seek(1), first);
      await page.locator('#trees-speed').fill('100');
      await page.locator('#trees .play').click();
      await inState('running');
      await until(() => Number(document.querySelector('#trees-tick')?.textContent) > 20);
      await page.keyboard.press(' ');
      await inState('paused');
      assert.equal(await seek(1), first);
      await page.locator('#trees [data-action=restart]').click();
      assert.equal(await at(0), start);
      await eventually(async () => assert.equal(await page.locator('#trees-scrub').getAttribute('max'), '0'));
    },
  ],
  [
    'leaf_is_scripted_by_pressing_its_answer',
    async (open) => {
      const { page, at, step, node, returned, tab, until } = await openBench(open, `#/trees?xml=${packed(SMALL)}`);
      await at(0);
      await node('Near').locator('.bench-answer').click();
      await tab('script');
      await page.getByText('Near → FAILURE').waitFor();
      await step();
      await returned('Near', 'FAILURE');
      await at(1);
      await node('Near').locator('.bench-answer').click();
      await page.getByText('Near → RUNNING').waitFor();
      await step();
      await returned('Near', 'RUNNING');
      await at(2);
      for (const _ of [1, 2]) await node('Near').locator('.bench-answer').click();
      await until(() => document.querySelectorAll('.events tbody tr').length === 3);
      await page.locator('.events tbody tr').nth(2).getByRole('button', { name: /Remove/ }).click();
      await until(() => document.querySelectorAll('.events tbody tr').length === 2);
      await step();
      await returned('Near', 'RUNNING');
    },
  ],
  [
    'leaf_is_scripted_by_keys_and_an_answer_in_force_is_no_event',
    async (open) => {
      const { page, at, node, tab, until } = await openBench(open, `#/trees?xml=${packed(SMALL)}`);
      await at(0);
      await tab('script');
      await node('grasp').focus();
      for (const [key, status] of [['f', 'FAILURE'], ['r', 'RUNNING'], ['k', 'SKIPPED']]) {
        await page.keyboard.press(key);
        await page.getByText(`grasp → ${status}`).waitFor();
        assert.equal(await page.locator('.events tbody tr').count(), 1);
      }
      await page.keyboard.press('s');
      await until(() => document.querySelector('.events tbody')?.children.length === 0);
      await eventually(async () => assert.equal(await page.evaluate(() => document.activeElement?.getAttribute('role')), 'treeitem'));
      await page.keyboard.press('.');
      await at(1);
      await page.keyboard.press(',');
      await at(0);
    },
  ],
  [
    'leaf_answers_after_ticks_running_and_writes_its_outputs',
    async (open) => {
      const xml = documentOf('<Sequence><Look found="{target}"/><Grasp/></Sequence>', '<Action ID="Look"><output_port name="found"/></Action><Action ID="Grasp"/>');
      const { page, at, step, select, selected, tab, root } = await openBench(open, `#/trees?xml=${packed(xml)}`);
      await at(0);
      await select('Look');
      await page.locator('#trees-running').fill('2');
      await page.locator('#trees-running').press('Enter');
      await page.getByLabel('writes to found').fill('cup');
      await page.getByLabel('writes to found').press('Enter');
      await page.locator('.trees-bar').getByRole('button', { name: 'Undo' }).waitFor();
      await step(2);
      await at(2);
      await eventually(async () => assert.match((await root()) ?? '', /RUNNING/));
      await page.getByText('2 ticks RUNNING so far').waitFor();
      await step();
      await at(3);
      await eventually(async () => assert.match((await root()) ?? '', /SUCCESS/));
      await tab('board');
      const row = page.locator('[data-entry=target]');
      await eventually(async () => assert.equal(await row.locator('input').inputValue(), 'cup'));
      await eventually(async () => assert.match((await row.textContent()) ?? '', /text.*Look.*tick 3/));
      await row.getByRole('button', { name: 'Look' }).click();
      await selected('Look');
    },
  ],
  [
    'blackboard_is_written_by_hand',
    async (open) => {
      const xml = documentOf('<Sequence><ScriptCondition code="charge &gt; 20"/><Grasp/></Sequence>', '<Action ID="Grasp"/>');
      const { page, at, step, tab, root, until } = await openBench(open, `#/trees?xml=${packed(xml)}`);
      await at(0);
      await tab('board');
      await page.getByLabel('Name', { exact: true }).fill('charge');
      await page.getByLabel('Value', { exact: true }).fill('50');
      await page.getByRole('button', { name: 'Write' }).click();
      await page.locator('[data-entry=charge]').waitFor();
      await step();
      await at(1);
      await eventually(async () => assert.match((await root()) ?? '', /SUCCESS/));
      await page.getByLabel('Value of charge').fill('10');
      await page.getByLabel('Value of charge').press('Enter');
      await until(() => document.querySelector('[data-entry=charge]')?.textContent?.includes('by hand'));
      await step();
      await at(2);
      await eventually(async () => assert.match((await root()) ?? '', /FAILURE/));
      await page.getByLabel('Name', { exact: true }).fill('@everywhere');
      await page.getByLabel('Name', { exact: true }).press('Enter');
      await page.locator('[data-entry="@everywhere"]').waitFor();
      await tab('script');
      await page.getByText('charge := 10').waitFor();
    },
  ],
  [
    'log_tells_returns_in_order_halts_and_errors',
    async (open) => {
      const xml = documentOf('<ReactiveFallback><Near/><Walk/></ReactiveFallback>', '<Condition ID="Near"/><Action ID="Walk"/>');
      const script = JSON.stringify([{ tick: 0, leaf: 'Near', then: 'FAILURE' }, { tick: 0, leaf: 'Walk', then: 'RUNNING' }, { tick: 1, leaf: 'Near', then: 'SUCCESS' }]);
      const { page, at, step, tab, type, problems } = await openBench(open, `#/trees?xml=${packed(xml)}&script=${packed(script)}`);
      await at(0);
      await tab('log');
      await page.getByText('No tick yet.').waitFor();
      await step();
      await at(1);
      await eventually(async () => assert.deepEqual(await page.locator('#trees-trace li').allTextContents(), ['Near✗FAILURE', 'Walk▸RUNNING', 'ReactiveFallback▸RUNNING']));
      await step();
      await at(2);
      await eventually(async () => assert.deepEqual(await page.locator('#trees-trace li').allTextContents(), ['Near✓SUCCESS', 'ReactiveFallback✓SUCCESS']));
      await eventually(async () => assert.deepEqual(await page.locator('#trees-halted li').allTextContents(), ['Walk■HALTED']));
      await tab('script');
      await page.getByRole('button', { name: 'Halt the tree now' }).click();
      await page.getByText('the whole tree is halted').waitFor();
      await type(documentOf('<ScriptCondition name="ask" code="nothing == 1"/>'));
      await problems('No problems');
      await page.locator('.tick-fault').filter({ hasText: /Tick 2 ended with an error in ask: .*nothing/ }).waitFor();
      await tab('log');
      await page.locator('.tick-error').filter({ hasText: /ask.*nothing/ }).waitFor();
    },
  ],
  [
    'a_tick_is_one_pass_or_as_many_as_it_takes',
    async (open) => {
      const { page, at, step, root, tab, until } = await openBench(open, `#/trees?xml=${packed(RETRY)}&script=${packed(FAILING)}`);
      await at(0);
      await step();
      await at(1);
      await eventually(async () => assert.match((await root()) ?? '', /FAILURE/));
      await tab('log');
      await page.getByText('3 passes from the root').waitFor();
      await page.locator('#trees-mode').selectOption('exactly_once');
      await until(() => document.querySelector('#trees-root')?.textContent?.includes('RUNNING'));
      await page.getByText('a retry of three attempts is three ticks').waitFor();
      await step(2);
      await at(3);
      await eventually(async () => assert.match((await root()) ?? '', /FAILURE/));
      await page.locator('#trees-ms').fill('40');
      await page.locator('#trees-ms').press('Enter');
      await page.getByText('120 ms of simulated time').waitFor();
      await page.locator('#trees-ms').fill('-1');
      await page.locator('#trees-ms').press('Enter');
      await page.getByText("found '-1', expected a whole number from 0 to 3600000").waitFor();
    },
  ],
  [
    'breakpoint_pauses_selects_its_node_and_says_so',
    async (open) => {
      const { page, at, select, inState, notice } = await openBench(open, `#/trees?xml=${packed(SMALL)}&script=${packed(JSON.stringify([{ tick: 4, leaf: 'Near', then: 'FAILURE' }]))}`);
      await at(0);
      await select('Near');
      await page.getByLabel('returns FAILURE').check();
      await select('Both');
      await page.locator('#trees-speed').fill('100');
      await page.locator('#trees .play').click();
      await notice(/Paused at tick 5: Near returned FAILURE/);
      await inState('paused');
      await at(5);
      await eventually(async () => assert.equal(await page.locator('#panel-node h2').textContent(), 'Near'));
      await eventually(async () => assert.match((await page.locator('#live').textContent()) ?? '', /tick 5/));
      await page.getByLabel('returns FAILURE').uncheck();
      await page.locator('#trees-complete').check();
      await page.locator('#trees .play').click();
      await notice(/Paused at tick 6: Both returned FAILURE/);
      await at(6);
    },
  ],
  [
    'kinds_are_compared_side_by_side_in_lockstep',
    async (open) => {
      const { page, at, step } = await openBench(open);
      await at(2);
      const kinds = page.locator('.compare-panel h3');
      await eventually(async () => assert.deepEqual(await kinds.allTextContents(), ['Sequence', 'ReactiveSequence', 'SequenceWithMemory']));
      await page.locator('.compare-sentence').filter({ hasText: 'They differ first in tick 2: ReactiveSequence' }).waitFor();
      await step();
      await at(3);
      await page.locator('.compare-panel').filter({ hasText: 'Leaves in tick 3' }).nth(2).waitFor();
      await page.locator('.compare-switch').click();
      await page.locator('.compare').waitFor({ state: 'hidden' });
      await page.locator('.trees-stage > .bench').waitFor();
      await page.locator('.compare-switch').click();
      await kinds.nth(2).waitFor();
    },
  ],
  [
    'comparison_is_part_of_the_link_and_reopened_by_it',
    async (open) => {
      const xml = packed(documentOf('<Fallback><Near/><Grasp/></Fallback>', '<Condition ID="Near"/><Action ID="Grasp"/>'));
      const first = await openBench(open, `#/trees?xml=${xml}&length=3&t=3`);
      await first.at(3);
      await first.page.locator('.compare-switch').click();
      await first.page.locator('.compare-panel').nth(1).waitFor();
      await first.until(() => location.hash.includes('&compare=3.5&'));
      const again = await openBench(open, await first.hash());
      await again.page.locator('.compare-panel h3').filter({ hasText: 'ReactiveFallback' }).waitFor();
      await again.until(() => location.hash.includes('&compare=3.5&'));
      await again.page.locator('.compare-switch').click();
      await again.until(() => !location.hash.includes('compare='));
      // The opening tree is compared by itself: its link says when it is not.
      const plain = await openBench(open);
      await plain.page.locator('.compare-panel').nth(2).waitFor();
      await plain.until(() => location.hash.includes('&t=2&') && !location.hash.includes('compare='));
      await plain.page.locator('.compare-switch').click();
      await plain.until(() => location.hash.includes('&compare=none&'));
      const closed = await openBench(open, await plain.hash());
      await closed.at(2);
      await closed.until(() => location.hash.includes('&compare=none&'));
      assert.equal(await closed.page.locator('.compare').isVisible(), false);
      const bad = await openBench(open, `#/trees?xml=${xml}&compare=sideways`);
      await bad.notice(/'compare' was left out: found 'sideways', expected line and column as in 3\.5, or none/);
      const nowhere = await openBench(open, `#/trees?xml=${xml}&compare=9.9`);
      await nowhere.notice(/'compare' was left out: no sequence or fallback stands at line 9, column 9/);
      for (const { said } of [first, again, plain, closed, bad, nowhere]) assert.deepEqual(said(), []);
    },
  ],
  ...[
    ['ticks', documentOf('<AlwaysSuccess/>'), 100_000],
    // 901 nodes return in each tick, and a timeline keeps 2^23 returns.
    ['returns', documentOf(`<Sequence>${'<AlwaysSuccess/>'.repeat(900)}</Sequence>`), Math.ceil(2 ** 23 / 901)],
  ].map(([what, xml, last]) => /** @type {import('./browser.mjs').Case} */ ([
    `a_timeline_full_of_${what}_ends_the_run_and_says_why`,
    async (open) => {
      const { page, at, inState, seek, said } = await openBench(open, `#/trees?xml=${packed(String(xml))}&length=${Number(last) - 40}&t=${Number(last) - 40}`);
      await at(Number(last) - 40);
      await inState('paused');
      await page.locator('#trees .play').click();
      await inState('finished');
      await at(Number(last));
      await page.locator('#trees .tag').filter({ hasText: 'no further tick can be recorded' }).waitFor();
      assert.ok(await page.locator('#trees .play').isDisabled());
      await seek(Number(last) - 1);
      await inState('paused');
      await page.locator('#trees [data-action=forward]').click();
      await inState('finished');
      assert.deepEqual(said(), []);
    },
  ])),
  [
    'comparison_needs_a_sequence_or_fallback',
    async (open) => {
      const { page, at } = await openBench(open, `#/trees?xml=${packed(documentOf('<AlwaysSuccess/>'))}`);
      await at(0);
      await eventually(async () => assert.ok(await page.locator('.compare-switch').isDisabled()));
    },
  ],
  [
    'broken_tree_engine_is_replaced_and_taken_to_its_tick',
    async (open) => {
      const { page, seek, inState, at } = await openBench(open, `#/trees?preset=retry`);
      const before = await seek(3);
      await page.workers()[0].evaluate(() => self.postMessage({ id: 0, type: 'error', fatal: true, message: 'panicked at a test' }));
      await inState('error');
      await page.locator('#trees .fault').filter({ hasText: 'panicked at a test' }).waitFor();
      await page.getByRole('button', { name: 'Reload at tick 3' }).click();
      assert.equal(await at(3), before);
      await eventually(async () => assert.equal(await page.locator('#trees .fault').isVisible(), false));
    },
  ],
];
