import assert from 'node:assert/strict';
import { eventually } from './browser.mjs';

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'click_on_a_robot_opens_it',
    async (open) => {
      const { page, seek } = await open();
      await seek(40);
      await page.locator('#canvas').focus();
      await page.keyboard.press('Home');
      await page.locator('.selected-name').filter({ hasText: 'Robot 0' }).waitFor();
      const ring = await page.locator('.selected-ring').evaluate((circle) => [Number(circle.getAttribute('cx')), Number(circle.getAttribute('cy'))]);
      await page.keyboard.press('Escape');
      await page.locator('.selected-name').filter({ hasNotText: 'Robot' }).waitFor({ state: 'attached' });
      await page.locator('#canvas').click({ position: { x: ring[0], y: ring[1] } });
      await page.locator('.selected-name').filter({ hasText: /Robot \d+/ }).waitFor();
      await page.locator('#tab-agent').click();
      await page.locator('.facts-list dd').filter({ hasText: 'Hub' }).first().waitFor();
    },
  ],
  [
    'another_click_takes_the_next_robot_at_the_spot',
    async (open) => {
      const { page, at } = await open();
      await at(0); // every robot starts at the hub, in the middle
      const box = await page.locator('#canvas').boundingBox();
      assert.ok(box);
      const position = { x: box.width / 2, y: box.height / 2 };
      await page.locator('#canvas').click({ position });
      await page.locator('.selected-name').filter({ hasText: /Robot \d+/ }).waitFor();
      const first = await page.locator('.selected-name').textContent();
      await page.locator('#canvas').click({ position });
      await page.locator('.selected-name').filter({ hasNotText: new RegExp(`^${first}$`) }).filter({ hasText: 'Robot' }).waitFor();
      await page.locator('#tab-agent').click();
      await page.locator('.under .chip').nth(1).waitFor();
    },
  ],
  [
    'robots_are_reached_by_keyboard_alone',
    async (open) => {
      const { page, seek } = await open();
      await seek(60);
      await page.locator('#canvas').focus();
      await page.keyboard.press('End');
      const name = page.locator('.selected-name');
      await name.filter({ hasText: 'Robot 99' }).waitFor();
      for (const key of ['ArrowLeft', 'ArrowUp', 'ArrowRight', 'ArrowDown']) await page.keyboard.press(key);
      // Label and inspector follow with the next frames: wait until both name the same robot.
      await page.waitForFunction(() => {
        const named = document.querySelector('.selected-name')?.textContent ?? '';
        const pressed = document.querySelector('.scopes button[aria-pressed=true]')?.textContent ?? '';
        return /Robot \d+/.test(named) && pressed.includes(named.trim());
      });
    },
  ],
  [
    'node_of_the_tree_rings_robots_and_shows_status_in_its_name',
    async (open) => {
      const { page, seek } = await open();
      await seek(120);
      const root = page.locator('[role=treeitem]').first();
      await root.waitFor();
      await root.click();
      await page.locator('.said').filter({ hasText: /reached this node in the last tick/ }).waitFor();
      await eventually(async () => assert.match((await root.locator('title').textContent()) ?? '', /reached by \d+ %/));
      await page.locator('#canvas').focus();
      await page.keyboard.press('Home');
      await page.locator('[role=treeitem][data-status=SUCCESS], [role=treeitem][data-status=FAILURE]').first().waitFor();
      await page.locator('[role=treeitem]').first().focus();
      await page.keyboard.press('ArrowRight');
      await eventually(async () => assert.equal(await page.evaluate(() => document.activeElement?.getAttribute('data-id')), '1'));
      await page.keyboard.press('ArrowLeft');
      await page.locator('[role=treeitem][data-id="1"][aria-expanded=false], [role=treeitem][data-id="0"]:focus').first().waitFor();
    },
  ],
  [
    'genome_is_a_what_if_that_never_touches_the_run',
    async (open) => {
      const { page, seek, at } = await open();
      const before = await seek(80);
      await page.locator('#canvas').focus();
      await page.keyboard.press('Home');
      await page.locator('#tab-genome').click();
      const codon = page.locator('.codon').nth(1);
      await page.locator('.codon[aria-label*="choice"]').first().waitFor();
      const value = Number(await codon.textContent());
      await codon.focus();
      await page.keyboard.press('ArrowUp');
      await page.locator('.what-if').waitFor();
      await eventually(async () => assert.equal(Number(await codon.textContent()), (value + 1) % 256));
      await page.locator('.what-if button').click();
      await page.locator('.what-if').waitFor({ state: 'hidden' });
      await eventually(async () => assert.equal(Number(await codon.textContent()), value));
      assert.equal(await at(80), before);
    },
  ],
  [
    'genome_tab_says_what_a_genome_is_and_leads_to_the_lesson_that_shows_it',
    async (open) => {
      const { page } = await open();
      await page.locator('#tab-genome').click();
      const about = page.locator('#panel-genome p').first();
      await about.filter({ hasText: /genome is .* codon, picks .* program/ }).waitFor();
      await about.getByRole('link', { name: 'Lesson 5 shows how' }).click();
      await page.locator('.lesson h2').filter({ hasText: 'From codons to trees' }).waitFor();
      await about.waitFor(); // the tab stands beside the lesson, which needs no way to itself
      assert.equal(await about.getByRole('link').count(), 0);
    },
  ],
  [
    'charts_have_a_data_table',
    async (open) => {
      const { page, seek } = await open();
      await seek(400);
      await page.locator('#tab-charts').click();
      await page.locator('.uplot').nth(1).waitFor();
      await page.locator('.numbers summary').click();
      await page.locator('.numbers tbody tr').nth(10).waitFor();
      assert.equal(await page.locator('.numbers tbody th').first().textContent(), '0');
    },
  ],
  [
    'table_lists_every_robot',
    async (open) => {
      const { page, at } = await open();
      await at(0);
      await page.getByRole('button', { name: 'Table', exact: true }).click();
      await page.locator('.agent-table tbody tr').nth(99).waitFor();
      await page.locator('.agent-table tbody tr').nth(7).getByRole('button').click();
      await eventually(async () => assert.equal(await page.locator('.agent-table tr.chosen th').textContent(), '7'));
    },
  ],
  [
    'machine_is_shown_as_rules_with_its_state_and_the_rule_that_fired',
    async (open) => {
      const { page, seek } = await open('#/forage?preset=hand-machine', { acceptDownloads: true });
      await seek(60);
      const rules = page.locator('#panel-tree .machine-rules tbody tr');
      await rules.nth(4).waitFor();
      await eventually(async () => assert.equal(await rules.count(), 5));
      await eventually(async () => assert.match((await rules.first().textContent()) ?? '', /In.*MoveTowards Hub.*If.*IsCarrying Food.*Go to.*CompositeDrop Food/));
      // Of all robots: shares, and a rule rings those for which it fired.
      await rules.nth(2).getByRole('button').click();
      await page.locator('.said').filter({ hasText: /robots? fired this rule in the last tick/ }).waitFor();
      // Of one robot: exactly one state is the present one.
      await page.locator('#canvas').focus();
      await page.keyboard.press('Home');
      await page.locator('.machine-states tr.chosen').filter({ hasText: '● here' }).waitFor();
      await eventually(async () => assert.equal(await page.locator('.machine-states tr.chosen').count(), 1));
      assert.equal(await page.getByRole('button', { name: 'Open in workbench' }).isVisible(), false);
      const saved = page.waitForEvent('download');
      await page.getByRole('button', { name: 'Rules', exact: true }).click();
      assert.match((await saved).suggestedFilename(), /^robot-0-tick60\.bnf$/);
    },
  ],
  [
    'genome_of_a_machine_shows_its_rules',
    async (open) => {
      const { page, seek } = await open('#/forage?preset=geese');
      await seek(40);
      await page.locator('#canvas').focus();
      await page.keyboard.press('Home');
      await page.locator('#tab-genome').click();
      await page.locator('#panel-genome .machine-rules tbody tr').first().waitFor();
      await page.locator('.codon').nth(3).click();
      await page.locator('#panel-genome .machine-rules tr.chosen').first().waitFor();
    },
  ],
];
