import assert from 'node:assert/strict';
import { violations } from './access.mjs';
import { SMALL, openBench, packed } from './bench.mjs';

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  ...['light', 'dark'].map((colorScheme) => /** @type {import('./browser.mjs').Case} */ ([
    `axe_finds_nothing_in_${colorScheme}_at_the_workbench`,
    async (open) => {
      const { page, at, tab, select, type, problems, step } = await openBench(open, '#/trees', { colorScheme: /** @type {'light' | 'dark'} */ (colorScheme) });
      await at(2);
      assert.deepEqual(await violations(page), [], 'comparison');
      await page.locator('.compare-switch').click();
      await page.locator('#trees-entry').selectOption('entry:subtrees');
      await at(1);
      await step();
      await select('Alone');
      for (const name of /** @type {const} */ (['node', 'script', 'board', 'log'])) {
        await tab(name);
        assert.deepEqual(await violations(page), [], name);
      }
      await type(SMALL.replace('<Near/>', '<Nea/>'));
      await problems('1 fault');
      assert.deepEqual(await violations(page), [], 'fault');
      await page.keyboard.press('Control+f');
      await page.locator('.cm-search').waitFor();
      assert.deepEqual(await violations(page), [], 'find');
    },
  ])),
  ...['light', 'dark'].map((colorScheme) => /** @type {import('./browser.mjs').Case} */ ([
    `axe_finds_nothing_in_${colorScheme}_at_the_workbench_on_a_phone`,
    async (open) => {
      const { page, at } = await openBench(open, '#/trees?preset=guards', { ...PHONE, colorScheme: /** @type {'light' | 'dark'} */ (colorScheme) });
      await at(3);
      assert.deepEqual(await violations(page), [], 'closed');
      await page.locator('#trees .sheet-handle').click();
      await page.locator('#panel-node').waitFor();
      assert.deepEqual(await violations(page), [], 'sheet');
    },
  ])),
  ...[320, 390, 768, 1024].map((width) => /** @type {import('./browser.mjs').Case} */ ([
    `workbench_does_not_scroll_sideways_at_${width}_pixels`,
    async (open) => {
      const { page, at, type, problems } = await openBench(open, '#/trees', { viewport: { width, height: 640 }, hasTouch: true });
      await at(2);
      const sideways = () => page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
      for (const preset of ['three-sequences', 'subtrees', 'building-blocks']) {
        await page.locator('#trees-entry').selectOption(`entry:${preset}`);
        await page.waitForFunction((wanted) => location.hash.includes(wanted), preset);
        if (width < 900) await page.locator('#trees .sheet-handle').click();
        for (const name of ['script', 'board', 'log', 'node']) {
          await page.locator(`#tab-${name}`).click();
          const [scroll, client] = await sideways();
          assert.ok(scroll <= client, `${preset}, ${name}: ${scroll} pixels in a window of ${client}`);
        }
        if (width < 900) await page.locator('#trees .sheet-handle').click();
      }
      await type(SMALL.replaceAll('Near', 'AVeryLongNameThatNobodyWouldEverGiveToANodeOfATreeExceptToSeeWhatHappens'));
      await problems('No problems');
      const [scroll, client] = await sideways();
      assert.ok(scroll <= client, `long name: ${scroll} pixels in a window of ${client}`);
    },
  ])),
  [
    'targets_of_the_workbench_are_large_enough_for_fingers',
    async (open) => {
      const { page, at } = await openBench(open, '#/trees?preset=guards', PHONE);
      await at(3);
      await page.locator('#trees .sheet-handle').click();
      await page.locator('#tab-script').click();
      const small = await page.locator('button:visible, summary:visible, select:visible').evaluateAll((targets) =>
        targets.filter((target) => target.getBoundingClientRect().height < 43.5).map((target) => target.outerHTML.slice(0, 80)),
      );
      assert.deepEqual(small, []);
    },
  ],
  [
    'workbench_is_worked_by_keyboard_alone',
    async (open) => {
      const { page, at, until } = await openBench(open, `#/trees?xml=${packed(SMALL)}`);
      await at(0);
      /** Tabs until the focus is at a place. @param {string} selector */
      const reach = async (selector) => {
        for (let presses = 0; presses < 60; presses += 1) {
          await page.keyboard.press('Tab');
          if (await page.evaluate((wanted) => document.activeElement?.matches(wanted), selector)) return;
        }
        assert.fail(`${selector} is not reached by Tab`);
      };
      await reach('.trees-stage [role=treeitem]');
      await page.keyboard.press('ArrowDown');
      await page.keyboard.press('Enter');
      await page.locator('#panel-node h2').filter({ hasText: 'Near' }).waitFor();
      await page.keyboard.press('f');
      await reach('#trees-entry');
      await reach('.trees-code');
      await page.keyboard.press('Control+End');
      await page.keyboard.type(' ');
      await page.keyboard.press('Escape');
      await until(() => document.activeElement?.matches('.problems-bar button'));
      await page.keyboard.press('.');
      await at(1);
      await until(() => document.querySelector('#trees-root')?.textContent?.includes('FAILURE'));
      await reach('#tab-node');
      await page.keyboard.press('ArrowRight');
      await page.locator('.events').waitFor();
      await reach('.events .quiet');
      await page.keyboard.press('Enter');
      await until(() => document.querySelector('#trees-root')?.textContent?.includes('SUCCESS'));
      await reach('#trees .play');
      await page.keyboard.press('Enter');
      await until(() => document.body.dataset.state === 'running');
      await page.keyboard.press(' ');
      await until(() => document.body.dataset.state === 'paused');
    },
  ],
];
