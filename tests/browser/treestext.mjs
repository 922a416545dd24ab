import assert from 'node:assert/strict';
import { SMALL, documentOf, openBench } from './bench.mjs';
import { eventually } from './browser.mjs';

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'pasted_tree_is_drawn_and_its_faults_stand_at_their_places',
    async (open) => {
      const { page, editor, problemTexts, problems: counted, node } = await openBench(open, '#/trees?preset=retry', { permissions: ['clipboard-read', 'clipboard-write'] });
      const faulty = '<root BTCPP_format="4">\n  <BehaviorTree ID="Main">\n    <Sequnce>\n      <Sleep msec="soon" port="1"/>\n      <ScriptCondition code="a &gt; &gt; 2"/>\n    </Sequnce>\n  </BehaviorTree>\n</root>';
      await page.evaluate((xml) => navigator.clipboard.writeText(xml), faulty);
      await editor.focus();
      await page.keyboard.press('Control+a');
      await page.keyboard.press('Control+v');
      await counted('4 faults');
      const found = await problemTexts();
      assert.match(found[0], /line 3, column 5: unknown node "Sequnce", did you mean "Sequence"\?/);
      assert.match(found[1], /line 4, column 20: /);
      assert.match(found[2], /line 4, column 26: unknown port "port"/);
      assert.match(found[3], /line 5, column 37: expected a number, text or name/);
      await eventually(async () => assert.equal((await page.locator('.cm-lintRange-error').allTextContents()).join(' '), '<Sequnce s port &'));
      await eventually(async () => assert.equal(await page.locator('.cm-lint-marker-error').count(), 3));
      await page.locator('.problem').nth(2).click();
      await eventually(async () => assert.equal(await editor.evaluate(() => document.querySelector('.trees-code')?.shadowRoot?.activeElement?.className.includes('cm-content')), true));
      await page.keyboard.type('x');
      await page.getByText('unknown port "xport"').waitFor();
      await page.evaluate((xml) => navigator.clipboard.writeText(xml), SMALL);
      await page.keyboard.press('Control+a');
      await page.keyboard.press('Control+v');
      await counted('No problems');
      await node('grasp').waitFor();
    },
  ],
  [
    'columns_count_characters_where_the_editor_counts_units',
    async (open) => {
      const { page, type, problems, problemTexts } = await openBench(open);
      await type(documentOf('<Sequence><Script code="a := \'🤖🤖\'"/><Nowhere/></Sequence>'));
      await problems('1 fault');
      assert.match((await problemTexts())[0], /line 3, column 41: unknown node "Nowhere"/);
      await eventually(async () => assert.equal(await page.locator('.cm-lintRange-error').textContent(), '<Nowhere'));
    },
  ],
  [
    'last_valid_tree_goes_on_while_the_text_has_faults',
    async (open) => {
      const { page, type, problems, node, at, step, tab, until } = await openBench(open, '#/trees?preset=guards&t=2');
      await type(SMALL);
      await node('grasp').waitFor();
      await at(2);
      await step();
      const before = await at(3);
      await page.keyboard.press('Tab');
      await type(SMALL.replace('<Near/>', '<Near>'));
      await problems('fault');
      await page.getByText('Shows the last valid tree').waitFor();
      assert.equal(await at(3), before);
      await step();
      await at(4);
      await tab('script');
      await page.getByLabel('Near returns').selectOption('FAILURE');
      await step();
      await at(5);
      await until(() => document.querySelector('#trees-root')?.textContent?.includes('FAILURE'));
      await page.getByText('Shows the last valid tree').waitFor();
      await type(SMALL);
      await problems('No problems');
      await page.getByText('Shows the last valid tree').waitFor({ state: 'hidden' });
    },
  ],
  [
    'a_fix_replaces_a_misspelt_name_in_both_tags',
    async (open) => {
      const { page, type, problems, text } = await openBench(open);
      await type(documentOf('<Sequnce><AlwaysSuccess/></Sequnce>'));
      await problems('1 fault');
      await page.getByRole('button', { name: 'Replace by Sequence' }).click();
      await problems('No problems');
      await eventually(async () => assert.ok((await text()).includes('<Sequence><AlwaysSuccess/></Sequence>')));
      await page.locator('.trees-bar').getByRole('button', { name: 'Undo' }).click();
      await problems('1 fault');
    },
  ],
  [
    'a_fix_declares_a_node_with_the_ports_it_is_given',
    async (open) => {
      const { page, type, problems, text, node } = await openBench(open);
      await type('<root BTCPP_format="4">\n  <BehaviorTree ID="Main">\n    <Fetch item="{x}" speed="3"/>\n  </BehaviorTree>\n</root>\n');
      await problems('1 fault');
      await page.getByRole('button', { name: 'Declare Fetch as action' }).click();
      await problems('No problems');
      const written = await text();
      assert.ok(written.includes('<TreeNodesModel>\n    <Action ID="Fetch">\n      <inout_port name="item"/>\n      <input_port name="speed"/>\n    </Action>\n  </TreeNodesModel>\n</root>'), written);
      await node('Fetch').waitFor();
      await eventually(async () => assert.ok(await page.locator('.bench-answer').first().isVisible()));
    },
  ],
  [
    'names_and_ports_are_completed_also_those_of_the_document',
    async (open) => {
      const { page, editor, type, problems, text } = await openBench(open);
      await type(documentOf('<Sequence></Sequence>', '<Action ID="Grasp"><input_port name="strength"/></Action>'));
      await problems('1 fault');
      await editor.locator('.cm-line').nth(2).click();
      await page.keyboard.press('Home');
      for (let count = 0; count < '<Sequence>'.length; count += 1) await page.keyboard.press('ArrowRight');
      await page.keyboard.type('<Gra');
      await page.locator('.cm-tooltip-autocomplete li').filter({ hasText: 'Grasp' }).waitFor();
      await page.waitForTimeout(100); // a list that has just opened takes no key, lest it takes one meant for the text
      await page.keyboard.press('Enter');
      await page.keyboard.type(' str');
      await page.locator('.cm-tooltip-autocomplete li').filter({ hasText: 'strength' }).waitFor();
      await page.keyboard.press('Escape');
      await page.keyboard.type('ength="2"/>');
      await problems('No problems');
      await eventually(async () => assert.ok((await text()).includes('<Sequence><Grasp strength="2"/></Sequence>')));
    },
  ],
  [
    'one_history_takes_back_text_and_script',
    async (open) => {
      const { page, type, problems, tab, until, text, said } = await openBench(open);
      await type(SMALL);
      await problems('No problems');
      await tab('script');
      await page.getByLabel('Near returns').selectOption('FAILURE');
      await page.getByText('Script, 7 events').waitFor();
      await page.locator('#trees-mode').selectOption('exactly_once');
      await page.locator('#trees-ms').fill('250');
      await page.locator('#trees-ms').press('Enter');
      await page.locator('.trees-stage').click({ position: { x: 60, y: 200 } });
      const shown = () => page.evaluate(() => [/** @type {HTMLInputElement} */ (document.querySelector('#trees-mode')).value, /** @type {HTMLInputElement} */ (document.querySelector('#trees-ms')).value]);
      await eventually(async () => assert.deepEqual(await shown(), ['exactly_once', '250']));
      await page.keyboard.press('Control+z');
      await until(() => /** @type {HTMLInputElement} */ (document.querySelector('#trees-ms')).value === '100');
      await page.keyboard.press('Control+z');
      await until(() => /** @type {HTMLInputElement} */ (document.querySelector('#trees-mode')).value === 'once');
      await page.keyboard.press('Control+z');
      await page.getByText('Script, 6 events').waitFor();
      await page.locator('.trees-bar').getByRole('button', { name: 'Undo' }).click();
      await until(() => document.querySelector('.trees-code')?.shadowRoot?.querySelector('.cm-content')?.textContent?.includes('BallSeen'));
      await eventually(async () => assert.ok(await page.locator('.trees-bar').getByRole('button', { name: 'Undo' }).isDisabled()));
      for (const key of ['Control+Shift+z', 'Control+y', 'Control+y']) await page.keyboard.press(key);
      await page.locator('.trees-bar').getByRole('button', { name: 'Redo' }).click();
      await page.getByText('Script, 7 events').waitFor();
      assert.deepEqual(await shown(), ['exactly_once', '250']);
      await eventually(async () => assert.ok((await text()).includes('grasp')));
      assert.deepEqual(said(), [], 'typing over a selection breaks no policy');
    },
  ],
  [
    'cursor_selects_its_node_and_a_node_marks_its_line',
    async (open) => {
      const { page, editor, type, problems, select, selected, until } = await openBench(open, '#/trees?preset=retry');
      await type(SMALL.replace('<Near/>', '\n<Near/>\n'));
      await problems('No problems');
      await editor.locator('.cm-line').nth(3).click();
      await page.locator('#panel-node h2').filter({ hasText: 'Near' }).waitFor();
      await selected('Near');
      await page.keyboard.press('Escape');
      await until(() => document.activeElement?.matches('.problems-bar button'));
      await select('grasp');
      await page.locator('.cm-node').filter({ hasText: 'grasp' }).waitFor();
      await eventually(async () => assert.ok(await page.evaluate(() => document.activeElement?.matches('[role=treeitem]')), 'the focus stays in the drawing'));
      await page.getByRole('button', { name: 'Go to line 5' }).click();
      await eventually(async () => assert.ok(await page.evaluate(() => document.activeElement?.matches('.trees-code'))));
    },
  ],
  [
    'text_is_folded_and_searched',
    async (open) => {
      const { page, editor } = await openBench(open);
      const lines = await editor.locator('.cm-line').count();
      await page.locator('.cm-foldGutter .cm-gutterElement').filter({ hasText: '▾' }).nth(2).click();
      await page.locator('.cm-foldPlaceholder').waitFor();
      await eventually(async () => assert.ok((await editor.locator('.cm-line').count()) < lines));
      await page.getByRole('button', { name: 'Find', exact: true }).click();
      await page.locator('.cm-search input[name=search]').pressSequentially('Grasp');
      await page.keyboard.press('Enter');
      await page.locator('.cm-searchMatch-selected').waitFor();
      await eventually(async () => assert.equal(await editor.locator('.cm-foldPlaceholder').count(), 0, 'a hit is unfolded'));
    },
  ],
];
