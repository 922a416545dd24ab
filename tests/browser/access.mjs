import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { eventually } from './browser.mjs';

const axe = readFileSync(fileURLToPath(import.meta.resolve('axe-core')), 'utf8');

/** Violations axe finds, one line each. @param {import('playwright-core').Page} page */
export async function violations(page) {
  await page.evaluate(axe);
  return page.evaluate(async () => {
    const { violations: found } = await /** @type {any} */ (window).axe.run(document, { resultTypes: ['violations'] });
    return found.flatMap((/** @type {any} */ rule) => rule.nodes.map((/** @type {any} */ node) => `${rule.id}: ${node.target.join(' ')}: ${node.failureSummary}`));
  });
}

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  ...['light', 'dark'].map((colorScheme) => /** @type {import('./browser.mjs').Case} */ ([
    `axe_finds_nothing_in_${colorScheme}_on_any_inspector_tab`,
    async (open) => {
      const { page, seek, openGroups } = await open('', { colorScheme: /** @type {'light' | 'dark'} */ (colorScheme) });
      await seek(100);
      await openGroups();
      assert.deepEqual(await violations(page), [], 'everyone');
      await page.locator('#canvas').focus();
      await page.keyboard.press('Home');
      await page.locator('.selected-name').filter({ hasText: 'Robot 0' }).waitFor();
      for (const tab of ['tree', 'agent', 'genome', 'charts']) {
        await page.locator(`#tab-${tab}`).click();
        await page.locator({ tree: '[role=treeitem]', agent: '.facts-list', genome: '.codon[aria-label]', charts: '.uplot' }[tab] ?? '').first().waitFor();
        assert.deepEqual(await violations(page), [], tab);
      }
      await page.locator('[data-action=keys]').click();
      assert.deepEqual(await violations(page), [], 'keys');
    },
  ])),
  [
    'axe_finds_nothing_on_a_phone',
    async (open) => {
      const { page, seek } = await open('', { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
      await seek(100);
      assert.deepEqual(await violations(page), [], 'closed');
      await page.locator('.sheet-handle').click();
      await page.locator('[role=treeitem]').first().waitFor();
      assert.deepEqual(await violations(page), [], 'sheet');
    },
  ],
  ...[320, 390, 768].map((width) => /** @type {import('./browser.mjs').Case} */ ([
    `nothing_scrolls_sideways_at_${width}_pixels`,
    async (open) => {
      const { page, seek, openGroups } = await open('#/forage?nonsense=1', { viewport: { width, height: 640 }, hasTouch: true });
      await seek(50);
      await openGroups();
      await page.locator('#canvas').focus();
      await page.keyboard.press('Home');
      for (const tab of ['tree', 'agent', 'genome', 'charts']) {
        await page.locator(`#tab-${tab}`).click();
        const { scroll, client } = await page.evaluate(() => ({ scroll: document.documentElement.scrollWidth, client: document.documentElement.clientWidth }));
        assert.ok(scroll <= client, `${tab}: ${scroll} pixels in a window of ${client}`);
      }
    },
  ])),
  [
    'targets_are_large_enough_for_fingers',
    async (open) => {
      const { page, seek } = await open('', { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
      await seek(20);
      const small = await page.locator('button:visible, summary:visible, select:visible').evaluateAll((targets) =>
        targets.filter((target) => target.getBoundingClientRect().height < 43.5).map((target) => target.outerHTML.slice(0, 80)),
      );
      assert.deepEqual(small, []);
    },
  ],
  [
    'summary_and_live_region_tell_what_the_canvas_shows',
    async (open) => {
      const { page, seek, inState } = await open();
      await seek(33);
      await eventually(async () => assert.match((await page.locator('#summary').textContent()) ?? '', /^Tick 33\. \d+ of 100 robots carry food\. Delivered \d+ of 100\.$/));
      await page.locator('#play').click();
      await inState('running');
      await page.locator('#play').click();
      await inState('paused');
      await eventually(async () => assert.match((await page.locator('#live').textContent()) ?? '', /^Paused at tick \d+$/));
      assert.equal(await page.locator('[aria-live]').count(), 1);
    },
  ],
  [
    'theme_choice_is_remembered',
    async (open) => {
      const { page, inState } = await open();
      await page.locator('#theme').click();
      await page.locator('#theme').click();
      await eventually(async () => assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), 'dark'));
      await page.reload();
      await inState('paused');
      await eventually(async () => assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), 'rgb(20, 23, 28)'));
    },
  ],
];
